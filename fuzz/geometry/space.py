"""Points and vectors in space, in fractions and in integers: a common denominator makes exact tests
fast."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from math import gcd, lcm
from typing import TypeVar

Number = TypeVar("Number", int, Fraction)
Vector = tuple[Number, Number, Number]
Point = tuple[Fraction, Fraction, Fraction]
Whole = tuple[int, int, int]  # a point or vector with integer coordinates
Scale = Fraction | Point  # the same along all axes, or one factor for each


def scale_of(text: str) -> Scale:
    """One number, or three."""
    parts = [Fraction(part) for part in text.split(",")]
    return (parts[0], parts[1], parts[2]) if len(parts) == 3 else parts[0]


def factors(scale: Scale) -> Point:
    """Returns a factor for each axis."""
    return scale if isinstance(scale, tuple) else (scale, scale, scale)


def denominator_of(points: Iterable[Sequence[Fraction]]) -> int:
    """The least common denominator of all coordinates, of two or three; 1 without points."""
    return lcm(*{number.denominator for point in points for number in point})


def whole(point: Point, denominator: int) -> Whole:
    """Returns the point times `denominator`, which must clear the point's coordinates."""
    x, y, z = point
    return (
        x.numerator * (denominator // x.denominator),
        y.numerator * (denominator // y.denominator),
        z.numerator * (denominator // z.denominator),
    )


def middle(points: Sequence[Point]) -> Point:
    """Returns the points' mean."""
    x, y, z = (sum((p[k] for p in points), Fraction(0)) / len(points) for k in range(3))
    return (x, y, z)


def minus(a: Vector[Number], b: Vector[Number]) -> Vector[Number]:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a: Vector[Number], b: Vector[Number]) -> Number:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector[Number], b: Vector[Number]) -> Vector[Number]:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normal(a: Vector[Number], b: Vector[Number], c: Vector[Number]) -> Vector[Number]:
    """Returns the normal on the side from which the triangle runs counter-clockwise, twice as long
    as the triangle's area."""
    return cross(minus(b, a), minus(c, a))


def area_vector(ring: Sequence[Whole]) -> Whole:
    """Twice the vector area of a closed ring; for a planar ring it is normal to the plane."""
    x = y = z = 0
    first = ring[0]
    for a, b in pairwise(ring[1:]):
        n = normal(first, a, b)
        x, y, z = x + n[0], y + n[1], z + n[2]
    return (x, y, z)


def primitive(vector: Whole) -> Whole:
    """The shortest integer vector in the same direction. Not for the zero vector."""
    divisor = gcd(*vector)
    return (vector[0] // divisor, vector[1] // divisor, vector[2] // divisor)


def longest_axis(vector: Whole) -> int:
    """The axis along which the vector is longest; the first among equals."""
    lengths = [abs(number) for number in vector]
    return lengths.index(max(lengths))


def flattened(point: Whole, axis: int) -> tuple[int, int]:
    """The point without this coordinate, so that x, y, z keep their cyclic order."""
    return (point[(axis + 1) % 3], point[(axis + 2) % 3])
