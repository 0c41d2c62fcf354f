"""`minkref events` of polyhedra."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from itertools import chain, islice
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.progress import told_of
from minkref.cli.readings import FACET_CHOICES, readings_of
from minkref.errors import Refusal, choice, refusing
from minkref.output.documents import (
    Stopwatch,
    as_text,
    document,
    lasting,
    listing,
    refuse_overwriting,
)
from minkref.output.output_target import Target, target_of
from minkref.output.terminal import console, counted
from minkref.plane.event_values import KINDS as PLANE_KINDS
from minkref.space.commands.event_parts import MOST, OF_MORE, OF_PAIRS, EventParts, Part
from minkref.space.commands.event_rows import Row, as_lines, in_words, rows_of, write_parquet
from minkref.space.operand import SpaceOperand, read_summand
from minkref.verbs.events import EventsInSpace, check_limit, check_paper

FORMATS = ("json", "jsonl", "parquet")
KINDS = {"pair": OF_PAIRS, "triple": OF_MORE, "arrangement": OF_PAIRS + OF_MORE}
SHOWN = 10  # events that people see


def run(request: EventsInSpace) -> None:
    watch = Stopwatch()
    kind, limit, output, json = _kind(request), request.limit, request.output, request.json
    readings = _readings(request, kind)
    if request.from_scale is None or request.to_scale is None:
        missing = "--from" if request.from_scale is None else "--to"
        raise Refusal("in space events are found in a window", missing, "give both --from and --to")
    target = target_of(output, request.file_format, FORMATS, "json", json)
    window = (str(request.from_scale), str(request.to_scale))
    with memory_wall(request.memory, "events in space", f"{request.P} and {request.Q}", SMALLER):
        first, second = read_summand(request.P), read_summand(request.Q)
        if output is not None:
            refuse_overwriting(output, [first.file, second.file])
        where = f"{first.name} and {second.name}"
        _refuse_thin(first, second)
        if target is not None and target.form == "parquet" and target.is_standard_output:
            raise Refusal(
                "Parquet is written to a file", "-o -", "name one, or choose --format jsonl"
            )
        trial = _trial(request, readings, first, second)
        began = watch.seconds()
        streamed = target is not None and target.form != "json"
        with told_of("finding all events") as tell:
            parts = EventParts(
                first.surface,
                second.surface,
                window,
                kind != "pair",
                tell,
                MOST if streamed else None,
            )
            if target is not None and streamed:
                refusing(where, lambda: _write(target, _rows(parts, kind, limit)))
            found = refusing(where, lambda: list(parts))  # what is left
        head = _head(watch, first, second, window, kind, parts, watch.seconds() - began, output)
        head |= {"form": request.form, "arithmetic": request.arithmetic}
        head |= {"readings": readings, "trial": trial}
        if target is not None and not streamed:
            target.write_pieces(listing(lasting(head), "events", _rows(found, kind, limit)))
        if json and target is None:
            sys.stdout.writelines(listing(head, "events", _rows(found, kind, limit)))
        elif json:
            sys.stdout.write(as_text({**head, "events": None}))
        elif target is None or not target.is_standard_output:
            _print(head, list(_rows(found, kind, SHOWN if limit is None else limit)))


def _rows(parts: Iterable[Part], kind: str, limit: int | None) -> Iterator[Row]:
    return islice(chain.from_iterable(rows_of(part, kind) for part in parts), limit)


def _write(target: Target, rows: Iterator[Row]) -> None:
    if target.form == "parquet":
        write_parquet(rows, target.path)
    else:
        target.write_pieces(as_lines(rows))


def _kind(request: EventsInSpace) -> str:
    """Refuses an unknown kind, and options foreign to it."""
    kind = request.kind or "pair"
    if kind not in PLANE_KINDS:
        raise Refusal(f"there is no kind {kind!r} of events", "--kind", choice(kind, KINDS))
    if kind not in KINDS:
        what = "in space there are events of two facets, and of three or four"
        raise Refusal(what, f"--kind {kind}", f"choose one of {', '.join(KINDS)}")
    check_paper(kind, request.form, request.arithmetic)
    check_limit(request.limit)
    return kind


def _readings(request: EventsInSpace, kind: str) -> dict[str, str] | None:
    """How to read the paper; None if not followed."""
    if request.reading and kind != "pair":
        where = f"--kind {kind} --reading {request.reading[0]}"
        raise Refusal("the paper has events of two facets only", where, "leave out one of the two")
    if request.arithmetic == "rational" and request.form == "corrected" and not request.reading:
        return None
    return readings_of(request.form, request.reading, FACET_CHOICES)


def _trial(
    request: EventsInSpace, readings: dict[str, str] | None, P: SpaceOperand, Q: SpaceOperand
) -> dict[str, int] | None:
    """How the paper's method fares; None if not asked."""
    if readings is None:
        return None
    trial = refusing(
        f"{P.name} and {Q.name}",
        lambda: _core.facet_contact_trial(P.surface, Q.surface, request.arithmetic, readings),
    )
    return dict(trial)


