"""`minkref events P Q` in the plane: the critical scales of sP + Q, exact and sorted."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.progress import progress
from minkref.cli.readings import readings_of
from minkref.errors import Refusal, choice, refusing
from minkref.exact import text_of_bounds
from minkref.output.documents import Stopwatch, as_text, document, refuse_overwriting
from minkref.output.output_target import Target, target_of
from minkref.plane.commands.event_lines import SHOWN, print_events
from minkref.plane.commands.event_output import FORMATS, document_pieces, print_pieces, write_events
from minkref.plane.commands.scale_index import chosen_route, index_of, refuse_overwriting_index
from minkref.plane.eroded import ErodingPair, eroding_pair
from minkref.plane.event_lists import BoundaryEventList, EventList, PairEventList, find_events
from minkref.plane.event_values import CONVOLUTIONS, KINDS, PAIR_KINDS, ROUTED_KINDS, ROUTES
from minkref.plane.operand import Operand, read_operand
from minkref.verbs.events import EventsInPlane, check_limit, check_paper

LISTED = 1000  # of the paper's program, where no limit is given
PAIR_COUNTS = (
    "pairs", "filtered_pairs", "intersecting_pairs", "always_meeting_pairs", "touching_pairs",
    "parallel_pairs", "kernel", "by_float", "by_integer", "by_rational",
)  # fmt: skip


def run(request: EventsInPlane) -> None:
    watch = Stopwatch()
    kind = _kind(request)
    readings = _readings(request, kind)
    condition = _condition(request.where, kind)
    output, limit, json = request.output, request.limit, request.json
    target = target_of(output, request.file_format, FORMATS, "json", json)
    _check_parquet(target, kind)
    route = _route(kind, request.route, request.index)
    _check_reduced(request, route, readings)
    lines = not request.erode
    named = first, second = read_operand(request.P, lines), read_operand(request.Q, lines)
    if output is not None:
        refuse_overwriting(output, [first.file, second.file])
        refuse_overwriting_index(output, request.index)
    eroding = eroding_pair(first, second) if request.erode else None
    if eroding is not None:
        first, second = eroding.P, eroding.Q
    with memory_wall(request.memory, f"{kind} events", f"{first.name} and {second.name}", SMALLER):
        found, window = _found(request, kind, route, first, second, eroding)
        counts = _counts(found, first, second, window, route)
        trial, literal = _trials(request, first, second, readings)
        counts.update(count=len(found), distinct=found.distinct)
        if condition is not None:
            found.keep(condition)
        counts.update(matching=len(found), matching_distinct=found.distinct)
        fields: dict[str, Any] = {
            "P": named[0].name,
            "Q": named[1].name,
            "erode": request.erode,
            "from": window[0],
            "to": window[1],
            "kind": kind,
            "form": request.form,
            "arithmetic": request.arithmetic,
            "route": route,
            "cut": _cut(first, second, route),
            "where": request.where,
            "warnings": first.warnings + second.warnings,
            "output": str(output) if output else None,
            "compute_seconds": found.seconds,
            "segments": {"S": counts.pop("s_edges"), "T": counts.pop("t_edges")},
            "signs": {name: counts.pop(name) for name in ("by_float", "by_integer", "by_rational")},
            "kernel": counts.pop("kernel"),
            **counts,
            "trial": trial,
            "literal": literal,
            "least_precision": _least(first, second, request.form) if request.least else None,
            **found.features(),
        }
        count = len(found) if limit is None else min(limit, len(found))
        head = document("events", watch, **fields)
        if target is not None:
            write_events(target, head, found, count)
        if json and target is None:
            print_pieces(document_pieces(head, found, count))
        elif json:
            sys.stdout.write(as_text(document("events", watch, **fields, events=None)))
        elif target is None or not target.is_standard_output:
            shown_events = SHOWN if limit is None else limit
            print_events(document("events", watch, **fields), found, shown_events)


def _kind(request: EventsInPlane) -> str:
    """Refuses an unknown kind, and options foreign to it."""
    other = "pair" if request.index is None and not request.erode else "boundary"
    kind = request.kind or other
    if kind not in KINDS:
        raise Refusal(f"there is no kind {kind!r} of events", "--kind", choice(kind, KINDS))
    check_paper(kind, request.form, request.arithmetic)
    if request.least and kind != "pair":
        raise Refusal(
            "the least precision is found for pair events only",
            f"--kind {kind} --least-precision",
            "leave out one of the two options",
        )
    check_limit(request.limit)
    if request.erode and kind not in ROUTED_KINDS:
        what = f"{kind} events are those of a convolution, and an erosion has none of its own"
        mend = f"choose --kind {' or --kind '.join(ROUTED_KINDS)}"
        raise Refusal(what, f"--kind {kind} --erode", mend)
    return kind


def _readings(request: EventsInPlane, kind: str) -> dict[str, str] | None:
    """How the paper's program reads the paper; None if not followed."""
    if request.reading and kind != "pair":
        what = "the paper's program has pair events only"
        where = f"--kind {kind} --reading {request.reading[0]}"
        raise Refusal(what, where, "leave out one of the two")
    if request.arithmetic == "rational" and not request.reading:
        return None
    return readings_of(request.form, request.reading)


