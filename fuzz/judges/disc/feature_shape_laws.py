"""Laws between features of a growing disc and its sums, and the judges of features before each
other."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from minkref import _core
from minkref.fuzz.features.diagram_bars import Bar, bars_of, unmatched
from minkref.fuzz.features.feature_draws import set_of
from minkref.fuzz.features.outer_diagram import DiagramJudge
from minkref.fuzz.features.outline import Outline
from minkref.fuzz.geometry.plane import Shape
from minkref.oracle.features import Judge

RADII = 3  # between levels, for each set


@dataclass
class Table:
    """`counts`: sets by kind, what trees have, and comparisons; `faults`: with the set's name."""

    counts: Counter[str] = field(default_factory=Counter)
    faults: list[str] = field(default_factory=list)
    unanswered: list[str] = field(default_factory=list)
    seconds: float = 0.0  # of the first judge

    def add(self, other: Table) -> None:
        self.counts.update(other.counts)
        self.faults += other.faults
        self.unanswered += other.unanswered
        self.seconds += other.seconds


def count(name: str, judge: Judge, counts: Counter[str]) -> None:
    """Counts the set's kind, and the ties and shapes of its tree."""
    nodes = [*judge.tree.nodes, *judge.tree.roots]
    groups = [group for node in nodes for group in node.groups]
    counts.update(["sets", f"sets: {' '.join(name.split()[:-1])}"])
    counts["places"] += len(judge.graph.places)
    counts["bars"] += len(judge.tree.bars)
    for node in nodes:
        counts[node.kind] += 1
    counts["sets with ties of birth and depth"] += any(node.tie for node in nodes)
    counts["sets with nodes of degree 3 or more"] += any(
        node.kind == "node" and len(node.children) > 2 for node in nodes
    )
    counts["sets with nodes of several places"] += any(len(node.groups) > 1 for node in nodes)
    counts["sets with ridges"] += any(len(group) > 1 for group in groups)
    counts["sets with several places at one radius"] += len(judge.levels.squares) <= len(
        judge.graph.places
    )


def sum_faults(shape: Shape, judge: Judge, dice: random.Random, counts: Counter[str]) -> list[str]:
    """The alpha-shape has as many components and holes as the sum, and as many bridges as the sum
    has corners, between levels."""
    P = set_of(shape)
    faults = []
    squares = [*map(float, judge.levels.squares), 4 * float(judge.levels.squares[-1]) + 1]
    for k in sorted(dice.sample(range(1, len(squares)), min(RADII, len(squares) - 1))):
        square = Fraction((squares[k - 1] + squares[k]) / 2).limit_denominator(10**9)
        if not squares[k - 1] < square < squares[k]:
            continue
        told = _core.offset(P, str(square))
        if judge.shape_counts(square) != (told.components, told.holes):
            faults.append(f"components and holes at squared radius {square}")
        features = judge.alive(square)
        crossing = sum(low < k <= high for low, high in judge.tracks())
        if sum(len(feature.bridges) for feature in features) != crossing:
            faults.append(f"bridges at squared radius {square}")
        if sum(bar.birth < k <= bar.death for bar in judge.tree.bars) != len(features):
            faults.append(f"bars at squared radius {square}")
        counts["radii"] += 1
        counts["bridges"] += crossing
    return faults


def rounded_bars(judge: Judge) -> list[Bar]:
    """Bars of the first judge, in doubles."""

    def told(level: int) -> float:
        square = judge.squared_radius(level)
        return float("inf") if square is None else float(square) ** 0.5

    return [(told(low), told(high)) for low, high in judge.bars()]


def reference_bars(found: _core.Features) -> list[Bar]:
    """Bars of the reference, in doubles."""

    def told(number: int | None) -> float:
        if number is None:
            return float("inf")
        low, high = found.radius(number)
        return (low + high) / 2

    return [(told(birth), told(death)) for _, birth, death, *_ in found.bars()]


def diagram_faults(
    name: str, P: _core.PolygonSet, bars: Sequence[Bar], library: DiagramJudge, table: Table
) -> None:
    """Compares bars with those along a library's diagram."""
    outline = Outline.of(P)
    graph = library.graph(outline)
    if isinstance(graph, str):
        table.unanswered.append(f"{name}: {library.judge}: {graph}")
        return
    table.counts[f"sets before {library.judge}"] += 1
    alone = unmatched(outline, bars, bars_of(outline, graph))
    if alone:
        table.faults.append(f"{name}: {library.judge}: bars without a partner: {alone[:4]}")
