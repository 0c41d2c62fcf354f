"""Convex polygons in exact rationals: intersections, and points inside."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

Place = tuple[Fraction, Fraction]
Polygon = list[Place]  # counter-clockwise; two corners for a segment, one for a point


def below(polygon: Sequence[Place], normal: Sequence[Fraction | int], most: Fraction) -> Polygon:
    """The part of a polygon in the half-plane normal * x <= most."""
    at = [normal[0] * x + normal[1] * y - most for x, y in polygon]
    kept: dict[Place, None] = {}
    for k, (p, v) in enumerate(zip(polygon, at, strict=True)):
        q, u = polygon[k - 1], at[k - 1]
        if u * v < 0:
            part = u / (u - v)
            kept[q[0] + part * (p[0] - q[0]), q[1] + part * (p[1] - q[1])] = None
        if v <= 0:
            kept[p] = None
    return list(kept)


def middle(polygon: Sequence[Place]) -> Place:
    """Returns the mean of the corners: an interior point, if the interior is not empty."""
    n = len(polygon)
    return (Fraction(sum(p[0] for p in polygon)) / n, Fraction(sum(p[1] for p in polygon)) / n)


def crossings(a: Place, b: Place, x: Place) -> int:
    """Counts how often a segment passes the ray from x to the right: upwards as 1, downwards as -1.
    Over a closed polyline that misses x, the sum is the winding number around x."""
    if (a[1] <= x[1]) == (b[1] <= x[1]):
        return 0
    side = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0])
    if b[1] > a[1]:
        return int(side > 0)
    return -int(side < 0)
