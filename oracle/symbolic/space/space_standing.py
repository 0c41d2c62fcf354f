"""Common points of segments and facets in space at one scale, from the definition."""

from __future__ import annotations

from collections.abc import Sequence

from ..rational import Rational
from .space_moving import Vector, cross, dot, minus

Segment3 = tuple[Vector, Vector]


def on_segment(x: Vector, segment: Segment3) -> bool:
    """Tell whether a segment, or a single point, contains x."""
    a, b = segment
    if a == b:
        return x == a
    along, off = minus(b, a), minus(x, a)
    return not any(cross(along, off)) and 0 <= dot(along, off) <= dot(along, along)


def shared(first: Segment3, second: Segment3) -> Segment3 | None:
    """Return the common points of two closed segments, as a segment between two points. Exact."""
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
    """Tell whether the closed planar simple polygon contains x: on the boundary, or inside on the
    plane, by a ray's crossings in a projection that keeps the plane. Exact."""
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
    """Tell whether two coplanar polygons share a point. Exact, O(mn)."""
    sides = [list(zip(p, [*p[1:], p[0]], strict=True)) for p in (first, second)]
    if any(shared(a, b) for a in sides[0] for b in sides[1]):
        return True
    return in_polygon(first[0], second) or in_polygon(second[0], first)


def shared_by_polygons(first: Sequence[Vector], second: Sequence[Vector]) -> Segment3 | None:
    """Return the common points of two convex polygons on crossing planes, as a segment between two
    points: cuts the first by the second's plane, then at the second's sides. Exact."""
    normal = _normal(second)
    heights = [dot(normal, minus(x, second[0])) for x in first]
    on_plane = [x for x, height in zip(first, heights, strict=True) if height == 0]
    for i, height in enumerate(heights):
        j = (i + 1) % len(first)
        if height * heights[j] < 0:
            on_plane.append(_between(first[i], first[j], height / (height - heights[j])))
    if not on_plane:
        return None
    low, high = min(on_plane), max(on_plane)
    start, end = Rational(0), Rational(1)
    for i, corner in enumerate(second):
        inwards = cross(normal, minus(second[(i + 1) % len(second)], corner))
        here, there = dot(inwards, minus(low, corner)), dot(inwards, minus(high, corner))
        if here < 0 and there < 0:
            return None
        if here < 0:
            start = max(start, here / (here - there))
        if there < 0:
            end = min(end, here / (here - there))
    return None if start > end else (_between(low, high, start), _between(low, high, end))


def shared_by_convex(polygons: Sequence[Sequence[Vector]]) -> list[Vector]:
    """Return the common corners of coplanar convex polygons, ordered, perhaps repeated: cuts the
    first at the sides of the others. Exact."""
    left = list(polygons[0])
    for own in polygons[1:]:
        normal = _normal(own)
        for i, corner in enumerate(own):
            inwards = cross(normal, minus(own[(i + 1) % len(own)], corner))
            heights = [dot(inwards, minus(x, corner)) for x in left]
            kept: list[Vector] = []
            for k, x in enumerate(left):
                if heights[k - 1] * heights[k] < 0:
                    part = heights[k - 1] / (heights[k - 1] - heights[k])
                    kept.append(_between(left[k - 1], x, part))
                if heights[k] >= 0:
                    kept.append(x)
            left = kept
    return left


def share_an_area(first: Sequence[Vector], second: Sequence[Vector]) -> bool:
    """Tell whether two coplanar convex polygons overlap: no side of one has the other behind it."""
    for own, other in ((first, second), (second, first)):
        normal = _normal(own)
        for i, corner in enumerate(own):
            inwards = cross(normal, minus(own[(i + 1) % len(own)], corner))
            if all(dot(inwards, minus(x, corner)) <= 0 for x in other):
                return False
    return True


def _normal(polygon: Sequence[Vector]) -> Vector:
    return cross(minus(polygon[1], polygon[0]), minus(polygon[2], polygon[0]))


def _between(a: Vector, b: Vector, t: Rational) -> Vector:
    return tuple(x + t * (y - x) for x, y in zip(a, b, strict=True))
