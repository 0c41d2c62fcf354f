"""Exact vectors in space, over the integers wherever only directions count."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import lcm

from minkref.fuzz.geometry.space import Point, Whole, primitive

Vector = tuple[Fraction, Fraction, Fraction]


def direction(vector: Iterable[Fraction | int]) -> Whole:
    """The shortest whole vector in the same direction. Not for the zero vector."""
    x, y, z = (Fraction(c) for c in vector)
    unit = lcm(x.denominator, y.denominator, z.denominator)
    return primitive((int(x * unit), int(y * unit), int(z * unit)))


def stretched(vector: Iterable[Fraction | int], factors: Point) -> Vector:
    """A point or an edge of S P."""
    x, y, z = vector
    return x * factors[0], y * factors[1], z * factors[2]


def shrunk(vector: Iterable[Fraction | int], factors: Point) -> Vector:
    """Scales a normal of P to a normal of S P."""
    return stretched(vector, inverse(factors))


def inverse(factors: Point) -> Point:
    return 1 / factors[0], 1 / factors[1], 1 / factors[2]


def product(a: Iterable[Fraction | int], b: Iterable[Fraction | int]) -> Fraction:
    return sum((Fraction(x) * y for x, y in zip(a, b, strict=True)), Fraction(0))


def crossed(a: Iterable[Fraction | int], b: Iterable[Fraction | int]) -> Vector:
    (x, y, z), (u, v, w) = a, b
    return Fraction(y * w - z * v), Fraction(z * u - x * w), Fraction(x * v - y * u)


def difference(a: Iterable[Fraction | int], b: Iterable[Fraction | int]) -> Vector:
    (x, y, z), (u, v, w) = a, b
    return Fraction(x - u), Fraction(y - v), Fraction(z - w)


def moved(vertices: Iterable[Point], by: Iterable[Fraction | int]) -> list[Point]:
    x, y, z = by
    return [(a + x, b + y, c + z) for a, b, c in vertices]


def vector(x: Fraction | int, y: Fraction | int, z: Fraction | int) -> Vector:
    return Fraction(x), Fraction(y), Fraction(z)
