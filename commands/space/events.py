"""`minkref events` of polyhedra."""

from __future__ import annotations

import heapq
import json
import sys
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, islice
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.commands.line.memory import SMALLER, memory_wall
from minkref.commands.line.progress import told_of
from minkref.commands.lists.scale_index import cores
from minkref.documents import Stopwatch, as_text, document, listing, refuse_overwriting
from minkref.errors import Refusal, refusing
from minkref.exact import approximate, read_window
from minkref.output_target import target_of
from minkref.space.operand import SpaceOperand, read_summand
from minkref.terminal import console, counted

FORMATS = ("json", "jsonl")
KINDS = {
    "pair": ("vertex", "edge", "parallel"),
    "triple": ("triple", "four"),
    "arrangement": ("vertex", "edge", "parallel", "triple", "four"),
}
SHOWN = 10  # events that people see
PAGE = 4096  # events at a time


def events_in_space(
    P: str,
    Q: str,
    kind: str,
    from_scale: str | None,
    to_scale: str | None,
    limit: int | None,
    output: Path | None,
    form: str | None,
    json_document: bool,
    memory: int | None,
    arithmetic: str,
    paper_form: str,
) -> None:
    """The command, its options read but not yet checked."""
    watch = Stopwatch()
    if from_scale is None or to_scale is None:
        missing = "--from" if from_scale is None else "--to"
        raise Refusal("in space events are found in a window", missing, "give both --from and --to")
    target = target_of(output, form, FORMATS, "json", json_document)
    window = [bound for bound in read_window(from_scale, to_scale) if bound is not None]
    with memory_wall(memory, "events in space", f"{P} and {Q}", SMALLER):
        first, second = read_summand(P), read_summand(Q)
        if output is not None:
            refuse_overwriting(output, [first.file, second.file])
        where = f"{first.name} and {second.name}"
        _refuse_thin(first, second)
        began = watch.seconds()
        with told_of("finding all events") as tell:
            found = refusing(
                where,
                lambda: _core.space_events(
                    first.surface,
                    second.surface,
                    window[0],
                    window[1],
                    cores(),
                    tell,
                    kind != "pair",
                ),
            )
        seconds = watch.seconds() - began
        trial = None
        if arithmetic != "rational" or paper_form != "corrected":
            trial = refusing(
                where,
                lambda: dict(
                    _core.facet_contact_trial(first.surface, second.surface, arithmetic, paper_form)
                ),
            )
        head = _head(watch, first, second, window, kind, found, seconds, output)
        head |= {"form": paper_form, "arithmetic": arithmetic, "trial": trial}
        count = head["count"] if limit is None else min(limit, head["count"])
        if target is not None:
            target.write_pieces(_pieces(target.form, head, _rows(found, kind, count)))
        if json_document and target is None:
            sys.stdout.writelines(listing(head, "events", _rows(found, kind, count)))
        elif json_document:
            sys.stdout.write(as_text({**head, "events": None}))
        elif target is None or not target.is_standard_output:
            _print(head, found, min(count, SHOWN) if limit is None else count)


def refuse_in_space(
    kind: str,
    form: str,
    arithmetic: str,
    reading: list[str] | None,
    least: bool,
    route: str | None,
    index: Path | None,
    where: str | None,
) -> None:
    """In space there are the exact events of the arrangement of facets, and no others."""
    if kind not in KINDS:
        what = "in space there are events of two facets, and of three or four"
        raise Refusal(what, f"--kind {kind}", f"choose one of {', '.join(KINDS)}")
    if kind == "triple" and (form != "corrected" or arithmetic != "rational"):
        what = "the paper has events of two facets only"
        raise Refusal(what, f"--kind {kind} --form or --arithmetic", "leave out one of the two")
    given = {
        "--reading": bool(reading),
        "--least-precision": least,
        "--route": route is not None,
        "--index": index is not None,
        "--where": where is not None,
    }
    for option, is_given in given.items():
        if is_given:
            raise Refusal("this is for events in the plane", option, "leave it out")


