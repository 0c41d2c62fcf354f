"""Events from both sides as comparable rows."""

from __future__ import annotations

from collections import Counter
from typing import Any

from minkref import _core
from minkref.oracle.symbolic.arrangement import ArrangementEvent
from minkref.oracle.symbolic.convolution import ConvolutionEdge
from minkref.oracle.symbolic.moving import Point, point_text
from minkref.oracle.symbolic.pairs import Event
from minkref.oracle.symbolic.rational import text

# As triple events minkref also lists events where a segment's end passes on a common line.
LISTED_AS = {"end": "triple"}
Place = frozenset[tuple[str, ...]]
"""A point, or both ends of a segment in either order."""
Row = tuple[str, str, str, frozenset[tuple[str, int, int, int, int]], Place]
"""Scale, kind, change, parents and place."""


def ends_of(event: Event) -> list[Point]:
    return [event.at] if event.to is None else [event.at, event.to]


def symbolic_rows(edges: list[ConvolutionEdge], found: list[ArrangementEvent]) -> Counter[Row]:
    return Counter(
        (
            text(each.event.s),
            LISTED_AS.get(each.kind, each.kind),
            each.event.change,
            frozenset(edges[i].parents for i in each.segments),
            frozenset((x, y) for x, y in map(point_text, ends_of(each.event))),
        )
        for each in found
    )


def parents_of(row: tuple[str, int, int, int, int, int]) -> tuple[str, int, int, int, int]:
    return row[0], *row[2:]


def minkref_rows(events: Any, which: list[int]) -> Counter[Row]:
    edges = [parents_of(row) for row in events.edges()]
    return Counter(
        (s, kind, change, frozenset(edges[i] for i in members), frozenset({at, to or at}))
        for s, kind, change, members, at, to in events.rows(which)
    )


def pair_search_rows(found: Any) -> Counter[Row]:
    """Rows from the search that knows pair and parallel events only."""
    edges = [parents_of(row) for row in found.edges()]
    return Counter(
        (
            s,
            "parallel" if level else "pair",
            change,
            frozenset((edges[a], edges[b])),
            frozenset({at, to or at}),
        )
        for s, _, change, level, a, b, at, to in found.rows(0, len(found))
    )


def unmatched(mine: Counter[Row], theirs: Counter[Row]) -> tuple[list[Row], list[Row]]:
    """Rows that only one side has. If two segments pass each other in several places at one scale,
    minkref lists one event, at one of these places: our rows have to contain this event, listed
    once."""
    missing = list((theirs - mine).elements())
    named = Counter(row[:4] for row in theirs.elements())
    extra = [row for row in (mine - theirs).elements() if row[:4] not in named]
    return extra, missing + [row for row in theirs if named[row[:4]] > 1]


def compared(
    edges: list[ConvolutionEdge], found: list[ArrangementEvent], P: Any, Q: Any
) -> dict[str, tuple[list[Any], list[Any]]]:
    """Rows that only the symbolic oracle has, and rows that only minkref has: edges of the reduced
    convolution; events of `--kind arrangement`; events of the search for pairs, kinds pair and
    parallel."""
    truth = symbolic_rows(edges, found)
    known = Counter({row: n for row, n in truth.items() if row[1] != "triple" and row[2] != "swap"})
    mine = Counter(edge.parents for edge in edges)
    theirs = Counter(parents_of(row) for row in _core.reduced_convolution(P, Q))
    events = _core.ArrangementEvents(P, Q)
    return {
        "convolution": (list((mine - theirs).elements()), list((theirs - mine).elements())),
        "arrangement": unmatched(truth, minkref_rows(events, events.of_kind("arrangement"))),
        "pair search": unmatched(known, pair_search_rows(_core.pair_events(P, Q))),
    }


def show(row: Any) -> str:
    return " ".join(str(sorted(x) if isinstance(x, frozenset) else x) for x in row)
