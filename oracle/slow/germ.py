"""Numbers at, just below and just above a scale.

Every number in the sum equals `n0 + n1 e` with integers n0, n1, for a scale s0 - e, s0 or s0 + e
and a positive infinitesimal e: coordinates have this form, and sums, products with integers, and
order keep the form. The code adds, subtracts, multiplies by an int, shifts, compares and divides by
an int; it never multiplies two such numbers. Two kinds of numbers suffice:

- `Germ` states its form: a product of two germs raises TypeError, so no degree grows unseen. Slow.
- An int that holds `n0 * 2^bits + n1`. Sums, products with integers, and order agree with the
  germs' as long as |n1| < 2^(bits - 1). `bits_needed` proves a sufficient number of bits; the tests
  run both kinds against each other. Fast.

Quotients `num / den` compare by `key = (num << shift) // den`: two quotients with denominators up
to D are equal or differ by at least 1 / D^2, so for 2^shift >= D^2 the keys have the same order as
the quotients. For germs this holds for each coefficient.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import total_ordering
from typing import Any

# int or Germ: any number with the operations above. No type names both.
Number = Any


@total_ordering
@dataclass(frozen=True, slots=True)
class Germ:
    """A number `low + high e`, with e > 0 smaller than every positive rational."""

    low: int
    high: int

    def __add__(self, other: Germ | int) -> Germ:
        if isinstance(other, int):
            return Germ(self.low + other, self.high)
        return Germ(self.low + other.low, self.high + other.high)

    __radd__ = __add__

    def __neg__(self) -> Germ:
        return Germ(-self.low, -self.high)

    def __sub__(self, other: Germ | int) -> Germ:
        return self + -other

    def __mul__(self, factor: int) -> Germ:
        if not isinstance(factor, int):
            raise TypeError("the product of two germs has a degree that no germ has")
        return Germ(self.low * factor, self.high * factor)

    __rmul__ = __mul__

    def __lshift__(self, bits: int) -> Germ:
        return Germ(self.low << bits, self.high << bits)

    def __floordiv__(self, divisor: int) -> Germ:
        return Germ(self.low // divisor, self.high // divisor)

    def __lt__(self, other: Germ) -> bool:
        return (self.low, self.high) < (other.low, other.high)


@dataclass(frozen=True)
class Track:
    """A coordinate `value + slope (s - s0)`."""

    value: Fraction
    slope: Fraction


@dataclass(frozen=True)
class Side:
    """The side of the scale a/b (-1 just below, 0 at, 1 just above) and the numbers'
    representation.

    A coordinate of sP + Q equals `of_p * x + of_q * y` for integer coordinates x, y of two points,
    all times `unit` (the common denominator of P and Q, times b).
    """

    of_p: Number
    of_q: Number
    unit: int
    side: int
    bits: int  # 0: plain integers at the scale, or explicit germs

    def track(self, numerator: Number, denominator: int) -> Track:
        """Return a number's coordinate; just below the scale, s - s0 is -e."""
        low, high = self.coefficients(numerator)
        den = denominator * self.unit
        return Track(Fraction(low, den), Fraction(high * self.side, den))

    def coefficients(self, number: Number) -> tuple[int, int]:
        if isinstance(number, Germ):
            return number.low, number.high
        if not self.bits:
            return number, 0
        half = 1 << (self.bits - 1)
        high = ((number + half) & ((1 << self.bits) - 1)) - half
        return (number - high) >> self.bits, high


def bits_needed(largest_coordinate: int, denominator: int, longest: int) -> int:
    """Count the bits needed for the e-part of all numbers and of all compared differences.

    Let m = largest_coordinate * denominator bound the coordinates' e-part, and r = longest bound
    the directions' entries: offsets are below 2 r m, places on a line (numerator, by cross(f, d))
    below 8 r^3 m, points below 12 r^4 m with denominators D <= 4 r^4, middles of edges below 96 r^8
    m over 32 r^8. Comparing two middles multiplies by 32 r^8 once more, by a direction 2 r, and
    takes a difference: below 2^16 r^17 m. For quotients the gap 1 / D^2 >= 2^-10 r^-16 between
    leading parts must exceed the e-parts.
    """
    m = max(1, largest_coordinate * denominator)
    return 32 + m.bit_length() + 34 * longest.bit_length()


def side_of(scale: Fraction, side: int, denominator: int, bits: int, explicit: bool) -> Side:
    a, b = scale.numerator, scale.denominator
    unit = b * denominator
    if side == 0:
        return Side(a, b, unit, 0, 0)
    if explicit:
        return Side(Germ(a, side * b), Germ(b, 0), unit, side, 0)
    return Side((a << bits) + side * b, b << bits, unit, side, bits)
