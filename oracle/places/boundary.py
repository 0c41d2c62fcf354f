"""A polygon set's boundary, and its points nearest to a place: from the definition, edge by
edge."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from math import hypot
from typing import TypeAlias

from .surd import Surd, surd

Point: TypeAlias = tuple[Fraction, Fraction]
Place: TypeAlias = tuple[Surd, Surd]
Way: TypeAlias = tuple[Surd, Surd]
Name: TypeAlias = tuple[object, ...]  # "vertex", x, y; "edge", ring, number

# Doubles only leave out edges clearly farther away than the nearest, by this part of the largest
# coordinate. The doubles' own relative errors are about 1e-15.
CLEARLY = 1e-9


@dataclass(frozen=True)
class Edge:
    """An edge from `a` to `b`, the set on the left, named by ring and by the number of `a` in the
    ring."""

    ring: int
    index: int
    polygon: int
    a: Point
    b: Point

    @property
    def name(self) -> tuple[int, int]:
        return self.ring, self.index

    @cached_property
    def along(self) -> Point:
        return self.b[0] - self.a[0], self.b[1] - self.a[1]

    @cached_property
    def squared_length(self) -> Fraction:
        return self.along[0] ** 2 + self.along[1] ** 2

    @cached_property
    def rounded(self) -> tuple[float, float, float, float, float]:
        x, y = map(float, self.a)
        dx, dy = map(float, self.along)
        return x, y, dx, dy, dx * dx + dy * dy

    def rounded_distance(self, x: float, y: float) -> float:
        ax, ay, dx, dy, square = self.rounded
        t = ((x - ax) * dx + (y - ay) * dy) / square
        t = 0.0 if t < 0 else 1.0 if t > 1 else t
        return hypot(x - ax - t * dx, y - ay - t * dy)


@dataclass
class Foot:
    """A nearest point: a vertex, or inside an edge. `square` lists edges that contain the point and
    that the place sees from the front at a right angle there."""

    at: Place
    vertex: Point | None
    square: list[Edge] = field(default_factory=list)

    def names(self) -> list[set[Name]]:
        """List the sets of features that name this foot: the edge, or the vertex and the edges that
        end at right angles there. Where an edge goes straight on, the vertex is no feature, and the
        part that ends there gives the name."""
        edges: set[Name] = {("edge", *edge.name) for edge in self.square}
        if self.vertex is None:
            return [edges]
        inside = [e for e in self.square if self.vertex not in (e.a, e.b)]
        if inside:
            return [{("edge", *e.name)} for e in inside]
        for edge in self.square:
            straight = [e for e in self.square if _are_straight(edge, e)]
            if straight:
                ending = [e for e in (edge, *straight) if e.b == self.vertex]
                return [{("edge", *e.name)} for e in ending]
        return [{("vertex", *self.vertex), *edges}]


def _are_straight(e: Edge, f: Edge) -> bool:
    (x, y), (u, v) = e.along, f.along
    return e is not f and x * v == y * u and x * u + y * v > 0


class Boundary:
    """Rings by polygon, the outer ring first, the set on the left."""

    def __init__(self, polygons: Sequence[Sequence[Sequence[Point]]]) -> None:
        self.edges: list[Edge] = []
        ring = 0
        for number, polygon in enumerate(polygons):
            for corners in polygon:
                points = [(Fraction(x), Fraction(y)) for x, y in corners]
                for k, a in enumerate(points):
                    b = points[(k + 1) % len(points)]
                    self.edges.append(Edge(ring, k, number, a, b))
                ring += 1
        self.polygons = len(polygons)
        self.vertices = sorted({edge.a for edge in self.edges})
        largest = max((abs(c) for p in self.vertices for c in p), default=Fraction(1))
        self.slack = CLEARLY * max(1.0, float(largest))
        self.names = {edge.name: edge for edge in self.edges}

    def is_near(self, x: float, y: float, reach: float) -> bool:
        """Tell whether some edge is clearly nearer than `reach`, in doubles."""
        clearly = reach - self.slack
        return any(edge.rounded_distance(x, y) < clearly for edge in self.edges)

    def nearest(self, place: Place) -> tuple[Surd, list[Foot]]:
        """Find the boundary's squared distance, and all nearest points. Exact."""
        x, y = map(float, place)
        far = [edge.rounded_distance(x, y) for edge in self.edges]
        reach = min(far) + self.slack
        least: Surd | None = None
        found: list[tuple[Surd, Foot, Edge, bool]] = []
        for edge, distance in zip(self.edges, far, strict=True):
            if distance > reach:
                continue
            square, foot, is_square = _foot(edge, place)
            if least is None or (square - least).sign() < 0:
                least = square
            found.append((square, foot, edge, is_square))
        assert least is not None
        feet: list[Foot] = []
        for square, foot, edge, is_square in found:
            if (square - least).sign() > 0:
                continue
            known = next((f for f in feet if _are_same(f.at, foot.at)), None)
            if known is None:
                known = foot
                feet.append(foot)
            known.vertex = known.vertex or foot.vertex
            if is_square:
                known.square.append(edge)
        return least, feet

    def is_outside(self, place: Place) -> bool:
        """Tell whether a place off the boundary is outside, by counting edges to its right.
        Exact."""
        x, y = place
        height, inside = float(y), False
        for edge in self.edges:
            low, high = sorted((edge.rounded[1], edge.rounded[1] + edge.rounded[3]))
            if not low - self.slack <= height <= high + self.slack:
                continue
            a, b = ((y - surd(p[1])).sign() < 0 for p in (edge.a, edge.b))
            if a == b:
                continue
            (ax, ay), (dx, dy) = edge.a, edge.along
            turn = (x - surd(ax)).times(dy) - (y - surd(ay)).times(dx)
            if turn.sign() * (1 if dy > 0 else -1) < 0:
                inside = not inside
        return not inside


