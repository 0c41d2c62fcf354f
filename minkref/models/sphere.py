"""Integer points on a sphere about the origin, and their hull's facets: exact, by integers."""

from __future__ import annotations

import functools
from decimal import ROUND_HALF_EVEN, Decimal
from math import isqrt

from circle import DIGITS

Point = tuple[int, int, int]
Face = tuple[int, ...]

CIRCLE = 5 * 13 * 17 * 29  # this circle has 324 integer points
RADIUS = 3 * CIRCLE  # this sphere has 961,350, 324 of them in each coordinate plane

MODULUS = 5040  # with few squares among the remainders
SQUARES = [False] * MODULUS
for _k in range(MODULUS):
    SQUARES[_k * _k % MODULUS] = True


def towards(direction: tuple[Decimal, Decimal, Decimal], radius: int = RADIUS) -> Point:
    """Find the sphere's point in this direction, rounded to integers, perhaps off the sphere."""
    squares = [DIGITS.multiply(part, part) for part in direction]
    length = DIGITS.sqrt(DIGITS.add(DIGITS.add(squares[0], squares[1]), squares[2]))
    x, y, z = (_rounded(DIGITS.divide(DIGITS.multiply(radius, part), length)) for part in direction)
    return x, y, z


def _rounded(value: Decimal) -> int:
    """Round first to 15 decimals, so that a series' last digits do not decide about one half."""
    clean = value.quantize(Decimal("1e-15"), ROUND_HALF_EVEN, DIGITS)
    return int(clean.to_integral_value(ROUND_HALF_EVEN))


def placed(wanted: Point, radius: int = RADIUS, chiral: bool = False) -> Point:
    """Find the sphere's nearest integer point, with zeros where `wanted` has zeros.

    Signs and cyclic exchanges of coordinates carry over from `wanted`: mirrored and turned
    directions give exactly mirrored and turned points. `chiral` spoils the mirror images, not the
    rotations: for a negative product of signs it takes a point less near."""
    x, y, z = (abs(value) for value in wanted)
    turns = [(x, y, z), (y, z, x), (z, x, y)]
    turn = max(range(3), key=lambda k: turns[k])
    negative = sum(value < 0 for value in wanted)
    point = _nearest(turns[turn], radius, negative % 2 if chiral else 0)
    back = point[3 - turn :] + point[: 3 - turn]
    x, y, z = (-b if w < 0 else b for b, w in zip(back, wanted, strict=True))
    return x, y, z


@functools.cache
def _nearest(wanted: Point, radius: int, rank: int) -> Point:
    """Find the point at the least distance from `wanted`, or at the next larger for `rank` 1, with
    the same zeros. `wanted` must not be negative, and must be largest in x; searches growing
    squares of (y, z) around it."""
    _, Y, Z = wanted
    if Y == Z == 0:
        return radius, 0, 0
    found: dict[int, Point] = {}
    reach = 0
    while len(found) <= rank or sorted(found)[rank] > reach * reach:
        ys = range(max(Y - reach, 1), Y + reach + 1) if Y else range(1)
        zs = range(max(Z - reach, 1), Z + reach + 1) if Z else range(1)
        places = [
            (y, z) for y in {Y - reach, Y + reach} if Y and y in ys for z in _hits(radius, y, zs)
        ]
        places += [
            (y, z) for z in {Z - reach, Z + reach} if Z and z in zs for y in _hits(radius, z, ys)
        ]
        for y, z in places:
            point = (isqrt(radius**2 - y * y - z * z), y, z)
            distance = sum((a - b) ** 2 for a, b in zip(point, wanted, strict=True))
            found[distance] = min(point, found.get(distance, point))
        reach += 1
    return found[sorted(found)[rank]]


def _hits(radius: int, y: int, zs: range) -> list[int]:
    """List each z for which radius^2 - y^2 - z^2 is the square of a positive integer."""
    left = radius * radius - y * y
    likely = [z for z in zs if SQUARES[(left - z * z) % MODULUS]]
    return [z for z in likely if left > z * z and isqrt(left - z * z) ** 2 == left - z * z]


def facets(points: list[Point]) -> list[Face]:
    """Find the hull's triangles for points on a sphere, counter-clockwise seen from outside.

    Gift wrapping from an edge that leads to a nearest neighbour: on a sphere the hull is the
    Delaunay triangulation, which has this edge. Raises ValueError for four points on one facet's
    plane."""
    first = min(
        range(1, len(points)),
        key=lambda k: sum((a - b) ** 2 for a, b in zip(points[0], points[k], strict=True)),
    )
    open_edges, faces = [(0, first)], {}
    while open_edges:
        i, j = open_edges.pop()
        if (i, j) not in faces:
            k = _wrapped(points, i, j)
            faces.update({(i, j): k, (j, k): i, (k, i): j})
            open_edges += [(j, i), (k, j), (i, k)]
    return sorted((i, j, k) for (i, j), k in faces.items() if i < j and i < k)


def _wrapped(points: list[Point], i: int, j: int) -> int:
    """Find the k for which no point lies above the plane i j k."""
    others = [k for k in range(len(points)) if k not in (i, j)]
    best = others[0]
    n, height = plane(points, (i, j, best))
    for k in others:
        x, y, z = points[k]
        if n[0] * x + n[1] * y + n[2] * z > height:
            best = k
            n, height = plane(points, (i, j, k))
    if sum(n[0] * x + n[1] * y + n[2] * z == height for x, y, z in points) != 3:
        raise ValueError(f"a fourth vertex in the plane of {points[i]} {points[j]} {points[best]}")
    return best


def plane(points: list[Point], face: Face) -> tuple[Point, int]:
    """Return an outward normal of a face's plane, and its product with the face's points."""
    a, b, c = (points[k] for k in face[:3])
    u = [b[k] - a[k] for k in range(3)]
    v = [c[k] - a[k] for k in range(3)]
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return n, n[0] * a[0] + n[1] * a[1] + n[2] * a[2]