def _found(
    request: EventsInPlane,
    kind: str,
    route: str | None,
    P: Operand,
    Q: Operand,
    eroding: ErodingPair | None,
) -> tuple[EventList, list[str | None]]:
    """The events, and the window covered completely."""
    given = request.from_scale, request.to_scale
    window = text_of_bounds(*given)
    bounds = given if eroding is None else eroding.window(*given)
    outside = None if eroding is None else eroding.outside
    if route == "index":
        swept = index_of(request.index, P, Q, *bounds)
        if eroding is not None and request.index is None:
            return BoundaryEventList(swept, kind, window, outside), window
        window = [
            own or bound for own, bound in zip(window, text_of_bounds(*swept.window), strict=True)
        ]
        return BoundaryEventList(swept, kind, window, outside), window
    with progress(1) as line:
        line.now(f"finding all {kind} events")
        found = refusing(
            f"{P.name} and {Q.name}",
            lambda: find_events(
                P.set,
                Q.set,
                text_of_bounds(*bounds),
                kind,
                request.form,
                route or ROUTES[0],
                outside,
            ),
        )
    return found, window


def _trials(
    request: EventsInPlane, P: Operand, Q: Operand, readings: dict[str, str] | None
) -> tuple[dict[str, Any] | None, dict[str, Any] | None]:
    """How the paper's method fares, and its program's list; None if not asked."""
    if readings is None:
        return None, None
    from minkref.verbs.paper_update import paper_walk

    walk = paper_walk(P, Q, "1", request.arithmetic, readings)
    literal = {
        "readings": readings,
        **walk.events(LISTED if request.limit is None else request.limit),
    }
    trial = refusing(
        f"{P.name} and {Q.name}",
        lambda: _core.precision_trial(P.set, Q.set, request.arithmetic, request.form),
    )
    return dict(trial), literal


def _condition(where: str | None, kind: str) -> _core.EventCondition | None:
    if where is None:
        return None
    from minkref.plane.event_filter import read_filter

    return read_filter(where, kind)


def _route(kind: str, route: str | None, index: Path | None) -> str | None:
    """The route. Events of an arrangement are in no index; null stands for their default."""
    if kind in ROUTED_KINDS:
        return chosen_route(index, route, ROUTES)
    if index is not None or route == "index":
        raise Refusal(
            f"{kind} events come from the arrangement of a convolution: no index has them",
            "--route index" if index is None else f"--index {index}",
            "leave it out, or choose --kind boundary or --kind topology",
        )
    return None if route is None else chosen_route(None, route, CONVOLUTIONS)


def _check_reduced(
    request: EventsInPlane, route: str | None, readings: dict[str, str] | None
) -> None:
    """Refuses the paper's program for the full convolution: the paper follows the reduced one."""
    if route == "winding" and request.erode:
        what = "the winding route cuts what is outside of P, and numbers parents along the cuts"
        raise Refusal(what, "--route winding --erode", "take --route dynamic or index")
    if route != "winding" or (readings is None and not request.least):
        return
    given = "--least-precision"
    if readings is not None:
        given = "--reading" if request.arithmetic == "rational" else "--arithmetic"
    what = "the paper's program follows the reduced convolution"
    raise Refusal(what, f"--route winding {given}", "leave out one of the two options")


def _cut(P: Operand, Q: Operand, route: str | None) -> dict[str, Any] | None:
    """The rings that parents are numbered along, of operands that the route cuts; else null."""
    if route != "winding":
        return None
    return {name: _core.cut_rings(each.set) or None for name, each in (("P", P), ("Q", Q))}


def _counts(
    found: EventList, P: Operand, Q: Operand, window: list[str | None], route: str | None
) -> dict[str, Any]:
    """Counts edge pairs; null for an index's unneeded counts."""
    if isinstance(found, PairEventList):
        return dict(found.found.counts())
    if isinstance(found, BoundaryEventList) and isinstance(found.found, _core.ScaleIndex):
        counted_edges = found.found.counts()
        edges = {name: counted_edges[name] for name in ("s_edges", "t_edges")}
        return {**dict.fromkeys(PAIR_COUNTS), **edges}
    pairs = refusing(
        f"{P.name} and {Q.name}",
        lambda: _core.pair_events(P.set, Q.set, window[0], window[1], route=route or ROUTES[0]),
    )
    return dict(pairs.counts())


def _least(P: Operand, Q: Operand, form: str) -> dict[str, int | None]:
    from minkref.fuzz.least_precision import MOST_BITS, least_precision

    bits = refusing(f"{P.name} and {Q.name}", lambda: least_precision(P.set, Q.set, form))
    return {"bits": bits, "most_tried": MOST_BITS}


def _check_parquet(target: Target | None, kind: str) -> None:
    if target is None or target.form != "parquet":
        return
    if kind not in PAIR_KINDS:
        raise Refusal(f"{kind} events are not written as Parquet", target.name, "name a .json file")
    if target.is_standard_output:
        raise Refusal("Parquet is written to a file", "-o -", "name one, or choose --format jsonl")
