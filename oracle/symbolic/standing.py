"""Common points of segments at one scale, from the definition: the points that lie on each.

Nothing here knows that the segments move. This module decides all memberships in this package.
"""

from __future__ import annotations

from .moving import Point, Segment, cross

Common = Segment | None
"""The common points: none, or the segment between two points, equal where it is one point."""


def minus(a: Point, b: Point) -> Point:
    return a[0] - b[0], a[1] - b[1]


def on(point: Point, segment: Segment) -> bool:
    """Tell whether the point lies on the closed segment: on its line, and between its ends."""
    a, b = segment
    along, off = minus(b, a), minus(point, a)
    if not any(along):
        return point == a
    reach = along[0] * off[0] + along[1] * off[1]
    return cross(along, off) == 0 and 0 <= reach <= along[0] ** 2 + along[1] ** 2


def common(first: Segment, second: Segment) -> Common:
    """Return all points on both segments: exact. A segment may be a single point. Constant time."""
    u, v = minus(first[1], first[0]), minus(second[1], second[0])
    c = cross(u, v)
    if c != 0:
        # first[0] + t u = second[0] + w v, by Cramer's rule.
        off = minus(second[0], first[0])
        t, w = cross(off, v) / c, cross(off, u) / c
        if not (0 <= t <= 1 and 0 <= w <= 1):
            return None
        x = (first[0][0] + t * u[0], first[0][1] + t * u[1])
        return x, x
    # On parallel segments, each segment's ends on the other bound the common points.
    ends = {point for point in first if on(point, second)}
    ends |= {point for point in second if on(point, first)}
    return (min(ends), max(ends)) if ends else None


def common_to_three(first: Segment, second: Segment, third: Segment) -> Common:
    """Return all points on all three segments: exact."""
    shared = common(first, second)
    return None if shared is None else common(shared, third)
