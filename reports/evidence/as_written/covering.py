"""Whether polygons as written lie in, or around, the points within a radius of a set.

A point belongs to the sum with a disc iff its distance from the set is at most the radius.
Distances between rational points and edges have rational squares, so rational numbers decide most
edges: a segment belongs to the sum if both ends lie near the same edge of the set, for the points
near an edge form a convex set. Other segments are cut into the intervals that each edge covers, in
numbers of 1,500 bits.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any

import gmpy2
from minkref.reports.evidence.as_written.distance import (
    Point,
    Ring,
    Segment,
    apart,
    edges,
    to_segment,
    within,
)
from minkref.reports.evidence.as_written.units import TIE, Real

Interval = tuple[Real, Real]


class Neighbourhood:
    """The points within a radius of a set, given as rings and the squared radius."""

    def __init__(self, rings: Sequence[Ring], squared: Real) -> None:
        self.rings = rings
        self.squared = squared
        self.edges = list(edges(rings))

    def near(self, p: Point) -> frozenset[int]:
        """The edges within the radius of a point, by number."""
        found = (k for k, edge in enumerate(self.edges) if to_segment(p, edge) <= self.squared)
        return frozenset(found)

    def has(self, p: Point) -> bool:
        return any(to_segment(p, e) <= self.squared for e in self.edges) or within(p, self.rings)

    def outside_of(self, rings: Iterable[Ring]) -> list[Segment]:
        """Edges of the rings that lie partly outside the neighbourhood."""
        return [segment for ring in rings for segment in self._outside(ring)]

    def _outside(self, ring: Ring) -> list[Segment]:
        near = [self.near(p) for p in ring]
        return [
            (ring[k - 1], ring[k])
            for k in range(len(ring))
            if not near[k - 1] & near[k] and not self._covers((ring[k - 1], ring[k]))
        ]

    def _covers(self, segment: Segment) -> bool:
        covered = [found for edge in self.edges if (found := self._interval(segment, edge))]
        covered += self._inner(segment)
        reach: Real = gmpy2.mpq(0)
        for start, end in sorted(covered):
            if start > reach + TIE:
                return False
            reach = max(reach, end)
        return bool(reach >= 1 - TIE)

    def _interval(self, segment: Segment, edge: Segment) -> Interval | None:
        """The part of a segment, from 0 to 1, within the radius of an edge."""
        parts = [_in_disc(segment, end, self.squared) for end in edge]
        parts.append(_in_strip(segment, edge, self.squared))
        found = [part for part in parts if part]
        if not found:
            return None
        return min(part[0] for part in found), max(part[1] for part in found)

    def _inner(self, segment: Segment) -> list[Interval]:
        """The parts of a segment inside the set."""
        (ax, ay), (bx, by) = segment
        ux, uy = bx - ax, by - ay
        cuts = {gmpy2.mpq(0), gmpy2.mpq(1)}
        for (px, py), (qx, qy) in self.edges:
            turn = ux * (qy - py) - uy * (qx - px)
            if turn:
                at = ((px - ax) * (qy - py) - (py - ay) * (qx - px)) / turn
                if 0 < at < 1:
                    cuts.add(at)
        places = sorted(cuts)
        return [
            (s, t)
            for s, t in pairwise(places)
            if within((ax + (s + t) / 2 * ux, ay + (s + t) / 2 * uy), self.rings)
        ]

    def met_by(self, rings: Iterable[Ring]) -> list[Segment]:
        """The rings' edges that pass through the neighbourhood's interior; exact."""
        return [
            segment
            for segment in edges(rings)
            if within(segment[0], self.rings)
            or any(apart(segment, edge) < self.squared for edge in self.edges)
        ]


def _in_disc(segment: Segment, centre: Point, squared: Real) -> Interval | None:
    (ax, ay), (bx, by) = segment
    ux, uy, vx, vy = bx - ax, by - ay, ax - centre[0], ay - centre[1]
    norm, half = ux * ux + uy * uy, ux * vx + uy * vy
    if norm == 0:
        return (gmpy2.mpq(0), gmpy2.mpq(1)) if vx * vx + vy * vy <= squared else None
    left = half * half - norm * (vx * vx + vy * vy - squared)
    if left < 0:
        return None
    root = gmpy2.sqrt(gmpy2.mpfr(left))
    return _clipped((-half - root) / norm, (-half + root) / norm)


def _in_strip(segment: Segment, edge: Segment, squared: Real) -> Interval | None:
    """The part right beside an edge, between the normals at its ends."""
    (px, py), (qx, qy) = edge
    ex, ey = qx - px, qy - py
    norm = ex * ex + ey * ey
    if norm == 0:
        return None
    along = [ex * (x - px) + ey * (y - py) for x, y in segment]
    across = [ex * (y - py) - ey * (x - px) for x, y in segment]
    wide = gmpy2.sqrt(gmpy2.mpfr(squared * norm))
    found = _between(along, gmpy2.mpq(0), norm)
    other = _between(across, -wide, wide)
    if not found or not other:
        return None
    return _clipped(max(found[0], other[0]), min(found[1], other[1]))


def _between(ends: Sequence[Any], low: Real, high: Real) -> Interval | None:
    """The interval where a linear function with these values at 0 and 1 lies between two bounds."""
    a, b = ends
    if a == b:
        return (gmpy2.mpq(0), gmpy2.mpq(1)) if low <= a <= high else None
    s, t = (low - a) / (b - a), (high - a) / (b - a)
    return _clipped(min(s, t), max(s, t))


def _clipped(start: Real, end: Real) -> Interval | None:
    start, end = max(start, gmpy2.mpq(0)), min(end, gmpy2.mpq(1))
    return (start, end) if start <= end else None