def _foot(edge: Edge, place: Place) -> tuple[Surd, Foot, bool]:
    """Find an edge's nearest point, and whether the place sees it from the front at a right
    angle."""
    (ax, ay), (dx, dy) = edge.a, edge.along
    wx, wy = place[0] - surd(ax), place[1] - surd(ay)
    part = wx.times(dx) + wy.times(dy)
    after = (part - surd(edge.squared_length)).sign()
    side = wx.times(dy) - wy.times(dx)  # positive in front: the set is on the left
    if part.sign() > 0 and after < 0:
        t = part.times(1 / edge.squared_length)
        at = surd(ax) + t.times(dx), surd(ay) + t.times(dy)
        return (side * side).times(1 / edge.squared_length), Foot(at, None), side.sign() > 0
    vertex = edge.a if part.sign() <= 0 else edge.b
    vx, vy = place[0] - surd(vertex[0]), place[1] - surd(vertex[1])
    is_square = (part.sign() == 0 or after == 0) and side.sign() > 0
    at = surd(vertex[0]), surd(vertex[1])
    return vx * vx + vy * vy, Foot(at, vertex), is_square


def _are_same(p: Place, q: Place) -> bool:
    return all((a - b).sign() == 0 for a, b in zip(p, q, strict=True))


def ways(place: Place, feet: Sequence[Foot]) -> list[Way]:
    """Return the ways from a place to its nearest points."""
    return [(foot.at[0] - place[0], foot.at[1] - place[1]) for foot in feet]


def turn(u: Way, v: Way) -> int:
    return (u[0] * v[1] - u[1] * v[0]).sign()


def are_opposite(u: Way, v: Way) -> bool:
    return turn(u, v) == 0 and (u[0] * v[0] + u[1] * v[1]).sign() < 0


def surround(all_ways: Sequence[Way]) -> bool:
    """Tell whether ways leave less than half a turn free between neighbours: then the distance has
    a local maximum at the place."""
    for u in all_ways:
        # The first way to the left of u, up to half a turn.
        if not any(turn(u, v) > 0 for v in all_ways):
            return False
    return len(all_ways) > 2
