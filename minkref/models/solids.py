"""Convex polyhedra with integer vertices: the characters in Fig. 10 of Behar & Lien 2012."""

from __future__ import annotations

import itertools
from decimal import Decimal

from circle import DIGITS, cosine_and_sine
from sphere import CIRCLE, Face, Point, facets, placed, plane, towards

Solid = tuple[list[Point], list[Face]]
Golden = tuple[int, int]  # a + b phi
Direction = tuple[Golden, Golden, Golden]

PHI = DIGITS.divide(DIGITS.add(1, DIGITS.sqrt(5)), 2)


def geodesic(frequency: int) -> Solid:
    """Cut each facet of an icosahedron into `frequency` squared triangles, carried to the sphere.

    The icosahedron has edges parallel to the axes; the sphere keeps the mirror planes x, y, z = 0
    and the turns of the three axes exactly."""
    corners: list[Direction] = []
    for one, phi in itertools.product((-1, 1), repeat=2):
        corners += _turned(((0, 0), (one, 0), (0, phi)))
    directions = set()
    for face in itertools.combinations(corners, 3):
        if all(_apart(a, b) == (4, 0) for a, b in itertools.combinations(face, 2)):
            for i in range(frequency + 1):
                for j in range(frequency + 1 - i):
                    directions.add(_mixed(face, (i, j, frequency - i - j)))
    return hull({placed(towards(_decimals(direction))) for direction in directions})


def truncated_icosidodecahedron() -> Solid:
    """Carry the 120 vertices to integer points on the sphere, in general position: squares,
    hexagons and decagons become 2, 4 and 8 triangles.

    The rotations by half a turn about the axes and the turns of the three axes are exact. The
    mirror planes are not: no vertex lies on a mirror plane, so trapezoids would lie across it."""
    shapes: list[Direction] = [
        ((-1, 1), (-1, 1), (3, 1)),
        ((-2, 2), (0, 1), (1, 2)),
        ((-1, 1), (1, 1), (-1, 3)),
        ((-1, 2), (2, 0), (2, 1)),
        ((0, 1), (3, 0), (0, 2)),
    ]
    points = set()
    for shape, signs in itertools.product(shapes, itertools.product((-1, 1), repeat=3)):
        x, y, z = ((sign * a, sign * b) for sign, (a, b) in zip(signs, shape, strict=True))
        for direction in _turned((x, y, z)):
            points.add(placed(towards(_decimals(direction)), chiral=True))
    return hull(points)


def ellipsoid(rings: int, around: int, stretch: tuple[int, int, int]) -> Solid:
    """Put `rings` rings of `around` vertices between poles on the x axis, on a sphere stretched
    along the axes. Mirror planes are exact."""
    points = {placed(towards((Decimal(s), Decimal(0), Decimal(0)))) for s in (-1, 1)}
    for ring in range(1, rings + 1):
        x, rim = cosine_and_sine(DIGITS.divide(ring, 2 * rings + 2))
        for k in range(around):
            cosine, sine = cosine_and_sine(DIGITS.divide(k, around))
            y, z = DIGITS.multiply(rim, cosine), DIGITS.multiply(rim, sine)
            points.add(placed(towards((x, y, z))))
    round_points, faces = hull(points)  # the stretched hull has the same facets
    return [(a * stretch[0], b * stretch[1], c * stretch[2]) for a, b, c in round_points], faces


def rod(corners: int, half_length: int) -> Solid:
    """Build a prism along the z axis over integer points on a circle, about evenly spread, with the
    axes' mirror planes."""
    ring: list[tuple[int, int]] = []
    for k in range(corners):
        cosine, sine = cosine_and_sine(DIGITS.divide(k, corners))
        x, y, _ = placed(towards((cosine, sine, Decimal(0)), CIRCLE), CIRCLE)
        ring.append((x, y))
    points = sorted((x, y, z) for x, y in ring for z in (-half_length, half_length))
    low, high = ([points.index((x, y, z)) for x, y in ring] for z in (-half_length, half_length))
    sides = [(low[k - 1], low[k], high[k], high[k - 1]) for k in range(corners)]
    return points, sorted(_from_least(face) for face in [*sides, tuple(high), tuple(low[::-1])])


def hull(given: set[Point]) -> Solid:
    """Compute the convex hull of points on a sphere, with vertices ascending."""
    points = sorted(given)
    return points, facets(points)


def flaws(solid: Solid) -> list[str]:
    """Find flaws that keep the faces from being the facets of a convex polyhedron with all points
    as vertices."""
    points, faces = solid
    edges = [edge for f in faces for edge in zip(f, f[1:] + f[:1], strict=True)]
    found = []
    if len(set(edges)) != len(edges) or any((j, i) not in set(edges) for i, j in edges):
        found.append("the faces do not close")
    if {i for i, _ in edges} != set(range(len(points))):
        found.append("a point is on no face")
    if len(points) - len(edges) // 2 + len(faces) != 2:
        found.append("the surface is no sphere")
    for face in faces:
        n, height = plane(points, face)
        above = [n[0] * x + n[1] * y + n[2] * z - height for x, y, z in points]
        if max(above) > 0:
            found.append(f"a vertex is above face {face}")
        if {k for k, value in enumerate(above) if value == 0} != set(face):
            found.append(f"the plane of face {face} has other vertices than the face")
    return found


def _turned(direction: Direction) -> list[Direction]:
    x, y, z = direction
    return [(x, y, z), (y, z, x), (z, x, y)]


def _apart(one: Direction, other: Direction) -> Golden:
    """Compute the squared distance; phi squared is phi + 1."""
    gaps = [(a[0] - b[0], a[1] - b[1]) for a, b in zip(one, other, strict=True)]
    return sum(a * a + b * b for a, b in gaps), sum(2 * a * b + b * b for a, b in gaps)


def _mixed(face: tuple[Direction, ...], weights: tuple[int, int, int]) -> Direction:
    x, y, z = (
        (
            sum(w * corner[k][0] for w, corner in zip(weights, face, strict=True)),
            sum(w * corner[k][1] for w, corner in zip(weights, face, strict=True)),
        )
        for k in range(3)
    )
    return x, y, z


def _decimals(direction: Direction) -> tuple[Decimal, Decimal, Decimal]:
    x, y, z = (DIGITS.add(a, DIGITS.multiply(b, PHI)) for a, b in direction)
    return x, y, z


def _from_least(face: Face) -> Face:
    at = face.index(min(face))
    return face[at:] + face[:at]
