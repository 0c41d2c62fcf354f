"""`minkref sweep P Q` in the plane: the sums at many scales, each got from the one before."""

from __future__ import annotations

import sys
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from minkref import _core
from minkref.arithmetic import check_arithmetic
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import plain_table
from minkref.cli.paper_words import events_in_words, in_words
from minkref.cli.progress import progress
from minkref.cli.readings import ROUTE, readings_of, refuse_options
from minkref.cli.row_spool import Row, RowSpool
from minkref.errors import Refusal, refusing
from minkref.exact import rounded
from minkref.output.documents import Stopwatch, document, listing
from minkref.output.signals import ending_in_order
from minkref.output.terminal import counted
from minkref.plane.commands.convex_walk import COUNTS, ConvexWalk
from minkref.plane.commands.scale_index import chosen_route, index_of
from minkref.plane.commands.sum_fields import set_fields, sum_fields
from minkref.plane.commands.sweep_folder import FORMATS, sweep_folder
from minkref.plane.commands.sweep_rows import (
    SHOWN,
    Setting,
    first_wrong,
    print_sweep,
    sweep_rows,
    write_index,
)
from minkref.plane.eroded import ErodingPair, eroding_pair, refuse_others
from minkref.plane.operand import Operand, read_operand
from minkref.plane.scales import asked_scales
from minkref.plane.scaling import PlaneScale, read_plane_scale, shown_scale, text_of
from minkref.verbs.sweep import SweepInPlane

if TYPE_CHECKING:
    from minkref.verbs.paper_update import PaperWalk

BY_AXES = "dynamic"  # the route that takes a factor for each axis
UPDATING = (BY_AXES, "winding")  # follow the reduced and the full convolution
ROUTES = ("index", *UPDATING, ROUTE)
ERODING = ("index", *UPDATING)

Sums = _core.ScaleIndex | _core.DynamicSum
Step = Callable[[PlaneScale], tuple[Row, _core.PolygonSet]]
PLANE = Setting[PlaneScale, _core.PolygonSet](
    lambda scale: text_of(scale)[:30], _core.write, _core.writes_exactly
)
STEPS = (("insertions", "deletions", "swaps", "updated"), COUNTS)  # what an update tells of itself


def run(request: SweepInPlane) -> None:
    watch = Stopwatch()
    output, index = request.output, request.index
    scales = _scales(request)
    by_axes = any(isinstance(scale, tuple) for scale in scales)
    route = chosen_route(index, request.route, ROUTES, BY_AXES if by_axes else None)
    if by_axes and (route != BY_AXES or request.erode):
        raise _refused_route(route, request)
    readings = _readings(request, route)
    refuse_others(request.erode, route, ERODING)
    folder = sweep_folder(output, request.form, FORMATS)
    lines = not request.erode and route != ROUTE
    first, second = read_operand(request.P, lines), read_operand(request.Q, lines)
    if folder is not None:
        folder.refuse_overwriting([first.file, second.file, *([index] if index else [])])
    wall = memory_wall(request.memory, f"route {route}", f"{request.P} and {request.Q}", SMALLER)
    with wall, ending_in_order(), progress(len(scales)) as line:
        line.now("finding all events")
        sums: Sums | PaperWalk | ConvexWalk
        walk: PaperWalk | None = None
        one: Step
        if readings is not None:
            from minkref.verbs.paper_update import paper_walk

            start = text_of(scales[0])
            sums = walk = paper_walk(first, second, start, request.arithmetic, readings)
            one = _walked(walk)
        elif by_axes:
            sums = convex = ConvexWalk(first, second, scales[0])
            one = convex.row
        else:
            uniform = [scale for scale in scales if isinstance(scale, Fraction)]
            eroding = eroding_pair(first, second) if request.erode else None
            sums = exact = _sums(first, second, uniform, route, index, eroding)
            one = partial(step, exact, eroding=eroding)
        rows = sweep_rows(scales, one, PLANE, folder, line)
        value = document(
            "sweep",
            watch,
            P=first.name,
            Q=second.name,
            erode=request.erode,
            warnings=first.warnings + second.warnings,
            output=str(output) if output else None,
            format=folder.form if folder else None,
            route=route,
            arithmetic=request.arithmetic,
            readings=readings,
            first_wrong=first_wrong(rows),
            events=walk.events() if walk is not None else None,
            preprocessing_seconds=sums.seconds,
            statistics=dict(sums.counts()),
        )
        write_index(folder, value, rows)
    if request.json:
        sys.stdout.writelines(listing(value, "rows", rows))
    else:
        _print(value, rows)


def _scales(request: SweepInPlane) -> list[PlaneScale]:
    given = (request.from_scale, request.to_scale, request.steps, request.scales_file)
    return [*asked_scales(*given, read_plane_scale)]


