"""`minkref sweep P disc`: sums with a disc at many radii, read off an index of all radii."""

from __future__ import annotations

import sys
from dataclasses import replace
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.certain_digits import between, root
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import plain_table
from minkref.cli.paper_words import events_in_words, in_words
from minkref.cli.progress import progress
from minkref.cli.readings import ROUTE
from minkref.cli.row_spool import Row, RowSpool
from minkref.disc.commands.index_file import disc_index_of
from minkref.disc.commands.sum import enclosed
from minkref.disc.disc import ANY, Disc, read_disc
from minkref.disc.eroded import eroded_by_disc
from minkref.errors import Refusal
from minkref.exact import digest, exact_scale
from minkref.output.documents import Stopwatch, document, listing
from minkref.output.signals import ending_in_order
from minkref.output.terminal import counted
from minkref.plane.commands.sweep_folder import sweep_folder
from minkref.plane.commands.sweep_rows import (
    SHOWN,
    Setting,
    first_wrong,
    print_sweep,
    sweep_rows,
    write_index,
)
from minkref.plane.operand import read_operand
from minkref.plane.scales import asked_scales
from minkref.verbs.sweep import SweepWithDisc

FORMATS = ("json", "svg")
EXACT = "rational"


def run(request: SweepWithDisc) -> None:
    watch = Stopwatch()
    P, Q, output, index_file = request.P, request.Q, request.output, request.index
    if request.route == ROUTE or request.as_read or request.reading or request.arithmetic != EXACT:
        _run_paper(request, watch)
        return
    if Q != ANY or P == ANY:
        mend = "give `minkref sweep P disc`, and the radii by --from, --to and --steps or --scales"
        raise Refusal("the radii of a sweep are not those of an operand", f"{P} {Q}", mend)
    if request.route not in (None, "index"):
        what = "sums with a disc are read off an index alone"
        raise Refusal(what, "--route", "leave it out")
    radii = asked_scales(
        request.from_scale, request.to_scale, request.steps, request.scales_file, exact_scale
    )
    folder = sweep_folder(output, request.form, FORMATS)
    operand = read_operand(P)
    if folder is not None:
        folder.refuse_overwriting([operand.file, *([index_file] if index_file else [])])
    wall = memory_wall(request.memory, "the index of all radii", P, SMALLER)
    with wall, ending_in_order(), progress(len(radii)) as line:
        line.now("finding all events" if index_file is None else "proving all events again")
        around = operand
        if request.erode:
            around = replace(operand, set=eroded_by_disc(operand.set, operand.name).set)
        index = disc_index_of(index_file, around)
        setting = Setting[Fraction, tuple[Fraction, str]](
            lambda radius: str(radius)[:20],
            lambda found, kind: _text(operand.set, *found, kind, request.erode),
            lambda found, kind: kind == "json",
        )

        def one(radius: Fraction) -> tuple[Row, tuple[Fraction, str]]:
            if request.erode:
                return _eroded_row(operand.set, index, radius)
            return _row(index, radius)

        rows = sweep_rows(radii, one, setting, folder, line)
        value = document(
            "sweep",
            watch,
            P=operand.name,
            Q=Q,
            erode=request.erode,
            warnings=operand.warnings,
            output=str(output) if output else None,
            format=folder.form if folder else None,
            route="index",
            arithmetic=EXACT,
            readings=None,
            first_wrong=None,
            events=None,
            preprocessing_seconds=index.seconds,
            statistics={
                "radii_of_events": len(index),
                "parts_of_the_diagram": index.parts,
                "exact_signs": index.exact_signs,
            },
        )
        write_index(folder, value, rows)
    if request.json:
        sys.stdout.writelines(listing(value, "rows", rows))
    else:
        _print(value, rows)


def _run_paper(request: SweepWithDisc, watch: Stopwatch) -> None:
    """The answers of the Appendix's own program, with the exact sums beside them."""
    from minkref.disc.commands.paper_update import DiscWalk, disc_readings
    from minkref.verbs.paper_update import decided

    P, Q, output = request.P, request.Q, request.output
    if request.erode:
        what = "the Appendix's program has no erosion"
        raise Refusal(what, "--erode", "leave it out, or what asks for the program")
    route = request.route or "index"
    readings = disc_readings(route, request.arithmetic, request.as_read, request.reading)
    assert readings is not None
    if request.index is not None:
        raise Refusal(f"the route {ROUTE} uses no index", "--index", "leave it out")
    unit = Disc(Q, Fraction(1)) if Q == ANY else read_disc(Q)
    scales = asked_scales(
        request.from_scale, request.to_scale, request.steps, request.scales_file, exact_scale
    )
    folder = sweep_folder(output, request.form, ("json",))
    operand = read_operand(P)
    if folder is not None:
        folder.refuse_overwriting([operand.file])
    wall = memory_wall(request.memory, f"route {ROUTE}", P, SMALLER)
    with wall, ending_in_order(), progress(len(scales)) as line:
        line.now("finding all events")
        first = unit.scaled(scales[0])
        walk = decided(
            lambda: DiscWalk(operand, operand.set, unit, first, request.arithmetic, readings)
        )
        setting = Setting[Fraction, str](
            lambda scale: str(scale)[:20], lambda found, kind: found + "\n", lambda *_: True
        )
        rows = sweep_rows(scales, walk.row, setting, folder, line)
        value = document(
            "sweep",
            watch,
            P=operand.name,
            Q=Q,
            erode=False,
            warnings=operand.warnings,
            output=str(output) if output else None,
            format=folder.form if folder else None,
            route=route,
            arithmetic=request.arithmetic,
            readings=readings,
            first_wrong=first_wrong(rows),
            events=walk.events(),
            preprocessing_seconds=walk.seconds,
            statistics=walk.counts(),
        )
        write_index(folder, value, rows)
    if request.json:
        sys.stdout.writelines(listing(value, "rows", rows))
    else:
        _print_paper(value, rows)


