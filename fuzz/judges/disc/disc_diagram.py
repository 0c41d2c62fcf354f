"""Radii at which sums with a disc change, against the vertices of the outer Voronoi diagram from
CGAL and Boost.Polygon: which vertices exist, their places and nearest features.

`python -m minkref.fuzz.judges.disc.disc_diagram SEED COUNT` compares sets made of grid cells and
from the families of generated pairs, prints the table as JSON and exits with 1 on a difference that
no exact witness blames on the judge."""

from __future__ import annotations

import json
import math
import random
import sys
from collections import Counter
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from typing import Any

from minkref import _core
from minkref.fuzz.features.outer_diagram import BOOST, CGAL, DiagramAnswer, DiagramJudge, Vertex
from minkref.fuzz.features.outline import Feature, Outline
from minkref.fuzz.judges.disc.diagram_saddles import saddles
from minkref.fuzz.judges.disc.diagram_witness import Ruling, settle
from minkref.fuzz.judges.disc.offset_comparison import grid_set
from minkref.fuzz.plane.families.catalogue import FAMILIES

SECONDS = 60.0  # per diagram
SAME_PLACE = 1e-9  # times the set's size or the radius: closer places are one
SAME_RADIUS = {CGAL: 1e-15, BOOST: 1e-9}  # times the radius, beyond the bounds
LOST = {CGAL: 0.0, BOOST: 64 * 2.0**-53}  # times a coordinate: rounding of a judge's place
PARTS = 4e-15  # times size or radius: closer places of CGAL are parts of one
DOUBLE = 2.0**-52  # times a coordinate: its rounding
SETS = ("random", "holes", "collinear", "touching", "cells", "nested", "comb", "star", "rational")
# The ruling by which a witness proves minkref right, for each fault. In the fault `features` the
# judge has some of the features, minkref all.
RIGHT = {"dropped": Ruling.NONE, "invented": Ruling.VERTEX, "features": Ruling.VERTEX}


@dataclass(frozen=True)
class Event:
    """A row of minkref's list, with `features` named, and the place moved, as by Outline; `slack`
    is the place's rounding before the move."""

    kind: str
    x: float
    y: float
    slack: float
    low: float
    high: float
    square: str | None
    features: frozenset[Feature]


@dataclass(frozen=True)
class Difference:
    """`fault` is `dropped` (a vertex is no event), `invented` (an event is no vertex), `features`
    (features differ), `radius` or `twice`."""

    fault: str
    x: float
    y: float
    radius: float
    features: frozenset[Feature]

    def __str__(self) -> str:
        names = ", ".join(" ".join(map(str, feature)) for feature in sorted(self.features, key=str))
        return f"{self.fault} at ({self.x:.17g}, {self.y:.17g}), radius {self.radius:.17g}: {names}"


@dataclass
class Table:
    """A comparison's result. `differences` speak against minkref or are unsettled; `refuted`:
    differences in which an exact witness proves the judge wrong."""

    counts: Counter[str] = field(default_factory=Counter)
    unanswered: list[str] = field(default_factory=list)
    differences: list[str] = field(default_factory=list)
    refuted: list[str] = field(default_factory=list)
    wrong: set[str] = field(default_factory=set)  # names of sets with differences

    def add(self, other: Table) -> None:
        self.counts.update(other.counts)
        self.unanswered += other.unanswered
        self.differences += other.differences
        self.refuted += other.refuted
        self.wrong |= other.wrong


def events_of(outline: Outline, rows: Sequence[Any]) -> list[Event]:
    """Converts rows from `_core.DiagramEvents.rows`."""
    found = []
    for kind, square, _, (low, high), place, names in rows:
        features = frozenset(_feature(outline, *name) for name in names)
        slack = DOUBLE * max(map(abs, place))
        found.append(Event(kind, *outline.spot(*place), slack, low, high, square, features))
    return found


