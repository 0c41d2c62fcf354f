"""`minkref sweep P Q`: the sums at many scales, each got from the one before."""

from __future__ import annotations

import sys
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from minkref import _core
from minkref.cli.arithmetic import check_arithmetic
from minkref.cli.memory import SMALLER, Memory, memory_wall
from minkref.cli.options import (
    FirstOperand,
    Json,
    Schema,
    SecondOperand,
    Triangles,
    refuse_triangles,
)
from minkref.cli.output import plain_table
from minkref.cli.paper_words import events_in_words, in_words
from minkref.cli.progress import progress
from minkref.cli.readings import FORMS, PLANE_CHOICES, ROUTE, readings_of, refuse_options
from minkref.cli.row_spool import Row, RowSpool
from minkref.disc.disc import is_disc
from minkref.errors import Refusal, refusing
from minkref.exact import read_scale, rounded
from minkref.output.documents import Stopwatch, document, listing
from minkref.output.signals import ending_in_order
from minkref.output.terminal import counted, escaped
from minkref.plane.commands.scale_index import IndexFile, chosen_route, index_of
from minkref.plane.commands.sum_fields import sum_fields
from minkref.plane.commands.sweep_folder import FORMATS, INDEX, sweep_folder
from minkref.plane.commands.sweep_rows import SHOWN, Setting, print_sweep, sweep_rows, write_index
from minkref.plane.operand import Operand, read_operand
from minkref.plane.scales import MOST_SCALES, evenly_spaced, read_scales
from minkref.space.operand import in_space
from minkref.verbs.repair_options import REPAIRS, SPACE_CHOICES, asked_repair

if TYPE_CHECKING:
    from minkref.verbs.paper_update import PaperWalk

EXAMPLES = """Examples:

minkref sweep g1 g2 --from 1/2 --to 2 --steps 16

minkref sweep disc1 cells1815 --from 1 --to 2 --steps 11 -o sums --format svg

minkref sweep P.wkt Q.wkt --scales scales.txt --json

minkref sweep g1 g2 --from 1 --to 2 --steps 9 --route dynamic

minkref sweep g1 g2 --from 1 --to 2 --steps 9 --route paper-update --arithmetic mpfr:200

minkref sweep glyph1204 disc --from 1/10 --to 2 --steps 20

minkref sweep gs3 rod --scales scalings.txt -o sums --format off

minkref sweep gs3 rod --scales scalings.txt --repair literal --arithmetic mpfr:200"""

ROUTES = ("index", "dynamic", ROUTE)

Sums = _core.ScaleIndex | _core.DynamicSum
PLANE = Setting[str, _core.PolygonSet](
    lambda scale: escaped(scale)[:20], _core.write, _core.writes_exactly
)


