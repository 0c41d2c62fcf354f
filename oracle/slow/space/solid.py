"""Operands for space from text: faces (planar rings), or a point, or a segment."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from ..exact import InputError, number

Place = tuple[Fraction, Fraction, Fraction]
Whole = tuple[int, int, int]


@dataclass(frozen=True)
class Solid:
    """A solid whose faces run counter-clockwise seen from outside; without faces, one or two
    `ends`."""

    faces: list[list[Place]]
    ends: list[Place]

    def scaled(self, factors: Place) -> Solid:
        a, b, c = factors

        def moved(ring: list[Place]) -> list[Place]:
            return [(a * x, b * y, c * z) for x, y, z in ring]

        return Solid([moved(ring) for ring in self.faces], moved(self.ends))


def solid_from_json(value: Any) -> Solid:
    """Read {"vertices": [[x, y, z], ...], "faces": [[i, j, k, ...], ...]}. InputError for another
    form, or for a face that has no area or is not planar. Trusts that the surface closes and does
    not cross itself."""
    if not isinstance(value, dict):
        raise InputError("a polyhedron is an object")
    try:
        points = [(coordinate(x), coordinate(y), coordinate(z)) for x, y, z in value["vertices"]]
        faces = [[points[i] for i in face] for face in value["faces"]]
    except (KeyError, IndexError, TypeError, ValueError) as error:
        raise InputError(f"no polyhedron: {error}") from error
    if not faces and len(points) not in (1, 2):
        raise InputError("without faces there are one or two vertices")
    for ring in faces:
        n = vector_area(ring)
        if n == (0, 0, 0) or len({height(n, point) for point in ring}) > 1:
            raise InputError("a face has no area or is not planar")
    return Solid(faces, [] if faces else points)


def coordinate(value: Any) -> Fraction:
    return number(str(value))


def plus(a: Place, b: Place) -> Place:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def outer(a: Whole, b: Whole) -> Whole:
    """Return the cross product of two directions."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def inner(a: Whole, b: Whole) -> int:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def height(n: Whole, point: Place) -> Fraction:
    return n[0] * point[0] + n[1] * point[1] + n[2] * point[2]


def shortest(v: Whole) -> Whole:
    """Return the primitive vector in this direction, which must not be zero."""
    common = gcd(*v)
    return v[0] // common, v[1] // common, v[2] // common


def wholes(points: list[Place]) -> tuple[int, list[Whole]]:
    """Write the points over one denominator."""
    unit = lcm(1, *(value.denominator for point in points for value in point))
    found = []
    for point in points:
        x, y, z = (value.numerator * (unit // value.denominator) for value in point)
        found.append((x, y, z))
    return unit, found


def vector_area(ring: list[Place]) -> Whole:
    """Return a positive multiple of the vector area, in integers."""
    _, points = wholes(ring)
    x = y = z = 0
    for a, b in zip(points, points[1:] + points[:1], strict=True):
        c = outer(a, b)
        x, y, z = x + c[0], y + c[1], z + c[2]
    return x, y, z


def plane_of(ring: list[Place]) -> tuple[Whole, Fraction]:
    """Return the primitive outward normal and the offset of a face's plane."""
    normal = shortest(vector_area(ring))
    return normal, height(normal, ring[0])
