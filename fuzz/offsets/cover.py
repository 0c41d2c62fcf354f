"""Whether neighbourhoods of segments cover a segment: exact, in roots.

All points within r of a segment form a convex set, two half discs and a rectangle, so a line meets
it in an interval, whose ends are numbers a + b sqrt(c).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction

from minkref.fuzz.geometry.plane import cross, dot, minus
from minkref.fuzz.geometry.surds import Surd, between
from minkref.fuzz.offsets.distance import Exact, ExactEdge

Interval = tuple[Surd, Surd]
ZERO, ONE = Surd(Fraction(0)), Surd(Fraction(1))


def uncovered(a: Exact, b: Exact, near: Iterable[ExactEdge], r: Fraction) -> Iterator[Exact]:
    """Yields a rational point of each part of the segment a b (a not b) that is farther than r from
    all segments in `near`; nothing iff all points are within r."""
    intervals = (interval for edge in near for interval in _interval(a, b, edge, r))
    reach = ZERO
    reached = False  # whether the point at `reach` is covered
    for low, high in sorted(intervals, key=_Low):
        if high < ZERO or ONE < low:
            continue
        if reach < low:
            yield _at(a, b, between(reach, low))
        if reach <= high or not reached:
            reach, reached = (high if reach <= high else reach), True
    if not reached:
        yield _at(a, b, Fraction(1, 2))
    elif reach < ONE:
        yield _at(a, b, between(reach, ONE))


class _Low:
    """Orders intervals by their lower ends."""

    def __init__(self, interval: Interval) -> None:
        self.low = interval[0]

    def __lt__(self, other: _Low) -> bool:
        return self.low < other.low


def _at(a: Exact, b: Exact, t: Fraction) -> Exact:
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))


def _interval(a: Exact, b: Exact, edge: ExactEdge, r: Fraction) -> list[Interval]:
    """Parameters t with a + t (b - a) within r of the segment: at most one interval."""
    u = minus(b, a)
    parts = [part for end in set(edge) for part in _within_disc(a, u, end, r)]
    if edge[0] != edge[1]:
        parts += _within_rectangle(a, u, edge, r)
    if not parts:
        return []
    low, high = parts[0]
    for left, right in parts[1:]:
        low, high = (left if left < low else low), (right if high < right else high)
    return [(low, high)]


def _within_disc(a: Exact, u: Exact, centre: Exact, r: Fraction) -> list[Interval]:
    way = minus(a, centre)
    square, half = Fraction(dot(u, u)), Fraction(dot(u, way))
    under = half * half - square * (dot(way, way) - r * r)
    if under < 0:
        return []
    middle, factor = -half / square, 1 / square
    return [(Surd(middle, -factor, under), Surd(middle, factor, under))]


def _within_rectangle(a: Exact, u: Exact, edge: ExactEdge, r: Fraction) -> list[Interval]:
    along = minus(edge[1], edge[0])
    way, length = minus(a, edge[0]), Fraction(dot(along, along))
    bounds: list[Interval] = []
    start, slope = Fraction(dot(way, along)), Fraction(dot(u, along))
    if slope:
        ends = sorted((-start / slope, (length - start) / slope))
        bounds.append((Surd(ends[0]), Surd(ends[1])))
    elif not 0 <= start <= length:
        return []
    off, rise = Fraction(cross(along, way)), Fraction(cross(along, u))
    if rise:
        middle, factor = -off / rise, r / abs(rise)
        bounds.append((Surd(middle, -factor, length), Surd(middle, factor, length)))
    elif off * off > r * r * length:
        return []
    low, high = bounds[0]
    for left, right in bounds[1:]:
        low, high = (left if low < left else low), (right if right < high else high)
    return [(low, high)] if low <= high else []