def _refuse_thin(P: SpaceOperand, Q: SpaceOperand) -> None:
    for operand in (P, Q):
        if not operand.is_solid:
            mend = "give a polyhedron with a volume"
            raise Refusal("events in space are those of solids", operand.name, mend, "not-solid")


def _head(
    watch: Stopwatch,
    P: SpaceOperand,
    Q: SpaceOperand,
    window: list[str],
    kind: str,
    found: _core.SpaceEvents,
    seconds: float,
    output: Path | None,
) -> dict[str, Any]:
    counts = dict(found.counts())
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


def _rows(found: _core.SpaceEvents, kind: str, count: int) -> Iterator[dict[str, Any]]:
    """The first so many of a kind."""
    of_pairs = _of_pairs(found) if kind != "triple" else iter(())
    of_more = _of_more(found) if kind != "pair" else iter(())
    merged = heapq.merge(of_pairs, of_more, key=lambda row: Fraction(row["s"]))
    return islice(merged if kind == "arrangement" else chain(of_pairs, of_more), count)


def _of_pairs(found: _core.SpaceEvents) -> Iterator[dict[str, Any]]:
    for s, kind, change, first, of_first, second, of_second, place in _paged(found.rows):
        is_side = kind == "edge"
        facets = [
            _facet(found, number, None if is_side else at, at if is_side else None)
            for number, at in ((first, of_first), (second, of_second))
        ]
        yield _row(s, kind, change, facets, place)


def _of_more(found: _core.SpaceEvents) -> Iterator[dict[str, Any]]:
    for s, kind, change, numbers, at, place in _paged(found.concurrent):
        facets = [
            _facet(found, number, None, at[1] if at is not None and at[0] == k else None)
            for k, number in enumerate(numbers)
        ]
        yield _row(s, kind, change, facets, place)


def _paged(page: Callable[[int, int], list[Any]]) -> Iterator[Any]:
    start = 0
    while rows := page(start, PAGE):
        yield from rows
        start += PAGE


def _row(
    s: str, kind: str, change: str, facets: list[dict[str, Any]], place: Sequence[str] | None
) -> dict[str, Any]:
    at = None if place is None else list(place)
    return {"s": s, "kind": kind, "change": change, "facets": facets, "place": at}


def _facet(
    found: _core.SpaceEvents, number: int, corner: int | None, side: int | None
) -> dict[str, Any]:
    facet, of_P, of_Q = found.facet(number)
    return {"facet": facet, "P": of_P, "Q": of_Q, "corner": corner, "side": side}


def _pieces(form: str, head: dict[str, Any], rows: Iterator[dict[str, Any]]) -> Iterator[str]:
    if form == "json":
        yield from listing(head, "events", rows)
        return
    for row in rows:
        yield json.dumps(row) + "\n"


def _print(head: dict[str, Any], found: _core.SpaceEvents, count: int) -> None:
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
        how = f"the paper's way, {head['form']}, in {head['arithmetic']}"
        told.print(f"{how}: {_fares(head['trial'])}")
    for row in _rows(found, head["kind"], count):
        touching = " and ".join(
            f"{one['facet']} {'-'.join(map(str, dict.fromkeys(one['P'])))}"
            f" + {'-'.join(map(str, dict.fromkeys(one['Q'])))}"
            for one in row["facets"]
        )
        told.print(f"{approximate(row['s']):>14}  {row['kind']} {row['change']}: {touching}")
    if count < head["count"]:
        told.print(f"... and {head['count'] - count:,} more (--limit N, -o FILE)")


def _fares(trial: dict[str, int]) -> str:
    return (
        f"{trial['false_inconsistent']:,} of {trial['roots']:,} systems with a root called "
        f"inconsistent; of {counted(trial['events'], 'event')} at all scales {trial['missed']:,} "
        f"missed, {trial['misplaced']:,} off by more than an ulp, {trial['invented']:,} invented"
    )