def _feature(outline: Outline, kind: str, first: str, second: str) -> Feature:
    if kind == "vertex":
        return outline.vertex(first, second)
    return outline.edge(int(first), int(second))


def differences(
    outline: Outline, events: Sequence[Event], answer: DiagramAnswer, judge: str
) -> list[Difference]:
    """Differences between minkref's events of three features or more and the vertices of a judge.
    CGAL gives a vertex of more than three features in several parts."""
    wanted, found = _once(outline, [event for event in events if len(event.features) > 2])
    of_feature: dict[Feature, list[int]] = {}
    for k, event in enumerate(wanted):
        for feature in event.features:
            of_feature.setdefault(feature, []).append(k)
    seen: list[set[Feature]] = [set() for _ in wanted]
    dropped: list[Vertex] = []
    for vertex in answer.vertices or []:
        first = next(iter(vertex.features))
        near = [
            (away, k)
            for k in of_feature.get(first, [])
            if vertex.features <= wanted[k].features
            and (away := _away(outline, wanted[k], vertex)) < 1
        ]
        if not near:
            dropped.append(vertex)
            continue
        event = wanted[min(near)[1]]
        seen[min(near)[1]] |= vertex.features
        slack = SAME_RADIUS[judge] * vertex.radius + LOST[judge] * max(vertex.x, vertex.y)
        if not event.low - slack <= vertex.radius <= event.high + slack:
            found.append(_difference("radius", vertex))
    for event, features in zip(wanted, seen, strict=True):
        if features != event.features:
            fault = "features" if features else "invented"
            found.append(Difference(fault, event.x, event.y, event.low, event.features))
    return [*found, *(_difference("dropped", vertex) for vertex in _joined(outline, dropped))]


def _difference(fault: str, vertex: Vertex) -> Difference:
    return Difference(fault, vertex.x, vertex.y, vertex.radius, vertex.features)


def _joined(outline: Outline, vertices: Sequence[Vertex]) -> list[Vertex]:
    """Joins parts of one place, with all their features."""
    found: list[Vertex] = []
    for vertex in vertices:
        same = PARTS * max(outline.size, vertex.radius)
        for k, other in enumerate(found):
            if math.dist((vertex.x, vertex.y), (other.x, other.y)) < same:
                found[k] = replace(other, features=other.features | vertex.features)
                break
        else:
            found.append(vertex)
    return found


def _once(outline: Outline, events: Sequence[Event]) -> tuple[list[Event], list[Difference]]:
    """Separates first occurrences of events from repetitions."""
    known: dict[frozenset[Feature], list[Event]] = {}
    found, again = [], []
    for event in events:
        same = known.setdefault(event.features, [])
        if any(_away(outline, event, other) < 1 for other in same):
            again.append(Difference("twice", event.x, event.y, event.low, event.features))
        else:
            found.append(event)
        same.append(event)
    return found, again


def saddle_differences(
    outline: Outline, events: Sequence[Event], answer: DiagramAnswer
) -> list[Difference]:
    """Differences between minkref's events with two features and saddles from the edges of a
    judge's diagram. The saddles are exact, so no witness is needed."""
    wanted = {event.features: event for event in events if len(event.features) == 2}
    found = []
    for saddle in saddles(outline, answer.sides):
        x, y = map(float, saddle.at)
        radius = math.sqrt(saddle.squared_radius)
        event = wanted.pop(saddle.features, None)
        if event is None:
            found.append(Difference("dropped", x, y, radius, saddle.features))
        elif (
            event.square != str(saddle.squared_radius)
            or _away(outline, event, Vertex(x, y, radius, saddle.features)) >= 1
        ):
            found.append(Difference("radius", x, y, radius, saddle.features))
    for event in wanted.values():
        found.append(Difference("invented", event.x, event.y, event.low, event.features))
    return found