def _refuse_thin(P: SpaceOperand, Q: SpaceOperand) -> None:
    for operand in (P, Q):
        if not operand.is_solid:
            mend = "give a polyhedron with a volume"
            raise Refusal("events in space are those of solids", operand.name, mend, "not-solid")


def _head(
    watch: Stopwatch,
    P: SpaceOperand,
    Q: SpaceOperand,
    window: tuple[str, str],
    kind: str,
    parts: EventParts,
    seconds: float,
    output: Path | None,
) -> dict[str, Any]:
    counts = dict(parts.counts)
    signs = {name: counts.pop(name) for name in ("by_float", "by_integer")}
    every = {name: counts.pop(name) for name in KINDS["arrangement"]}
    kinds = {name: every[name] for name in KINDS[kind]}
    distinct = counts.pop("distinct_of_pairs"), counts.pop("distinct_of_more")
    both = counts.pop("distinct")
    return document(
        "events",
        watch,
        dimension=3,
        P=P.name,
        Q=Q.name,
        **{"from": window[0], "to": window[1]},
        kind=kind,
        warnings=P.warnings + Q.warnings,
        output=str(output) if output else None,
        compute_seconds=seconds,
        count=sum(kinds.values()),
        distinct={"pair": distinct[0], "triple": distinct[1], "arrangement": both}[kind],
        kinds=kinds,
        signs=signs,
        **counts,
    )


def _print(head: dict[str, Any], shown: list[Row]) -> None:
    told = console()
    kinds = ", ".join(f"{number:,} {kind}" for kind, number in head["kinds"].items())
    told.print(
        f"{counted(head['count'], 'event')} at {counted(head['distinct'], 'scale')} from "
        f"{head['from']} to {head['to']}: {kinds}"
    )
    told.print(
        f"{head['facets']:,} facets of the convolution, {head['near_pairs']:,} pairs that may "
        f"meet, {head['pairs_with_events']:,} with events; {head['compute_seconds']:.3f} s"
    )
    if head["trial"] is not None:
        readings = " ".join(f"{name}={value}" for name, value in head["readings"].items())
        how = f"the paper's way, in {head['arithmetic']}, {readings}"
        told.print(f"{how}: {_fares(head['trial'])}")
    for row in shown:
        told.print(in_words(row))
    if shown and len(shown) < head["count"]:
        told.print(f"... and {head['count'] - len(shown):,} more (--limit N, -o FILE)")


def _fares(trial: dict[str, int]) -> str:
    return (
        f"{trial['false_inconsistent']:,} of {trial['roots']:,} systems with a root called "
        f"inconsistent; of {counted(trial['events'], 'event')} at all scales {trial['missed']:,} "
        f"missed ({trial['parallel_faces']:,} of parallel faces, {trial['parallel_sides']:,} of "
        f"parallel sides and {trial['side_along_plane']:,} with a side along the plane, where the "
        f"matrix is singular), {trial['misplaced']:,} off by more than an ulp, "
        f"{trial['invented']:,} invented; {trial['parallel_pairs']:,} of {trial['pairs']:,} pairs "
        f"are parallel, {trial['coplanar_pairs']:,} coplanar at all scales, "
        f"{trial['undecided_pairs']:,} undecided"
    )