def command(
    P: FirstOperand,
    Q: SecondOperand,
    from_scale: Annotated[
        str | None, typer.Option("--from", help="The first scale.", metavar="A")
    ] = None,
    to_scale: Annotated[
        str | None,
        typer.Option("--to", help="The last scale; it may be smaller than the first.", metavar="B"),
    ] = None,
    steps: Annotated[
        int | None,
        typer.Option(
            "--steps",
            help="How many scales, evenly spaced, including the first and the last.",
            metavar="N",
        ),
    ] = None,
    scales_file: Annotated[
        Path | None,
        typer.Option(
            "--scales",
            help="Read the scales from a file instead: one per line, in any order; in space "
            "SX,SY,SZ.",
            metavar="FILE",
        ),
    ] = None,
    route: Annotated[
        str | None,
        typer.Option(
            "--route",
            help="How the sums are computed: read off an index of all scales (index, the "
            "default), each from the one before by dynamic update (dynamic), or by the paper's own "
            "program, formula by formula, with the exact sums beside it (paper-update).",
        ),
    ] = None,
    arithmetic: Annotated[
        str,
        typer.Option(
            "--arithmetic",
            help="Of the route paper-update and of --repair literal: rational, interval, double or "
            "mpfr:BITS.",
            metavar="A",
        ),
    ] = "rational",
    as_read: Annotated[
        str | None,
        typer.Option(
            "--form",
            help=f"With --route {ROUTE} and with --repair literal: all sentences of the paper as "
            "printed (the default) or corrected.",
            metavar="|".join(FORMS),
        ),
    ] = None,
    reading: Annotated[
        list[str] | None,
        typer.Option(
            "--reading",
            help=f"One formula or sentence of the paper as read, whatever --form says; may be "
            f"repeated. With --route {ROUTE}: {PLANE_CHOICES.names()}. With --repair literal: "
            f"{SPACE_CHOICES.names()}.",
            metavar="NAME=VALUE",
        ),
    ] = None,
    repair: Annotated[
        str | None,
        typer.Option(
            "--repair",
            help="In space: how the sum is repaired after a scaling, by the proven update (proven, "
            "the default), or by the paper's own text with the exact sums beside it (literal).",
            metavar="|".join(REPAIRS),
        ),
    ] = None,
    trace: Annotated[
        bool,
        typer.Option(
            "--trace",
            help="With --repair literal: the errors, their degrees and witnesses, and the steps of "
            "each descent.",
        ),
    ] = False,
    index: IndexFile = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", help=f"Write a file for each scale, and {INDEX}.", metavar="DIR"),
    ] = None,
    form: Annotated[
        str | None,
        typer.Option(
            "--format", help=f"Format of these files: {', '.join(FORMATS)}. Default: json."
        ),
    ] = None,
    triangles: Triangles = False,
    memory: Memory = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """The sums at many scales: everything between the smallest and the largest scale is found once;
    then each sum is read off, or computed from the one before by dynamic update. Exact, in
    canonical form; by the paper's own program (--route paper-update, in space --repair literal)
    what that answers, with the exact sums beside it. With `disc` as second operand scales are radii
    of a disc."""
    if is_disc(P) or is_disc(Q):
        from minkref.disc.commands.sweep import sweep_with_disc

        radii = _scales(from_scale, to_scale, steps, scales_file)
        named: dict[str, object] = {
            "--route": route if route != "index" else None,
            "--form": as_read,
            "--reading": reading,
            "--repair": repair,
        }
        unknown = {option: value is not None for option, value in named.items()}
        unknown |= {"--arithmetic": arithmetic != "rational", "--trace": trace}
        unknown |= {"--triangles": triangles}
        sweep_with_disc(P, Q, radii, index, unknown, output, form, json, memory)
        return
    if in_space(P, Q):
        given = _given(from_scale, to_scale, steps)
        named = {"--route": route, "--index": index}
        given += [option for option, value in named.items() if value is not None]
        from minkref.space.commands.sweep import sweep_in_space

        asked = asked_repair(repair, arithmetic, as_read, reading, trace)
        sweep_in_space(P, Q, scales_file, given, output, form, json, memory, asked, triangles)
        return
    refuse_triangles(triangles)
    if repair is not None or trace:
        option = "--trace" if repair is None else "--repair"
        what = "a sum in the plane has no repair"
        raise Refusal(
            what, option, f"leave it out, or give polyhedra; here there is --route {ROUTE}"
        )
    watch = Stopwatch()
    route = chosen_route(index, route, ROUTES)
    refuse_options(route, as_read, reading)
    check_arithmetic(arithmetic)
    if arithmetic != "rational" and route != ROUTE:
        what = f"the route {route} is exact only"
        raise Refusal(what, f"--arithmetic {arithmetic}", f"add --route {ROUTE}, or leave it out")
    readings = readings_of(as_read, reading) if route == ROUTE else None
    scales = _scales(from_scale, to_scale, steps, scales_file)
    folder = sweep_folder(output, form, FORMATS)
    first, second = read_operand(P), read_operand(Q)
    if folder is not None:
        folder.refuse_overwriting([first.file, second.file, *([index] if index else [])])
    wall = memory_wall(memory, f"route {route}", f"{P} and {Q}", SMALLER)
    with wall, ending_in_order(), progress(len(scales)) as line:
        line.now("finding all events")
        sums: Sums | PaperWalk
        walk: PaperWalk | None = None
        one: Callable[[str], tuple[Row, _core.PolygonSet]]
        if readings is not None:
            from minkref.verbs.paper_update import paper_walk

            sums = walk = paper_walk(first, second, scales[0], arithmetic, readings)
            one = walk.row
        else:
            sums = exact = _sums(first, second, scales, route, index)
            one = partial(step, exact)
        rows = sweep_rows(scales, one, PLANE, folder, line)
        value = document(
            "sweep",
            watch,
            P=first.name,
            Q=second.name,
            warnings=first.warnings + second.warnings,
            output=str(output) if output else None,
            format=folder.form if folder else None,
            route=route,
            arithmetic=arithmetic,
            readings=readings,
            first_wrong=_first_wrong(rows),
            events=walk.events() if walk is not None else None,
            preprocessing_seconds=sums.seconds,
            statistics=dict(sums.counts()),
        )
        write_index(folder, value, rows)
    if json:
        sys.stdout.writelines(listing(value, "rows", rows))
    else:
        _print(value, rows)


