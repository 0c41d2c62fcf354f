"""`minkref sweep P Q`: its options, in the plane, with a disc and in space."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import READ_SCALE, Erode, FirstOperand, Json, SecondOperand, Triangles
from minkref.cli.readings import DISC_CHOICES, FORMS, PLANE_CHOICES, ROUTE
from minkref.cli.readings import SPACE_CHOICES as UPDATE_CHOICES
from minkref.cli.verb import Verb, command_of
from minkref.plane.commands.scale_index import IndexFile
from minkref.plane.commands.sweep_folder import FORMATS, INDEX
from minkref.settings import DISC, PLANE, SPACE
from minkref.verbs.repair_options import REPAIRS, SPACE_CHOICES

EXAMPLES = """Examples:

minkref sweep g1 g2 --from 1/2 --to 2 --steps 16

minkref sweep disc1 cells1815 --from 1 --to 2 --steps 11 -o sums --format svg

minkref sweep P.wkt Q.wkt --scales scales.txt --json

minkref sweep g1 g2 --from 1 --to 2 --steps 9 --route dynamic

minkref sweep g1 g2 --from 1 --to 2 --steps 9 --route winding

minkref sweep P.wkt Q.wkt --scales scalings.txt --route dynamic

minkref sweep g1 g2 --from 1 --to 2 --steps 9 --route paper-update --arithmetic mpfr:200

minkref sweep glyph1204 disc --from 1/10 --to 2 --steps 20

minkref sweep g1 g2 --erode --from 5 --to 20 --steps 16

minkref sweep g1 disc:3/2 --from 1 --to 2 --steps 9 --route paper-update --arithmetic mpfr:53

minkref sweep gs3 rod --scales scalings.txt -o sums --format off

minkref sweep gs3 rod --scales scalings.txt --repair literal --arithmetic mpfr:200

minkref sweep cup.off plate.off --scales scales.txt --route paper-update --arithmetic double"""

TOLD = """\
The sums at many scales: everything between the smallest and the largest scale is found once;
then each sum is read off, or computed from the one before by dynamic update. Exact, in
canonical form; by the paper's own program (--route paper-update, in space --repair literal)
what that answers, with the exact sums beside it. With `disc` as second operand scales are radii
of a disc; with `disc:R`, by the paper's own program, they are factors of R."""

FirstScale = Annotated[
    Fraction | None, typer.Option("--from", help="The first scale.", metavar="A"), READ_SCALE
]
LastScale = Annotated[
    Fraction | None,
    typer.Option("--to", help="The last scale; it may be smaller than the first.", metavar="B"),
    READ_SCALE,
]
Steps = Annotated[
    int | None,
    typer.Option(
        "--steps",
        help="How many scales, evenly spaced, including the first and the last.",
        metavar="N",
    ),
]
ScalesFile = Annotated[
    Path | None,
    typer.Option(
        "--scales",
        help="Read the scales from a file instead: one per line, in any order; in space SX,SY,SZ, "
        "in the plane of convex operands also SX,SY.",
        metavar="FILE",
    ),
]
Route = Annotated[
    str | None,
    typer.Option(
        "--route",
        help="How the sums are computed: read off an index of all scales (index, the "
        "default), each from the one before by dynamic update of the reduced convolution "
        "(dynamic) or of the full one with its winding numbers (winding), or by the paper's own "
        "program, formula by formula, with the exact sums beside it (paper-update). In space only "
        "the last, of solids of any shape; without it convex ones are repaired (--repair).",
    ),
]
Arithmetic = Annotated[
    str,
    typer.Option(
        "--arithmetic",
        help="Of the route paper-update and of --repair literal: rational, interval, double or "
        "mpfr:BITS.",
        metavar="A",
    ),
]
Form = Annotated[
    str | None,
    typer.Option(
        "--form",
        help=f"With --route {ROUTE} and with --repair literal: all sentences of the paper as "
        "printed (the default) or corrected.",
        metavar="|".join(FORMS),
    ),
]
Reading = Annotated[
    list[str] | None,
    typer.Option(
        "--reading",
        help=f"One formula or sentence of the paper as read, whatever --form says; may be "
        f"repeated. With --route {ROUTE}: {PLANE_CHOICES.names()}; with a disc "
        f"{DISC_CHOICES.names()}; in space {UPDATE_CHOICES.names()}. With --repair literal: "
        f"{SPACE_CHOICES.names()}.",
        metavar="NAME=VALUE",
    ),
]
Repair = Annotated[
    str | None,
    typer.Option(
        "--repair",
        help="In space: how the sum is repaired after a scaling, by the proven update (proven, "
        "the default), or by the paper's own text with the exact sums beside it (literal).",
        metavar="|".join(REPAIRS),
    ),
]
Trace = Annotated[
    bool,
    typer.Option(
        "--trace",
        help="With --repair literal: the errors, their degrees and witnesses, and the steps of "
        "each descent.",
    ),
]
Output = Annotated[
    Path | None,
    typer.Option("-o", help=f"Write a file for each scale, and {INDEX}.", metavar="DIR"),
]
Format = Annotated[
    str | None,
    typer.Option("--format", help=f"Format of these files: {', '.join(FORMATS)}. Default: json."),
]


@dataclass(frozen=True)
class SweepInPlane:
    P: FirstOperand
    Q: SecondOperand
    from_scale: FirstScale = None
    to_scale: LastScale = None
    steps: Steps = None
    scales_file: ScalesFile = None
    route: Route = None
    arithmetic: Arithmetic = "rational"
    as_read: Form = None
    reading: Reading = None
    index: IndexFile = None
    output: Output = None
    form: Format = None
    erode: Erode = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class SweepInSpace:
    P: FirstOperand
    Q: SecondOperand
    scales_file: ScalesFile = None
    route: Route = None
    arithmetic: Arithmetic = "rational"
    as_read: Form = None
    reading: Reading = None
    repair: Repair = None
    trace: Trace = False
    output: Output = None
    form: Format = None
    triangles: Triangles = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class SweepWithDisc:
    P: FirstOperand
    Q: SecondOperand
    from_scale: FirstScale = None
    to_scale: LastScale = None
    steps: Steps = None
    scales_file: ScalesFile = None
    route: Route = None
    arithmetic: Arithmetic = "rational"
    as_read: Form = None
    reading: Reading = None
    index: IndexFile = None
    output: Output = None
    form: Format = None
    erode: Erode = False
    memory: Memory = None
    json: Json = False


LITERAL = f"give polyhedra; here there is --route {ROUTE}"
SCALINGS = "give --scales FILE with SX,SY,SZ (or S) in each line"
command = command_of(
    "sweep",
    TOLD,
    {
        SPACE: Verb(
            SweepInSpace,
            "minkref.space.commands.sweep:run",
            instead=dict.fromkeys(("--from", "--to", "--steps"), SCALINGS),
        ),
        PLANE: Verb(
            SweepInPlane,
            "minkref.plane.commands.sweep:run",
            why=dict.fromkeys(("--repair", "--trace"), "a sum in the plane has no repair"),
            instead=dict.fromkeys(("--repair", "--trace"), LITERAL),
        ),
        DISC: Verb(SweepWithDisc, "minkref.disc.commands.sweep:run"),
    },
)
