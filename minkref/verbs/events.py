"""`minkref events P Q`: its options, in the plane, with a disc and in space."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer
from minkref.arithmetic import check_arithmetic
from minkref.cli.memory import Memory
from minkref.cli.options import Erode, FirstOperand, GreatestScale, Json, LeastScale, SecondOperand
from minkref.cli.readings import DISC_EVENT_CHOICES, FACET_CHOICES, PLANE_CHOICES
from minkref.cli.verb import Verb, command_of
from minkref.errors import Refusal, choice
from minkref.plane.commands.event_output import FORMATS
from minkref.plane.commands.scale_index import IndexFile
from minkref.plane.event_values import FORMS, PAIR_KINDS
from minkref.settings import DISC, PLANE, SPACE

EXAMPLES = """Examples:

minkref events disc1 cells1815

minkref events g1 g2 --from 1/2 --to 2 --json

minkref events glyph1204 glyph275 -o events.parquet

minkref events g1 g2 --kind arrangement --from 1 --to 3/2 -o events.json

minkref events disc1 cells1815 --kind topology --from 1/10 --to 10 --route index

minkref events g1 g2 --kind arrangement --where 'kind = triple and s > 7/5 and change = swap'

minkref events g1 g2 --where 'x in [0, 5] and y > 1/3 and parents has S 0.4' -o - --format jsonl

minkref events g1 g2 --kind topology --where 'feature = hole and not change in (birth, death)'

minkref events g1 g2 --kind arrangement --route winding --to 3

minkref events g1 g2 --form printed --arithmetic mpfr:53

minkref events P.off Q.off --from 1/5 --to 2 -o events.jsonl

minkref events P.off Q.off --from 1/5 --to 2 --form printed --reading corner=itself

minkref events g1 disc --kind topology

minkref events g1 disc --erode --kind topology

minkref events g1 g2 --erode --kind topology --to 20

minkref events g1 disc --kind pair --to 5