def _sums(P: Operand, Q: Operand, scales: list[str], route: str, index: Path | None) -> Sums:
    """All events of the least window that holds the scales; no sum is asked for yet."""
    least, greatest = min(scales, key=Fraction), max(scales, key=Fraction)
    if route == "index":
        return index_of(index, P, Q, least, greatest)
    return refusing(
        f"{P.name} and {Q.name}", lambda: _core.DynamicSum(P.set, Q.set, least, greatest)
    )


def step(sums: Sums, scale: str) -> tuple[Row, _core.PolygonSet]:
    """Goes to a scale: what the step did where there is one, and the sum there."""
    if isinstance(sums, _core.DynamicSum):
        did = dict(sums.move_to(scale))
        answer = sums.sum()
    else:
        did = {}
        answer = sums.sum(scale)
    row: Row = {
        "scale": scale,
        **sum_fields(answer),
        "insertions": did.get("insertions"),
        "deletions": did.get("deletions"),
        "swaps": did.get("swaps"),
        "updated": did.get("updated"),
        "event_scales": did.get("groups"),
        "update_seconds": did.get("seconds"),
        "sum_seconds": answer.seconds,
        "exact": None,
    }
    return row, answer.region


def _given(first: str | None, last: str | None, steps: int | None) -> list[str]:
    options = (("--from", first), ("--to", last), ("--steps", steps))
    return [option for option, value in options if value is not None]


def _scales(first: str | None, last: str | None, steps: int | None, file: Path | None) -> list[str]:
    given = _given(first, last, steps)
    if file is not None:
        if given:
            raise Refusal(
                "the scales are given twice",
                f"--scales and {', '.join(given)}",
                "leave out --scales, or --from, --to and --steps",
            )
        return read_scales(file)
    if first is None or steps is None or (last is None and steps != 1):
        needed = (("--from", first), ("--to", last), ("--steps", steps))
        missing = ", ".join(option for option, value in needed if value is None)
        raise Refusal(
            f"the scales are not given: {missing} missing",
            f"minkref sweep {' '.join(given)}".rstrip(),
            "give --from A --to B --steps N, or --scales FILE",
        )
    if not 1 <= steps <= MOST_SCALES:
        raise Refusal(
            f"there must be 1 to {MOST_SCALES:,} scales", f"--steps {steps}", "choose another N"
        )
    begin = read_scale(first, "--from")
    end = read_scale(last, "--to") if last is not None else begin
    return evenly_spaced(begin, end, steps)


def _print(value: dict[str, Any], rows: RowSpool) -> None:
    steps = ("insertions", "deletions", "swaps", "updated") if value["route"] == "dynamic" else ()
    headings = ("scale", "area", "components", "holes", "vertices", *steps, "ms")
    beside = ("exact",) if value["route"] == ROUTE else ()
    table = plain_table(*headings, *beside, right=headings, whole=True)
    for row in rows.first(SHOWN):
        counts = (row[name] for name in ("components", "holes", "vertices"))
        did = (row[name] for name in steps)
        seconds = (row["update_seconds"] or 0) + row["sum_seconds"]
        table.add_row(
            _short(row["scale"]),
            _short(row["area"]),
            *(f"{count:,}" for count in (*counts, *did)),
            f"{seconds * 1000:.3f}",
            *([in_words(row["exact"])] if beside else []),
        )
    summary = [
        ("sweep", f"{value['P']} + {value['Q']}, {counted(len(rows), 'scale')}"),
        ("route", value["route"]),
        *([("first wrong", value["first_wrong"] or "nowhere")] if beside else []),
        *(events_in_words(value["events"]) if beside else []),
        ("all events", f"{value['preprocessing_seconds']:.3f} s"),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_sweep(table, rows, summary, value)


def _first_wrong(rows: RowSpool) -> str | None:
    """The first scale of the sweep at which the paper's program has another structure."""
    wrong = (row["scale"] for row in rows if row["exact"] and not row["exact"]["same_structure"])
    return next(wrong, None)


def _short(number: str) -> str:
    return number if len(number) <= 12 else rounded(number)