def _away(outline: Outline, event: Event, vertex: Vertex | Event) -> float:
    """Returns their distance; from 1 on, the places differ."""
    same = SAME_PLACE * max(outline.size, event.high) + event.slack
    return math.dist((event.x, event.y), (vertex.x, vertex.y)) / same


class DiagramComparison:
    """Both judges, for many sets. Close it, or use `with`."""

    def __init__(self, judges: Sequence[str] = (CGAL, BOOST), seconds: float = SECONDS) -> None:
        self._open = ExitStack()
        self._judges = [self._open.enter_context(DiagramJudge(name, seconds)) for name in judges]

    def __enter__(self) -> DiagramComparison:
        return self

    def __exit__(self, *_: object) -> None:
        self._open.close()

    def compare(self, name: str, P: _core.PolygonSet, rows: Sequence[Any], table: Table) -> None:
        """Compares the rows of P's events with each judge's vertices."""
        outline = Outline.of(P)
        events = events_of(outline, rows)
        table.counts["sets"] += 1
        table.counts["events"] += sum(len(event.features) > 2 for event in events)
        table.counts["saddles"] += sum(len(event.features) == 2 for event in events)
        table.counts["of more than three features"] += sum(len(e.features) > 3 for e in events)
        for judge in self._judges:
            answer = judge.vertices(outline)
            if answer.vertices is None:
                table.unanswered.append(f"{name}, {judge.judge}: {answer.why}")
                continue
            table.counts[f"sets before {judge.judge}"] += 1
            table.counts[f"vertices of {judge.judge}"] += len(answer.vertices)
            table.counts[f"straight, of {judge.judge}"] += answer.straight
            before = len(table.differences)
            for each in saddle_differences(outline, events, answer):
                # The pair alone decides whether a saddle exists: then the judge lacks the edge
                # between.
                is_right = each.fault == "invented" and bool(saddles(outline, [each.features]))
                told = f"{name}, {judge.judge}: saddle {each}"
                (table.refuted if is_right else table.differences).append(told)
            for each in differences(outline, events, answer, judge.judge):
                ruling, why = settle(outline, each.features, (each.x, each.y), each.radius)
                told = f"{name}, {judge.judge}: {each}: {why}"
                # Joined parts from CGAL may be two places.
                is_joined = judge.judge == CGAL and len(each.features) > 3
                is_right = ruling is RIGHT.get(each.fault)
                if is_right and not (is_joined and each.fault == "dropped"):
                    table.refuted.append(told)
                else:
                    table.differences.append(told)
            if len(table.differences) > before:
                table.wrong.add(name)


def drawn_set(seed: int, number: int) -> tuple[str, _core.PolygonSet]:
    """Cells of a grid, or the first operand of a generated pair. The same numbers give the same."""
    draws = random.Random(f"minkref diagrams of {seed}:{number}")  # families have cases in turn too
    family = draws.choice((*SETS, *["grid"] * len(SETS)))
    if family == "grid":
        dice = random.Random(f"minkref diagrams {seed}:{number}")
        return f"grid {seed}:{number}", grid_set(dice)
    return first_operand(family, seed, number)


def first_operand(family: str, seed: int, number: int) -> tuple[str, _core.PolygonSet]:
    """Returns a generated pair's first operand, with its name."""
    name = f"{family} {seed}:{number}"
    return name, _core.PolygonSet.from_json(FAMILIES[family].pair(seed, number).P)


def compare(seed: int, numbers: range, table: Table) -> None:
    """Sets by number."""
    with DiagramComparison() as comparison:
        for number in numbers:
            name, P = drawn_set(seed, number)
            if not P.is_empty and P.vertices > 2:
                rows = _core.diagram_events(P).rows(0, 10**9)
                comparison.compare(name, P, rows, table)


def main(arguments: list[str]) -> int:
    seed, count = map(int, arguments)
    table = Table()
    compare(seed, range(count), table)
    print(json.dumps({**vars(table), "wrong": sorted(table.wrong)}, indent=1))
    return 1 if table.differences else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
