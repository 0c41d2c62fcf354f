"""A face cut into convex pieces by the triangles that meet the face."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from math import gcd

from minkref.fuzz.geometry.space import Point, Whole, cross, dot, middle, minus, normal

Triangle = tuple[Whole, Whole, Whole]
Plane = tuple[Whole, int]  # the points x with n x = d
Corner = tuple[int, int, int, int]  # the point (x / w, y / w, z / w), with w > 0
Polygon = list[Corner]


def polygon_of(triangle: Triangle) -> Polygon:
    return [(x, y, z, 1) for x, y, z in triangle]


def heights(polygon: Polygon, plane: Plane) -> list[int]:
    """Heights of the corners above the plane, each times a positive number."""
    (nx, ny, nz), d = plane
    return [nx * x + ny * y + nz * z - d * w for x, y, z, w in polygon]


def pieces(polygons: list[Polygon], n: Whole, others: Iterable[Triangle]) -> list[Polygon]:
    """Cuts polygons, which lie in one plane with normal `n` and all run the same way around `n`,
    into convex pieces: no triangle of `others` divides a piece's inside, and triangles in their
    plane hold a whole piece or nothing of its inside. Exact; a triangle cuts only pieces that it
    meets."""
    if polygons and _turn(polygons[0], n) < 0:
        n = (-n[0], -n[1], -n[2])
    parts = polygons
    for other in others if polygons else ():
        for cut in _cuts(n, polygons[0][0], other):
            if any(_meets(polygon, n, cut) for polygon in polygons):
                parts = [piece for part in parts for piece in _split(part, n, cut)]
    return parts


def inside(polygon: Polygon, unit: int = 1) -> Point:
    """Returns the middle of the corners, which count parts of a unit, `unit` parts each."""
    points = [(Fraction(x, w), Fraction(y, w), Fraction(z, w)) for x, y, z, w in polygon]
    x, y, z = middle(points)
    return (x / unit, y / unit, z / unit)


@dataclass(frozen=True)
class Cut:
    """A segment in a face's plane, in another plane through the segment."""

    plane: Plane
    ends: tuple[Corner, Corner]


def _cuts(n: Whole, origin: Corner, other: Triangle) -> list[Cut]:
    """Cuts where a triangle meets the plane: its sides, or its intersection with the plane."""
    level = n[0] * origin[0] + n[1] * origin[1] + n[2] * origin[2]
    sides = [dot(n, corner) * origin[3] - level for corner in other]
    if not any(sides):
        found = []
        for k in range(3):
            across = cross(n, minus(other[k], other[k - 1]))
            side = ((*other[k - 1], 1), (*other[k], 1))
            found.append(Cut((across, dot(across, other[k])), side))
        return found
    ends: list[Corner] = [(*other[k], 1) for k in range(3) if sides[k] == 0]
    for k in range(3):
        before, after = sides[k - 1], sides[k]
        if (before < 0 < after) or (after < 0 < before):
            ends.append(_between((*other[k - 1], 1), abs(before), (*other[k], 1), abs(after)))
    if len(ends) < 2:
        return []
    m = normal(*other)
    return [Cut((m, dot(m, other[0])), (ends[0], ends[1]))]


def _split(polygon: Polygon, n: Whole, cut: Cut) -> list[Polygon]:
    """Splits a polygon along the line of a cut that meets its inside."""
    if not _meets(polygon, n, cut):
        return [polygon]
    return list(halves(polygon, heights(polygon, cut.plane)))


def _meets(polygon: Polygon, n: Whole, cut: Cut) -> bool:
    """Whether the cut passes through the inside: neither the cut's line nor a side of the polygon,
    which runs counter-clockwise, separates the cut from the polygon."""
    sides = heights(polygon, cut.plane)
    if min(sides) >= 0 or max(sides) <= 0:
        return False
    for k, corner in enumerate(polygon):
        m = cross(n, _step(polygon[k - 1], corner))
        x, y, z, w = corner
        level = m[0] * x + m[1] * y + m[2] * z
        if all((m[0] * p + m[1] * q + m[2] * r) * w <= level * s for p, q, r, s in cut.ends):
            return False
    return True


def _turn(polygon: Polygon, n: Whole) -> int:
    """Positive for a counter-clockwise polygon; 0 without area."""
    steps = [_step(polygon[0], corner) for corner in polygon[1:]]
    turns = (dot(n, cross(a, b)) for a, b in pairwise(steps))
    return next(filter(None, turns), 0)


def _step(a: Corner, b: Corner) -> Whole:
    """From a to b, times a positive number."""
    return (b[0] * a[3] - a[0] * b[3], b[1] * a[3] - a[1] * b[3], b[2] * a[3] - a[2] * b[3])


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
    """The point at which a segment crosses a plane, given the distances of its ends."""
    x, y, z, w = (of_b * p + of_a * q for p, q in zip(a, b, strict=True))
    divisor = gcd(x, y, z, w)
    return (x // divisor, y // divisor, z // divisor, w // divisor)
