"""Numbers a + b sqrt(c) with rational a, b and c >= 0, in order; exact."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import isqrt

FEWEST_BITS = 40


@dataclass(frozen=True)
class Surd:
    """a + b sqrt(c)."""

    a: Fraction
    b: Fraction = Fraction(0)
    c: Fraction = Fraction(0)

    def __lt__(self, other: Surd) -> bool:
        return sign_of_sum(self.a - other.a, self.b, self.c, -other.b, other.c) < 0

    def __le__(self, other: Surd) -> bool:
        return not other < self

    def bounds(self, bits: int) -> tuple[Fraction, Fraction]:
        """Two rational numbers around it; with more bits the gap vanishes."""
        low, high = root_bounds(self.c, bits)
        ends = (self.a + self.b * low, self.a + self.b * high)
        return min(ends), max(ends)


def root_bounds(value: Fraction, bits: int) -> tuple[Fraction, Fraction]:
    """Rational numbers around the square root, which differ by about 2^-bits of it, or equal it."""
    top, bottom = value.numerator, value.denominator
    root = Fraction(isqrt(top), isqrt(bottom))
    if root * root == value:
        return root, root
    shift = max(bits - (top.bit_length() - bottom.bit_length()) // 2, 0)
    low = isqrt((top << 2 * shift) // bottom)
    return Fraction(low, 1 << shift), Fraction(low + 1, 1 << shift)


def sign_of_sum(p: Fraction, q: Fraction, c: Fraction, s: Fraction, e: Fraction) -> int:
    """The sign of p + q sqrt(c) + s sqrt(e): squares decide."""
    squares = (q * abs(q) * c, s * abs(s) * e)
    roots = sign(squares[0] + squares[1])
    if not sign(p) or not roots or sign(p) == roots:
        return roots or sign(p)
    # |p| against |q sqrt(c) + s sqrt(e)|: p^2 - q^2 c - s^2 e against 2 q s sqrt(c e)
    rest, twice = p * p - abs(squares[0]) - abs(squares[1]), 2 * q * s
    product = twice * abs(twice) * c * e
    return sign(p) * sign(rest * abs(rest) - product)


def sign(value: Fraction) -> int:
    return (value > 0) - (value < 0)


def between(low: Surd, high: Surd) -> Fraction:
    """A rational number between two numbers, the first one less."""
    bits = FEWEST_BITS
    while True:
        left, right = low.bounds(bits)[1], high.bounds(bits)[0]
        if left < right:
            return (left + right) / 2
        bits *= 2
