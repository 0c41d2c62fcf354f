"""What segments and facets in space have in common at one scale, from the definition."""

from __future__ import annotations

from collections.abc import Sequence

from .rational import Rational
from .space_moving import Vector, cross, dot, minus

Segment3 = tuple[Vector, Vector]


def on_segment(x: Vector, segment: Segment3) -> bool:
    a, b = segment
    along, off = minus(b, a), minus(x, a)
    return not any(cross(along, off)) and 0 <= dot(along, off) <= dot(along, along)


def shared(first: Segment3, second: Segment3) -> Segment3 | None:
    """The common points of two closed segments, as those between two points. Exact."""
    u, v = minus(first[1], first[0]), minus(second[1], second[0])
    off, c = minus(second[0], first[0]), cross(u, v)
    if any(c):
        if dot(off, c) != 0:
            return None
        # first[0] + t u = second[0] + w v; the product with v, with u, leaves one unknown.
        t, w = dot(cross(off, v), c) / dot(c, c), dot(cross(off, u), c) / dot(c, c)
        if not (0 <= t <= 1 and 0 <= w <= 1):
            return None
        x = tuple(a + t * b for a, b in zip(first[0], u, strict=True))
        return x, x
    ends = {x for x in first if on_segment(x, second)} | {x for x in second if on_segment(x, first)}
    return (min(ends), max(ends)) if ends else None


def in_polygon(x: Vector, corners: Sequence[Vector]) -> bool:
    """Whether x lies in the closed planar simple polygon: on its plane and boundary, or on its
    plane and inside, by the crossings of a ray in a projection that keeps the plane. Exact."""
    sides = list(zip(corners, [*corners[1:], corners[0]], strict=True))
    if any(on_segment(x, side) for side in sides):
        return True
    a, b, c = corners[:3]
    normal = cross(minus(b, a), minus(c, a))
    if dot(normal, minus(x, a)) != 0:
        return False
    drop = next(i for i in range(3) if normal[i] != 0)
    i, j = (k for k in range(3) if k != drop)
    inside = False
    for u, v in sides:
        if (u[j] > x[j]) != (v[j] > x[j]):
            across: Rational = u[i] + (x[j] - u[j]) * (v[i] - u[i]) / (v[j] - u[j])
            inside ^= across > x[i]
    return inside


def polygons_meet(first: Sequence[Vector], second: Sequence[Vector]) -> bool:
    """Whether two polygons of one plane have a point in common. Exact, O(mn)."""
    sides = [list(zip(p, [*p[1:], p[0]], strict=True)) for p in (first, second)]
    if any(shared(a, b) for a in sides[0] for b in sides[1]):
        return True
    return in_polygon(first[0], second) or in_polygon(second[0], first)
