"""Round solids in triangles, with integer vertices: geodesic spheres, tori, rings with teeth."""

from __future__ import annotations

import random
from fractions import Fraction
from math import cos, pi, sin, sqrt

from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import Point

# Floats only choose points of the grid.
Place = tuple[float, float, float]
Triple = tuple[int, int, int]
GOLDEN = (1 + sqrt(5)) / 2
CORNERS: tuple[Place, ...] = (
    (-1, GOLDEN, 0), (1, GOLDEN, 0), (-1, -GOLDEN, 0), (1, -GOLDEN, 0),
    (0, -1, GOLDEN), (0, 1, GOLDEN), (0, -1, -GOLDEN), (0, 1, -GOLDEN),
    (GOLDEN, 0, -1), (GOLDEN, 0, 1), (-GOLDEN, 0, -1), (-GOLDEN, 0, 1),
)  # fmt: skip
SIDES = (
    (0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
    (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9),
    (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1),
)  # fmt: skip


def geodesic_sphere(splits: int, radius: int) -> Polyhedron:
    """An icosahedron whose triangles are cut in four so many times: 20, 80, 320 triangles. About
    the origin; convex on a fine enough grid, at a radius of some hundreds."""
    places = [_on_sphere(corner) for corner in CORNERS]
    sides = list(SIDES)
    for _ in range(splits):
        places, sides = _split(places, sides)
    points = tuple(_on_grid(radius * x, radius * y, radius * z) for x, y, z in places)
    return Polyhedron(points, tuple(sides))


def _split(places: list[Place], sides: list[Triple]) -> tuple[list[Place], list[Triple]]:
    """Cuts each triangle into four, with the middles of edges moved to the sphere."""
    places, cut = list(places), []
    middles: dict[frozenset[int], int] = {}

    def middle(a: int, b: int) -> int:
        edge = frozenset((a, b))
        if edge not in middles:
            (px, py, pz), (qx, qy, qz) = places[a], places[b]
            middles[edge] = len(places)
            places.append(_on_sphere((px + qx, py + qy, pz + qz)))
        return middles[edge]

    for a, b, c in sides:
        x, y, z = middle(a, b), middle(b, c), middle(c, a)
        cut += [(a, x, z), (b, y, x), (c, z, y), (x, y, z)]
    return places, cut


def triangulated_torus(around: int, section: int, radius: int, thickness: int) -> Polyhedron:
    """About the z axis, in 2 `around` `section` triangles."""
    points = []
    for i in range(around):
        for j in range(section):
            a, b = 2 * pi * i / around, 2 * pi * j / section
            far = radius + thickness * cos(b)
            points.append(_on_grid(far * cos(a), far * sin(a), thickness * sin(b)))
    return Polyhedron(tuple(points), tuple(ring_of_triangles(around, section)))


def clutch(dice: random.Random, around: int, teeth: int, size: int, jitter: int = 3) -> Polyhedron:
    """Half of a dog clutch: a ring about the z axis, from 2 to 3 `size`, with teeth along its axis;
    8 `around` triangles. Each vertex moves by up to `jitter`, so no faces are parallel. A tooth and
    a gap need at least two columns."""
    if around < 4 * teeth:
        raise ValueError(f"{teeth} teeth take {4 * teeth} columns, not {around}")

    def off() -> int:
        return dice.randint(-jitter, jitter)

    points = []
    for i in range(around):
        a = 2 * pi * i / around
        top = 1.0 if 2 * teeth * i // around % 2 == 0 else 0.6
        for far, up in ((2, 0), (3, 0), (3, top), (2, top)):
            x, y, z = far * cos(a), far * sin(a), up
            points.append(_on_grid(size * x + off(), size * y + off(), size * z + off()))
    return Polyhedron(tuple(points), tuple(ring_of_triangles(around, 4)))


def ring_of_triangles(around: int, section: int) -> list[Face]:
    """The faces of `around` sections with corners counter-clockwise, seen with the axis to the
    left and z upwards; the way around is counter-clockwise seen from above."""
    faces: list[Face] = []
    for i in range(around):
        here, there = i * section, (i + 1) % around * section
        for j in range(section):
            k = (j + 1) % section
            faces += [(here + j, there + j, there + k), (here + j, there + k, here + k)]
    return faces


def _on_sphere(place: Place) -> Place:
    x, y, z = place
    length = sqrt(x * x + y * y + z * z)
    return (x / length, y / length, z / length)


def _on_grid(x: float, y: float, z: float) -> Point:
    return (Fraction(round(x)), Fraction(round(y)), Fraction(round(z)))
