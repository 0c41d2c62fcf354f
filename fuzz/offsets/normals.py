"""Unit vectors in fractions, rounded to 60 bits."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

from minkref.fuzz.geometry.plane import dot
from minkref.fuzz.offsets.lines import Place

BITS = 60


def right_of(way: Place) -> Place:
    """Turns a vector by a quarter clockwise."""
    return (way[1], -way[0])


def unit(way: Place) -> Place:
    """Returns a vector's direction."""
    length = root_of(dot(way, way))
    return (rounded(way[0] / length), rounded(way[1] / length))


def rounded(x: Fraction) -> Fraction:
    """Rounds a part of a unit vector."""
    return Fraction(round(x * (1 << BITS)), 1 << BITS)


def root_of(square: Fraction) -> Fraction:
    """Near the root: 60 bits of it or more."""
    n, d = square.numerator, square.denominator
    scale = 1 << (2 * BITS + 2 * max(0, d.bit_length() - n.bit_length()))
    return Fraction(isqrt(n * d * scale), d * isqrt(scale))
