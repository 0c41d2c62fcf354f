"""Bridges: ways between two boundary points whose discs, with the bridge as diameter, contain no
boundary point. Holes fall apart, and components join, only at half a bridge's length as radius."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, pairwise
from math import sqrt

from .boundary import Boundary, Edge, Point, surround, ways
from .surd import surd


@dataclass(frozen=True)
class Bridge:
    """A bridge between boundary points `a` and `b`. Parallel edges have many bridges, all equally
    long: this bridge then stands for all, and `flat` has the ends, in doubles, of the line of
    middles."""

    a: Point
    b: Point
    flat: tuple[tuple[float, float], tuple[float, float]] | None = None

    @property
    def middle(self) -> Point:
        return (self.a[0] + self.b[0]) / 2, (self.a[1] + self.b[1]) / 2

    @property
    def square(self) -> Fraction:
        """The square of half the length."""
        return ((self.a[0] - self.b[0]) ** 2 + (self.a[1] - self.b[1]) ** 2) / 4

    @property
    def ends(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """The ends of `flat`, or the middle twice, in doubles."""
        return self.flat or ((float(self.middle[0]), float(self.middle[1])),) * 2

    def is_at(self, x: float, y: float, slack: float) -> bool:
        """Tell whether a middle of this bridge lies at a place, in doubles."""
        p, q = self.ends
        dx, dy = q[0] - p[0], q[1] - p[1]
        square = dx * dx + dy * dy
        t = ((x - p[0]) * dx + (y - p[1]) * dy) / square if square else 0.0
        t = min(max(t, 0.0), 1.0)
        return abs(p[0] + t * dx - x) + abs(p[1] + t * dy - y) <= slack


def bridges(boundary: Boundary) -> list[Bridge]:
    """Find all bridges, each once, except over a local maximum of the distance, where neither side
    has a point farther away. Exact. O(n^3) for n edges."""
    found: dict[frozenset[Point], Bridge] = {}
    for bridge in _candidates(boundary):
        key = frozenset((bridge.a, bridge.b))
        if key not in found and _is_free(boundary, bridge):
            found[key] = bridge
    return list(found.values())


def _candidates(boundary: Boundary) -> Iterator[Bridge]:
    for p, q in combinations(boundary.vertices, 2):
        yield Bridge(p, q)
    for edge in boundary.edges:
        for p in boundary.vertices:
            foot = _foot_inside(edge, p)
            if foot is not None and foot != p:
                yield Bridge(p, foot)
    for e, f in combinations(boundary.edges, 2):
        yield from _across(boundary, e, f)


def _foot_inside(edge: Edge, p: Point) -> Point | None:
    (ax, ay), (dx, dy) = edge.a, edge.along
    part = (p[0] - ax) * dx + (p[1] - ay) * dy
    if not 0 < part < edge.squared_length:
        return None
    t = part / edge.squared_length
    return ax + t * dx, ay + t * dy


def _across(boundary: Boundary, e: Edge, f: Edge) -> Iterator[Bridge]:
    """Find bridges between facing parallel edges, one for each free stretch."""
    (dx, dy), (ux, uy), (ax, ay) = e.along, f.along, e.a
    if dx * uy != dy * ux or dx * ux + dy * uy > 0:
        return
    height = (f.a[0] - ax) * dy - (f.a[1] - ay) * dx  # positive in front
    if height <= 0:
        return
    square = e.squared_length
    ends = [((p[0] - ax) * dx + (p[1] - ay) * dy) / square for p in (f.a, f.b)]
    low, high = max(Fraction(0), min(ends)), min(Fraction(1), max(ends))
    if low >= high:
        return
    up = height / square  # times (dy, -dx)

    def bridge(t: Fraction) -> Bridge:
        x, y = ax + t * dx, ay + t * dy
        return Bridge((x, y), (x + up * dy, y - up * dx))

    def middle(t: float) -> tuple[float, float]:
        x, y = bridge(Fraction(t)).middle
        return float(x), float(y)

    stops = _stops(boundary, bridge, float(low), float(high))
    stretch: list[float] = []
    for t, u in [*pairwise(stops), (1.0, 1.0)]:
        free = t < u and _is_free(boundary, bridge(Fraction(t + u) / 2))
        if free:
            stretch = stretch or [t, u, t, u]  # begin, end, and the first free piece
            stretch[1] = u
        elif stretch:
            told = bridge(Fraction(stretch[2] + stretch[3]) / 2)
            yield Bridge(told.a, told.b, (middle(stretch[0]), middle(stretch[1])))
            stretch = []


def _stops(
    boundary: Boundary, bridge: Callable[[Fraction], Bridge], low: float, high: float
) -> list[float]:
    """Find where a stretch may begin or end, in doubles: where the distance from a vertex or an
    edge equals half the bridge's length."""
    first, last = bridge(Fraction(low)), bridge(Fraction(high))
    (px, py), (qx, qy) = (tuple(map(float, b.middle)) for b in (first, last))
    radius = sqrt(float(first.square))
    wx, wy = qx - px, qy - py
    length = sqrt(wx * wx + wy * wy)
    wx, wy = wx / length, wy / length
    found = []
    for x, y in boundary.vertices:
        vx, vy = float(x) - px, float(y) - py
        along, off = vx * wx + vy * wy, vx * wy - vy * wx
        if abs(off) < radius:
            half = sqrt(radius * radius - off * off)
            found += [along - half, along + half]
    for edge in boundary.edges:
        dx, dy = (float(c) for c in edge.along)
        size = sqrt(dx * dx + dy * dy)
        slope = (wx * dy - wy * dx) / size
        if abs(slope) > 1e-12:
            height = ((px - float(edge.a[0])) * dy - (py - float(edge.a[1])) * dx) / size
            found += [(radius - height) / slope, (-radius - height) / slope]
    inside = sorted(s / length for s in found if 0 < s < length)
    stops = [low, *(low + (high - low) * s for s in inside), high]
    return [t for k, t in enumerate(stops) if k == 0 or t - stops[k - 1] > 1e-12]


def _is_free(boundary: Boundary, bridge: Bridge) -> bool:
    """Tell whether a bridge is free: no boundary inside its disc, its middle outside the set and no
    local maximum of the distance."""
    x, y = bridge.middle
    if boundary.is_near(float(x), float(y), sqrt(float(bridge.square))):
        return False
    place = surd(x), surd(y)
    square, feet = boundary.nearest(place)
    if (square - surd(bridge.square)).sign() != 0 or not boundary.is_outside(place):
        return False
    return not surround(ways(place, feet))
