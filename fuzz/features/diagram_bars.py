"""Bars of features by union and find along the edges of a library's Voronoi diagram, in doubles.
However ties are broken, bars change only as much as radii are rounded; shorter bars are dropped."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from minkref.fuzz.features.outer_diagram import DiagramEdge, DiagramGraph
from minkref.fuzz.features.outline import Feature, Outline

NEAR = 1e-9  # times size or radius: differences by rounding
Bar = tuple[float, float]
Spot = tuple[float, float]


def bars_of(outline: Outline, graph: DiagramGraph) -> list[Bar]:
    """All bars longer than rounding, sorted."""
    heights = _Heights(outline, graph)
    bars = heights.bars()
    return sorted(bar for bar in bars if bar[1] - bar[0] > _slack(outline, bar[0]))


def unmatched(outline: Outline, mine: Sequence[Bar], others: Sequence[Bar]) -> list[Bar]:
    """Bars of either list without a partner."""
    left = list(others)
    found = []
    for bar in mine:
        if bar[1] - bar[0] <= _slack(outline, bar[0]):
            continue
        partner = next((o for o in left if _is_same(outline, bar, o)), None)
        if partner is None:
            found.append(bar)
        else:
            left.remove(partner)
    return [*found, *left]


def _is_same(outline: Outline, a: Bar, b: Bar) -> bool:
    return all(p == q or abs(p - q) <= _slack(outline, p) for p, q in zip(a, b, strict=True))


def _slack(outline: Outline, radius: float) -> float:
    return NEAR * (outline.size + (radius if radius < math.inf else 0.0))


@dataclass
class _Node:
    value: float
    beside: list[int]


class _Heights:
    """The medial axis with distances: nodes are vertices outside, reflex ends, lowest points of
    edges, and infinity, the first."""

    def __init__(self, outline: Outline, graph: DiagramGraph) -> None:
        self.outline = outline
        self.nodes = [_Node(math.inf, [])]
        number: dict[int, int] = {}
        for k, (x, y, radius) in enumerate(graph.places):
            if radius > NEAR * outline.size and outline.is_outside(x, y):
                number[k] = self._add(radius)
        ends = self._ends()
        for edge in graph.edges:
            if _touch(edge, ends):
                continue
            finite = [number[k] for k in edge.ends if k in number]
            if not finite:
                continue
            spots = [graph.places[k][:2] for k in edge.ends if k in number]
            if edge.is_infinite:
                finite.append(0)
            elif len(finite) == 1:
                finite.append(self._add(0.0))
            low = self._lowest(edge, spots)
            if low is not None and all(low < self.nodes[k].value for k in finite):
                middle = self._add(low)
                self._join(middle, finite[0])
                self._join(middle, finite[1])
            else:
                self._join(*finite)

    def _add(self, value: float) -> int:
        self.nodes.append(_Node(value, []))
        return len(self.nodes) - 1

    def _join(self, a: int, b: int) -> None:
        self.nodes[a].beside.append(b)
        self.nodes[b].beside.append(a)

    def _ends(self) -> set[tuple[Feature, Feature]]:
        return {
            (piece.line, ("vertex", *end))
            for piece in self.outline.pieces
            for end in (piece.start, piece.end)
        }

    def _lowest(self, edge: DiagramEdge, spots: list[Spot]) -> float | None:
        """The distance at the bisector's lowest point, if that lies between the ends."""
        first, second = edge.sites
        if second[0] == "line":
            first, second = second, first
        if second[0] == "line":
            return None
        x, y = float(second[1]), float(second[2])
        if first[0] == "vertex":
            u, v = float(first[1]), float(first[2])
            wx, wy = y - v, u - x
            low = math.hypot(u - x, v - y) / 2
        else:
            _, dx, dy, c = first
            size = math.hypot(dx, dy)
            wx, wy = dx / size, dy / size
            low = abs(dy * x - dx * y - float(c)) / size / 2
            u, v = x, y
        middle = (u + x) / 2, (v + y) / 2
        along = [(p - middle[0]) * wx + (q - middle[1]) * wy for p, q in spots]
        if edge.is_infinite:
            along.append(self._outwards((u, v), (x, y), (wx, wy)))
        return low if len(along) == 2 and along[0] * along[1] < 0 else None

    def _outwards(self, a: Spot, b: Spot, way: Spot) -> float:
        """The sign of a way across a side of the hull: positive outwards."""
        corners = [(float(x), float(y)) for ring in self.outline.rings for x, y in ring]
        sides = [(x - a[0]) * way[0] + (y - a[1]) * way[1] for x, y in corners]
        return -max(sides, key=abs)

    def bars(self) -> list[Bar]:
        up = list(range(len(self.nodes)))
        births = [node.value for node in self.nodes]
        greatest = list(births)

        def find(k: int) -> int:
            while up[k] != k:
                up[k] = up[up[k]]
                k = up[k]
            return k

        found: list[Bar] = []
        done = set()
        for k in sorted(range(len(self.nodes)), key=lambda k: self.nodes[k].value):
            done.add(k)
            for other in self.nodes[k].beside:
                if other not in done:
                    continue
                a, b = find(k), find(other)
                if a == b:
                    continue
                if births[a] > births[b]:
                    a, b = b, a
                found.append((births[b], self.nodes[k].value))
                up[b] = a
                greatest[a] = max(greatest[a], greatest[b])
        roots = {find(k) for k in range(1, len(self.nodes))}
        return found + [(births[k], greatest[k]) for k in roots]


def _touch(edge: DiagramEdge, ends: set[tuple[Feature, Feature]]) -> bool:
    """Whether a site is an end of the second: both have one nearest point."""
    a, b = edge.sites
    return (a, b) in ends or (b, a) in ends