def _print_paper(value: dict[str, Any], rows: RowSpool) -> None:
    headings = ("scale", "components", "holes", "curves", "ms")
    table = plain_table(*headings, "exact", right=headings, whole=True)
    for row in rows.first(SHOWN):
        table.add_row(
            row["scale"],
            *(f"{row[name]:,}" for name in ("components", "holes", "curves")),
            f"{(row['update_seconds'] + row['sum_seconds']) * 1000:.3f}",
            in_words(row["exact"]),
        )
    summary = [
        ("sweep", f"{value['P']} + {value['Q']}, {counted(len(rows), 'scale')}"),
        ("route, arithmetic", f"{value['route']}, {value['arithmetic']}"),
        ("first wrong", value["first_wrong"] or "nowhere"),
        *events_in_words(value["events"]),
        ("all events", f"{value['preprocessing_seconds']:.3f} s"),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_sweep(table, rows, summary, value)


def _row(index: _core.DiscIndex, radius: Fraction) -> tuple[Row, tuple[Fraction, str]]:
    """The row that is read off at a radius; the radius and the canonical form."""
    watch = Stopwatch()
    square = str(radius**2)
    canonical = index.canonical_json(square)
    components, holes = index.counts(square)
    area, length = index.measures(square)
    seconds = watch.seconds()
    return {
        "radius": str(radius),
        "digest": digest(canonical),
        "components": components,
        "holes": holes,
        "curves": canonical.count('["'),
        "area": enclosed(area),
        "length": enclosed(length),
        "at_event": index.at_event(square),
        "sum_seconds": seconds,
    }, (radius, canonical)


def _eroded_row(
    P: _core.PolygonSet, index: _core.DiscIndex, radius: Fraction
) -> tuple[Row, tuple[Fraction, str]]:
    """The row of the inset, which is found for each radius; events are in the index."""
    watch, square = Stopwatch(), str(radius**2)
    found = _core.inset(P, square)
    canonical = found.canonical_json()
    return {
        "radius": str(radius),
        "digest": digest(canonical),
        "components": found.components,
        "holes": found.holes,
        "curves": found.curves,
        "area": enclosed(found.area),
        "length": enclosed(found.length),
        "at_event": index.at_event(square),
        "sum_seconds": watch.seconds(),
    }, (radius, canonical)


def _text(P: _core.PolygonSet, radius: Fraction, canonical: str, form: str, erode: bool) -> str:
    if form == "json":
        return canonical + "\n"
    from minkref.offset_picture import offset_picture

    if erode:
        caption = f"the erosion by a disc of radius {root(radius**2, 6)}"
        return offset_picture(_core.inset(P, str(radius**2)), P, caption, beneath=True)
    found = _core.offset(P, str(radius**2))
    return offset_picture(found, P, f"the sum with a disc of radius {root(radius**2, 6)}")


def _print(value: dict[str, Any], rows: RowSpool) -> None:
    headings = ("radius", "area", "components", "holes", "curves", "ms")
    table = plain_table(*headings, "event", right=headings, whole=True)
    for row in rows.first(SHOWN):
        table.add_row(
            row["radius"] if len(row["radius"]) <= 12 else root(Fraction(row["radius"]) ** 2, 10),
            between(**row["area"], digits=9),
            *(f"{row[name]:,}" for name in ("components", "holes", "curves")),
            f"{row['sum_seconds'] * 1000:.3f}",
            "at it" if row["at_event"] else "",
        )
    summary = [
        (
            "sweep",
            f"{value['P']} {'less' if value['erode'] else '+'} disc, "
            f"{'1 radius' if len(rows) == 1 else f'{len(rows):,} radii'}",
        ),
        ("radii of events", f"{value['statistics']['radii_of_events']:,}"),
        ("all events", f"{value['preprocessing_seconds']:.3f} s"),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_sweep(table, rows, summary, value)