minkref events g1 disc:3/2 --kind pair --reading radical=printed"""

TOLD = """\
All scales at which edges of the reduced convolution, or of the full one (--route winding),
start or stop meeting: exact, sorted. In space, where P and Q are polyhedra, those at which two
of its facets start, change or stop to meet in a window. With `disc` for Q, the radii at which
the sum with a disc changes, or, of the kind pair, at which two offset edges or arcs start or
stop to meet."""

Kind = Annotated[
    str | None,
    typer.Option(
        "--kind",
        help="pair: two edges of the convolution start or stop meeting. "
        "parallel: two parallel edges lie on one line at that scale. "
        "triple: three edges pass through one point. "
        "arrangement: all three. "
        "In space these are of facets: pair of two, triple of three and of four. "
        "boundary: the vertices of the sum's boundary or their order change. "
        "topology: a hole or component is born, dies, merges, splits or touches itself. "
        "Default: pair; with --index, and with a disc, boundary.",
    ),
]
PaperForm = Annotated[
    str, typer.Option("--form", help="corrected, or printed: the paper's own rule, often wrong.")
]
Arithmetic = Annotated[
    str,
    typer.Option(
        "--arithmetic",
        help="rational (exact), interval, double or mpfr:BITS. With all but the first, and "
        "with --reading, the paper's program is followed: its events are listed with the exact "
        "scales beside them, and how its method fares is counted.",
    ),
]
OneReading = Annotated[
    list[str] | None,
    typer.Option(
        "--reading",
        help="Follow the paper's program, with one formula as read whatever --form says; may "
        f"be repeated. {PLANE_CHOICES.names()}. In space (Sections 5.1 and 5.2): "
        f"{FACET_CHOICES.names()}. With a disc, of the kind pair: one sentence of the Appendix, "
        f"exact: {DISC_EVENT_CHOICES.names()}.",
        metavar="NAME=VALUE",
    ),
]
Least = Annotated[
    bool,
    typer.Option(
        "--least-precision",
        help="Also find the fewest bits of mpfr at which the paper's method gets every event "
        "right (slow).",
    ),
]
Route = Annotated[
    str | None,
    typer.Option(
        "--route",
        help="How events are found: dynamic (the default), from the arrangement of the reduced "
        "convolution, or winding, from that of the full convolution, whose winding numbers tell "
        "the sum; boundary and topology events also by index, from the boundary of the swept "
        "sum, which is faster for large operands.",
    ),
]
Where = Annotated[
    str | None,
    typer.Option(
        "--where",
        help="List only the events that meet a condition: 's > 7/5 and change = birth', "
        "'1 < s <= 2', 'x in [0, 5] and y in (-1, 1)', 'parents has S 0.4 at 0.7', 'rank < 9'; "
        "of topology events also 'feature = hole', 'before has 3', 'parts > 1'. With `and`, "
        "`or`, `not`. Exact.",
        metavar="CONDITION",
    ),
]
Limit = Annotated[
    int | None,
    typer.Option("--limit", help="List only the first N events; all are counted.", metavar="N"),
]
Output = Annotated[
    Path | None,
    typer.Option(
        "-o",
        help="Write the events to this file: .json, .jsonl (one event per line) or .parquet; "
        "- is standard output.",
        metavar="FILE",
    ),
]
FileFormat = Annotated[
    str | None,
    typer.Option(
        "--format", help=f"Format of the file: {', '.join(FORMATS)}. Default: by its ending."
    ),
]


@dataclass(frozen=True)
class EventsInPlane:
    P: FirstOperand
    Q: SecondOperand
    from_scale: LeastScale = None
    to_scale: GreatestScale = None
    kind: Kind = None
    form: PaperForm = "corrected"
    arithmetic: Arithmetic = "rational"
    reading: OneReading = None
    least: Least = False
    route: Route = None
    index: IndexFile = None
    where: Where = None
    limit: Limit = None
    output: Output = None
    file_format: FileFormat = None
    erode: Erode = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class EventsInSpace:
    P: FirstOperand
    Q: SecondOperand
    from_scale: LeastScale = None
    to_scale: GreatestScale = None
    kind: Kind = None
    form: PaperForm = "corrected"
    arithmetic: Arithmetic = "rational"
    reading: OneReading = None
    limit: Limit = None
    output: Output = None
    file_format: FileFormat = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class EventsWithDisc:
    P: FirstOperand
    Q: SecondOperand
    from_scale: LeastScale = None
    to_scale: GreatestScale = None
    kind: Kind = None
    form: PaperForm = "corrected"
    reading: OneReading = None
    route: Route = None
    index: IndexFile = None
    limit: Limit = None
    output: Output = None
    file_format: FileFormat = None
    erode: Erode = False
    memory: Memory = None
    json: Json = False


command = command_of(
    "events",
    TOLD,
    {
        PLANE: Verb(EventsInPlane, "minkref.plane.commands.events:run"),
        SPACE: Verb(EventsInSpace, "minkref.space.commands.events:run"),
        DISC: Verb(EventsWithDisc, "minkref.disc.commands.events:run"),
    },
)


def check_form(form: str) -> None:
    """Refuses an unknown form."""
    if form not in FORMS:
        raise Refusal(f"there is no form {form!r}", "--form", choice(form, FORMS))


def check_limit(limit: int | None) -> None:
    """Refuses a limit below 0."""
    if limit is not None and limit < 0:
        raise Refusal("the limit is negative", f"--limit {limit}", "give 0 or more")


def check_paper(kind: str, form: str, arithmetic: str) -> None:
    """Refuses what the paper does not have for the kind."""
    check_form(form)
    check_arithmetic(arithmetic)
    mend = "leave out one of the two options"
    if arithmetic != "rational" and kind != "pair":
        where = f"--kind {kind} --arithmetic {arithmetic}"
        raise Refusal("other arithmetics are tried on pair events", where, mend)
    if form != "corrected" and kind not in PAIR_KINDS:
        what = "the printed form has pair and parallel events only"
        raise Refusal(what, f"--kind {kind} --form {form}", mend)
