"""Squared distances between segments, as fractions."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise

Point = tuple[Fraction, Fraction]
Segment = tuple[Point, Point]
Ring = Sequence[Point]


def edges_of(ring: Ring) -> Iterator[Segment]:
    """Yield the closed edges of a ring; a point is an edge of its own."""
    for k, point in enumerate(ring):
        yield point, ring[(k + 1) % len(ring)]


def legs_of(path: Sequence[Point]) -> Iterator[Segment]:
    """Yield the segments of a polyline; a single vertex is one."""
    if len(path) == 1:
        yield path[0], path[0]
    yield from pairwise(path)


def squared_to_segment(p: Point, segment: Segment) -> Fraction:
    """Return a point's squared distance from a closed segment."""
    (ax, ay), (bx, by) = segment
    dx, dy, px, py = bx - ax, by - ay, p[0] - ax, p[1] - ay
    length = dx * dx + dy * dy
    along = px * dx + py * dy
    if length == 0 or along <= 0:
        return px * px + py * py
    if along >= length:
        return (p[0] - bx) ** 2 + (p[1] - by) ** 2
    return (px * dy - py * dx) ** 2 / length


def side(a: Point, b: Point, p: Point) -> int:
    """Tell on which side of the line from a to b a point lies: 1 on the left."""
    turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    return (turn > 0) - (turn < 0)


def squared_between(first: Segment, second: Segment) -> Fraction:
    """Return the squared distance of two closed segments, 0 if they meet."""
    (a, b), (c, d) = first, second
    if side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0:
        return Fraction(0)
    return min(
        squared_to_segment(a, second),
        squared_to_segment(b, second),
        squared_to_segment(c, first),
        squared_to_segment(d, first),
    )


def is_inside(rings: Sequence[Ring], p: Point) -> bool:
    """Tell whether a point lies strictly inside: winding number not 0, and on no edge."""
    winding = 0
    for ring in rings:
        for a, b in edges_of(ring):
            if squared_to_segment(p, (a, b)) == 0:
                return False
            if (a[1] <= p[1]) != (b[1] <= p[1]) and (side(a, b, p) > 0) == (b[1] > a[1]):
                winding += 1 if b[1] > a[1] else -1
    return winding != 0


def path_distance(rings: Sequence[Ring], path: Sequence[Point]) -> Fraction:
    """Return the squared distance of a polyline and a set: 0 if they meet. All pairs."""
    if is_inside(rings, path[0]):
        return Fraction(0)
    return min(
        squared_between(leg, edge)
        for leg in legs_of(path)
        for ring in rings
        for edge in edges_of(ring)
    )
