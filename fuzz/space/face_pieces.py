"""A face cut into convex pieces by the triangles that it meets."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from minkref.fuzz.space.integers import Point, Whole, cross, dot, minus, normal

Triangle = tuple[Whole, Whole, Whole]
Plane = tuple[Whole, int]  # the points x with n x = d


def polygon_of(triangle: Triangle) -> list[Point]:
    return [(Fraction(x), Fraction(y), Fraction(z)) for x, y, z in triangle]


def pieces(polygons: list[list[Point]], n: Whole, others: Iterable[Triangle]) -> list[list[Point]]:
    """Convex polygons that cover those, which lie in one plane with normal `n`; no triangle of
    `others` divides the inside of one, and those in its plane hold all of it or nothing of its
    inside. Exact; as many pieces as the planes leave, k^2 for k planes."""
    parts = polygons
    for other in others:
        if not parts:
            break
        low, high = _box(other)
        for plane in _planes(n, parts[0][0], other):
            cut: list[list[Point]] = []
            for part in parts:
                cut += _split(part, plane) if _overlaps(part, low, high) else [part]
            parts = cut
    return parts


def middle(polygon: list[Point]) -> Point:
    """A point inside the convex polygon."""
    count = len(polygon)
    x, y, z = (sum((p[k] for p in polygon), Fraction(0)) / count for k in range(3))
    return (x, y, z)


def _planes(n: Whole, origin: Point, other: Triangle) -> list[Plane]:
    m = normal(*other)
    if cross(n, m) != (0, 0, 0):
        return [(m, dot(m, other[0]))]
    if dot(n, other[0]) != n[0] * origin[0] + n[1] * origin[1] + n[2] * origin[2]:
        return []
    found = []
    for k in range(3):
        across = cross(n, minus(other[k], other[k - 1]))
        found.append((across, dot(across, other[k])))
    return found


def _split(polygon: list[Point], plane: Plane) -> list[list[Point]]:
    (nx, ny, nz), d = plane
    sides = [nx * x + ny * y + nz * z - d for x, y, z in polygon]
    if min(sides) >= 0 or max(sides) <= 0:
        return [polygon]
    return list(halves(polygon, sides))


def halves(polygon: list[Point], sides: Sequence[Fraction]) -> tuple[list[Point], list[Point]]:
    """The parts of a convex polygon below and above a plane, where `sides` has both signs: the
    heights of its corners."""
    below: list[Point] = []
    above: list[Point] = []
    for k, (point, side) in enumerate(zip(polygon, sides, strict=True)):
        before, other = polygon[k - 1], sides[k - 1]
        if (side > 0 > other) or (side < 0 < other):
            t = other / (other - side)
            crossing = (
                before[0] + t * (point[0] - before[0]),
                before[1] + t * (point[1] - before[1]),
                before[2] + t * (point[2] - before[2]),
            )
            below.append(crossing)
            above.append(crossing)
        if side <= 0:
            below.append(point)
        if side >= 0:
            above.append(point)
    return below, above


def _box(triangle: Triangle) -> tuple[list[int], list[int]]:
    columns = list(zip(*triangle, strict=True))
    return [min(c) for c in columns], [max(c) for c in columns]


def _overlaps(polygon: list[Point], low: list[int], high: list[int]) -> bool:
    return all(
        min(p[k] for p in polygon) <= high[k] and max(p[k] for p in polygon) >= low[k]
        for k in range(3)
    )
