"""Degeneracies between sets: meeting edges and vertices, overlaps, signs wrong in doubles."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache, cached_property
from itertools import combinations
from math import lcm

from minkref import _core
from minkref.certify.case_text import places, ring_numbers

Number = int | Fraction
Spot = tuple[Number, Number]  # in units in which vertices are whole numbers
Name = tuple[int, int]  # a set and its vertex, or its edge that begins there


@dataclass(frozen=True)
class Edge:
    name: Name
    end: int  # the number of the vertex b
    a: Spot
    b: Spot

    @cached_property
    def box(self) -> tuple[Number, Number, Number, Number]:
        """The least x and y, and the greatest."""
        (x, y), (z, w) = self.a, self.b
        return min(x, z), min(y, w), max(x, z), max(y, w)

    def is_near(self, other: Edge) -> bool:
        """Whether the boxes have a point in common."""
        a, b = self.box, other.box
        return a[0] <= b[2] and b[0] <= a[2] and a[1] <= b[3] and b[1] <= a[3]


@dataclass
class Meeting:
    """Meeting vertices, and edges with the point inside."""

    vertices: set[Name] = field(default_factory=set)
    edges: set[Name] = field(default_factory=set)

    @property
    def is_degenerate(self) -> bool:
        """Whether small motions undo it: vertices meet other sets, or three edges meet."""
        named = self.vertices | self.edges
        return len({k for k, _ in named}) > 1 and (bool(self.vertices) or len(self.edges) > 2)


class Edges:
    """Edges, and their degeneracies. O(n^2) tests of boxes for n edges."""

    def __init__(self, sets: Sequence[_core.PolygonSet]) -> None:
        points = list(map(places, sets))
        self.unit = lcm(*(c.denominator for one in points for p in one for c in p))
        self.all: list[Edge] = []
        for k, one in enumerate(sets):
            whole = [(int(x * self.unit), int(y * self.unit)) for x, y in points[k]]
            for ring in ring_numbers(one):
                ends = zip(ring, [*ring[1:], *ring[:1]], strict=True)
                self.all += [Edge((k, i), j, whole[i], whole[j]) for i, j in ends]

    def told(self, point: Spot) -> list[str]:
        """The coordinates of a point."""
        return [str(Fraction(c) / self.unit) for c in point]

    @cached_property
    def _near(self) -> list[tuple[Edge, Edge]]:
        """Pairs whose boxes meet, from different sets."""
        return [
            (one, other)
            for one, other in combinations(self.all, 2)
            if one.name[0] != other.name[0] and one.is_near(other)
        ]

    def meetings(self) -> dict[Spot, Meeting]:
        """All degenerate points, in order."""
        found: defaultdict[Spot, Meeting] = defaultdict(Meeting)
        for one, other in self._near:
            for point in _common(one, other):
                for edge in (one, other):
                    if point == edge.a:
                        found[point].vertices.add(edge.name)
                    elif point != edge.b:
                        found[point].edges.add(edge.name)
        for edge in self.all:  # it may be met as the end of the edge before only
            if edge.a in found:
                found[edge.a].vertices.add(edge.name)
        return {point: found[point] for point in sorted(found) if found[point].is_degenerate}

    def overlaps(self) -> Iterator[tuple[Edge, Edge, int]]:
        """Yields, for each edge, the first later one of another set that has a stretch in common;
        1 if they run the same way, else -1."""
        seen: set[Name] = set()
        for one, other in self._near:
            if one.name not in seen and len(set(_common(one, other))) > 1:
                seen.add(one.name)
                yield one, other, 1 if (one.a < one.b) == (other.a < other.b) else -1

    def wrong_in_doubles(self) -> Iterator[tuple[Edge, Edge, int]]:
        """Yields an edge, another set's edge, and the true sign of its beginning's side, which
        doubles get wrong."""
        for edge in self.all:
            for other in self.all:
                if edge.name[0] == other.name[0]:
                    continue
                exact = turn(edge.a, edge.b, other.a)
                sign = (exact > 0) - (exact < 0)
                if sign != self._sign_of_doubles(edge.a, edge.b, other.a):
                    yield edge, other, sign

    def _sign_of_doubles(self, *points: Spot) -> int:
        (ax, ay), (bx, by), (cx, cy) = map(self._near_to, points)
        value = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        return (value > 0) - (value < 0)

    @cache  # noqa: B019  # as long as the edges
    def _near_to(self, point: Spot) -> tuple[float, float]:
        x, y = (float(Fraction(c) / self.unit) for c in point)
        return x, y


def turn(a: Spot, b: Spot, c: Spot) -> Number:
    """Twice the area of a triangle, positive if it runs counter-clockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _common(one: Edge, other: Edge) -> list[Spot]:
    """The meeting point, or both ends of a common stretch."""
    (a, b), (c, d) = (one.a, one.b), (other.a, other.b)
    first, last = turn(c, d, a), turn(c, d, b)
    if first == last:
        ends = [p for p in (a, b) if _is_on(other, p)] + [p for p in (c, d) if _is_on(one, p)]
        return ends if first == 0 else []
    if (first > 0 < last) or (first < 0 > last):
        return []
    t = Fraction(first) / (first - last)
    point = a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])
    return [point] if _is_in_box(other, point) else []


def _is_on(edge: Edge, p: Spot) -> bool:
    return turn(edge.a, edge.b, p) == 0 and _is_in_box(edge, p)


def _is_in_box(edge: Edge, p: Spot) -> bool:
    x, y, z, w = edge.box
    return x <= p[0] <= z and y <= p[1] <= w
