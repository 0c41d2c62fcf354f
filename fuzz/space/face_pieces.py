"""A face cut into convex pieces by the triangles that it meets."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import gcd

from minkref.fuzz.geometry.space import Point, Whole, cross, dot, middle, minus, normal

Triangle = tuple[Whole, Whole, Whole]
Plane = tuple[Whole, int]  # the points x with n x = d
Corner = tuple[int, int, int, int]  # the point (x / w, y / w, z / w), with w > 0
Polygon = list[Corner]


def polygon_of(triangle: Triangle) -> Polygon:
    return [(x, y, z, 1) for x, y, z in triangle]


def heights(polygon: Polygon, plane: Plane) -> list[int]:
    """Of the corners above the plane, each times a positive number."""
    (nx, ny, nz), d = plane
    return [nx * x + ny * y + nz * z - d * w for x, y, z, w in polygon]


def pieces(polygons: list[Polygon], n: Whole, others: Iterable[Triangle]) -> list[Polygon]:
    """Convex polygons that cover those, which lie in one plane with normal `n`; no triangle of
    `others` divides the inside of one, and those in its plane hold all of it or nothing of its
    inside. Exact; as many pieces as the planes leave, k^2 for k planes."""
    parts = polygons
    for other in others:
        if not parts:
            break
        low, high = _box(other)
        for plane in _planes(n, parts[0][0], other):
            cut: list[Polygon] = []
            for part in parts:
                cut += _split(part, plane) if _overlaps(part, low, high) else [part]
            parts = cut
    return parts


def inside(polygon: Polygon, unit: int = 1) -> Point:
    """The middle of the corners, which are in parts of a unit, so many of them."""
    points = [(Fraction(x, w), Fraction(y, w), Fraction(z, w)) for x, y, z, w in polygon]
    x, y, z = middle(points)
    return (x / unit, y / unit, z / unit)


def _planes(n: Whole, origin: Corner, other: Triangle) -> list[Plane]:
    m = normal(*other)
    if cross(n, m) != (0, 0, 0):
        return [(m, dot(m, other[0]))]
    if any(heights([origin], (n, dot(n, other[0])))):
        return []
    found = []
    for k in range(3):
        across = cross(n, minus(other[k], other[k - 1]))
        found.append((across, dot(across, other[k])))
    return found


def _split(polygon: Polygon, plane: Plane) -> list[Polygon]:
    sides = heights(polygon, plane)
    if min(sides) >= 0 or max(sides) <= 0:
        return [polygon]
    return list(halves(polygon, sides))


def halves(polygon: Polygon, sides: Sequence[int]) -> tuple[Polygon, Polygon]:
    """The parts of a convex polygon below and above a plane, whose `heights` have both signs."""
    below: Polygon = []
    above: Polygon = []
    for k, (corner, side) in enumerate(zip(polygon, sides, strict=True)):
        other = sides[k - 1]
        if (side > 0 > other) or (side < 0 < other):
            crossing = _between(polygon[k - 1], abs(other), corner, abs(side))
            below.append(crossing)
            above.append(crossing)
        if side <= 0:
            below.append(corner)
        if side >= 0:
            above.append(corner)
    return below, above


def _between(a: Corner, of_a: int, b: Corner, of_b: int) -> Corner:
    """Where the segment passes through a plane at these distances from its ends."""
    x, y, z, w = (of_b * p + of_a * q for p, q in zip(a, b, strict=True))
    divisor = gcd(x, y, z, w)
    return (x // divisor, y // divisor, z // divisor, w // divisor)


def _box(triangle: Triangle) -> tuple[list[int], list[int]]:
    columns = list(zip(*triangle, strict=True))
    return [min(c) for c in columns], [max(c) for c in columns]


def _overlaps(polygon: Polygon, low: list[int], high: list[int]) -> bool:
    return all(
        any(p[k] <= high[k] * p[3] for p in polygon) and any(p[k] >= low[k] * p[3] for p in polygon)
        for k in range(3)
    )