def _refused_route(route: str, request: SweepInPlane) -> Refusal:
    where = f"--index {request.index}" if request.index is not None else f"--route {route}"
    if request.erode:
        what, mend = (
            "erosions at many scales have uniform ones only",
            "write one factor in each line",
        )
        where = f"--erode --scales {request.scales_file}"
        return Refusal(what, where, mend, "scale-not-uniform")
    return Refusal(
        f"the route {route} has uniform scales only",
        f"{where} --scales {request.scales_file}",
        f"take --route {BY_AXES}, or write one factor in each line",
        "scale-not-uniform",
    )


def _readings(request: SweepInPlane, route: str) -> dict[str, str] | None:
    """How the paper's own program reads the paper; None for the other routes. Refuses options that
    the route does not have."""
    refuse_options(route, request.as_read, request.reading)
    check_arithmetic(request.arithmetic)
    if route == ROUTE:
        return readings_of(request.as_read, request.reading)
    if request.arithmetic != "rational":
        what = f"the route {route} is exact only"
        mend = f"add --route {ROUTE}, or leave it out"
        raise Refusal(what, f"--arithmetic {request.arithmetic}", mend)
    return None


def _walked(walk: PaperWalk) -> Step:
    return lambda scale: walk.row(text_of(scale))


def _sums(
    P: Operand,
    Q: Operand,
    scales: list[Fraction],
    route: str,
    index: Path | None,
    eroding: ErodingPair | None,
) -> Sums:
    """All events of the least window that holds the scales; no sum is asked for yet."""
    if eroding is not None:
        P, Q = eroding.P, eroding.Q
        scales = [scale for scale in scales if scale >= eroding.least] or [eroding.least]
    least, greatest = min(scales), max(scales)
    if route == "index":
        return index_of(index, P, Q, least, greatest)
    return refusing(
        f"{P.name} and {Q.name}",
        lambda: _core.DynamicSum(P.set, Q.set, str(least), str(greatest), route),
    )


def step(
    sums: Sums, factor: PlaneScale, eroding: ErodingPair | None = None
) -> tuple[Row, _core.PolygonSet]:
    """Goes to a scale: the row, with the counts of a dynamic step, and the new sum; or the erosion,
    which `sums` are the other side of."""
    scale = text_of(factor)
    if eroding is not None and Fraction(scale) < eroding.least:
        nothing, still = _core.PolygonSet(), isinstance(sums, _core.DynamicSum)
        did = dict.fromkeys((*STEPS[0], "groups"), 0) if still else {}
        return _row(scale, did, set_fields(nothing, 0, 0), 0.0), nothing
    if isinstance(sums, _core.DynamicSum):
        did = dict(sums.move_to(scale))
        answer = sums.sum()
    else:
        did = {}
        answer = sums.sum(scale)
    if eroding is None:
        return _row(scale, did, sum_fields(answer), answer.seconds), answer.region
    found = _core.inside_out(answer.region)
    return _row(scale, did, set_fields(*found), answer.seconds), found[0]


def _row(scale: str, did: dict[str, Any], fields: dict[str, Any], seconds: float) -> Row:
    return {
        "scale": scale,
        **fields,
        "insertions": did.get("insertions"),
        "deletions": did.get("deletions"),
        "swaps": did.get("swaps"),
        "updated": did.get("updated"),
        "event_scales": did.get("groups"),
        "update_seconds": did.get("seconds"),
        "sum_seconds": seconds,
        "exact": None,
    }


def _print(value: dict[str, Any], rows: RowSpool) -> None:
    steps = next((names for names in STEPS if names[0] in next(iter(rows.first(1)))), ())
    steps = steps if value["route"] in UPDATING else ()
    by_axes = steps == COUNTS
    headings = ("scale", "area", "components", "holes", "vertices", *steps, "ms")
    beside = ("exact",) if value["route"] == ROUTE else ()
    table = plain_table(*headings, *beside, right=headings, whole=True)
    for row in rows.first(SHOWN):
        counts = (row[name] for name in ("components", "holes", "vertices"))
        did = (row[name] for name in steps)
        seconds = (row["update_seconds"] or 0) + row["sum_seconds"]
        table.add_row(
            shown_scale(row["scale"])[:25] if by_axes else _short(row["scale"]),
            _short(row["area"]),
            *(f"{count:,}" for count in (*counts, *did)),
            f"{seconds * 1000:.3f}",
            *([in_words(row["exact"])] if beside else []),
        )
    sign = "less" if value["erode"] else "+"
    summary = [
        ("sweep", f"{value['P']} {sign} {value['Q']}, {counted(len(rows), 'scale')}"),
        ("route", value["route"]),
        *([("first wrong", value["first_wrong"] or "nowhere")] if beside else []),
        *(events_in_words(value["events"]) if beside else []),
        ("all events", f"{value['preprocessing_seconds']:.3f} s"),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_sweep(table, rows, summary, value)


def _short(number: str) -> str:
    return number if len(number) <= 12 else rounded(number)
