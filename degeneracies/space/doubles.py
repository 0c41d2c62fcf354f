"""The signs that decide sums of convex bodies, computed in doubles the plain way."""

from __future__ import annotations

from fractions import Fraction

from minkref.degeneracies.space.body import Body
from minkref.fuzz.geometry.space import Point

Triple = tuple[float, float, float]


def signs_in_doubles(normals: Body, edges: Body, factors: tuple[Point, Point]) -> list[int | None]:
    """Signs, for each facet of the first body and each edge of the second, in this order, of the
    product of facet normal and edge; None for NaN. Coordinates are rounded, scaled by the rounded
    factors, and subtracted; a normal is the cross product of the facet's first two edges."""
    first, second = (
        [_scaled(v, scaling) for v in body.vertices]
        for body, scaling in zip((normals, edges), factors, strict=True)
    )
    crosses = []
    for facet in normals.facets:
        a, b, c = (first[k] for k in facet.ring[:3])
        crosses.append(_cross(_minus(b, a), _minus(c, b)))
    along = [_minus(second[edge.ends[1]], second[edge.ends[0]]) for edge in edges.edges]
    return [_sign(n[0] * d[0] + n[1] * d[1] + n[2] * d[2]) for n in crosses for d in along]


def _scaled(point: Point, factors: Point) -> Triple:
    x, y, z = (_double(c) * _double(f) for c, f in zip(point, factors, strict=True))
    return x, y, z


def _double(number: Fraction) -> float:
    try:
        return float(number)
    except OverflowError:
        return float("inf") if number > 0 else float("-inf")


def _minus(a: Triple, b: Triple) -> Triple:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _cross(a: Triple, b: Triple) -> Triple:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _sign(value: float) -> int | None:
    return None if value != value else (value > 0) - (value < 0)
