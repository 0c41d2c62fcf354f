"""Squared distances in the plane, in rational numbers, and points in polygons."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

Point = tuple[Any, Any]
Ring = Sequence[Point]
Segment = tuple[Point, Point]


def edges(rings: Iterable[Ring]) -> Iterator[Segment]:
    for ring in rings:
        if len(ring) == 1:
            yield ring[0], ring[0]
        for k in range(len(ring) if len(ring) > 2 else len(ring) - 1):
            yield ring[k], ring[(k + 1) % len(ring)]


def to_segment(p: Point, segment: Segment) -> Any:
    """The squared distance of a point from a segment, which may be a point."""
    (ax, ay), (bx, by) = segment
    ux, uy, vx, vy = bx - ax, by - ay, p[0] - ax, p[1] - ay
    along, norm = ux * vx + uy * vy, ux * ux + uy * uy
    if along <= 0:
        return vx * vx + vy * vy
    if along >= norm:
        return (p[0] - bx) ** 2 + (p[1] - by) ** 2
    across = ux * vy - uy * vx
    return across * across / norm


def side(a: Point, b: Point, c: Point) -> int:
    value = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return int(value > 0) - int(value < 0)


def cross(one: Segment, other: Segment) -> bool:
    """Whether two segments cross at a point inside both."""
    return (
        side(*one, other[0]) * side(*one, other[1]) < 0
        and side(*other, one[0]) * side(*other, one[1]) < 0
    )


def apart(one: Segment, other: Segment) -> Any:
    """The squared distance between two segments."""
    if cross(one, other):
        return 0
    ends = [(end, other) for end in one] + [(end, one) for end in other]
    return min(to_segment(*pair) for pair in ends)


def within(p: Point, rings: Iterable[Ring]) -> bool:
    """Whether a point lies inside the rings by the even-odd rule; points on a ring may count either
    way. Segments and points bound nothing."""
    inside = False
    for (ax, ay), (bx, by) in edges(ring for ring in rings if len(ring) > 2):
        if (ay > p[1]) != (by > p[1]):
            at = (bx - ax) * (p[1] - ay) - (p[0] - ax) * (by - ay)
            inside ^= (at > 0) == (by > ay)
    return inside
