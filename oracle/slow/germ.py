"""Numbers at, just below and just above a scale.

Every number that the sum computes is `n0 + n1 e` with integers n0, n1, where the scale is s0 - e,
s0 or s0 + e and e is a positive infinitesimal: it is made from the coordinates, which are so, by
sums, by products with integers, and by order. The code adds, subtracts, multiplies by an int,
shifts, compares and divides by an int; it never multiplies two such numbers. Two kinds of numbers
can do that:

- `Germ` says so itself: a product of two germs is a TypeError, so no degree is exceeded unseen.
  Slow.
- An int that holds `n0 * 2^bits + n1`. It is the same as long as |n1| < 2^(bits - 1): sums and
  products by integers then are those of the germs, and order is the lexicographic one.
  `bits_needed` gives bits with a proof; the tests run both kinds against each other. Fast.

A quotient `num / den` is compared by `key = (num << shift) // den`: two quotients with denominators
up to D differ by nothing or by 1 / D^2 or more, so for 2^shift >= D^2 keys are equal, less or
greater as the quotients are. For germs this holds for each coefficient.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import total_ordering
from typing import Any

# int or Germ: whatever can do what is listed above. No type can name what both have.
Number = Any


@total_ordering
@dataclass(frozen=True, slots=True)
class Germ:
    """`low + high e` with e > 0 smaller than every positive rational."""

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
    """The coordinate `value + slope (s - s0)`."""

    value: Fraction
    slope: Fraction


@dataclass(frozen=True)
class Side:
    """Where the scale a/b stands (-1 just below, 0 at it, 1 just above) and how numbers are held.

    A coordinate of sP + Q is `of_p * x + of_q * y` with x, y the integer coordinates of the two
    points, all times `unit` (the common denominator of P and Q, times b).
    """

    of_p: Number
    of_q: Number
    unit: int
    side: int
    bits: int  # 0: plain integers at the scale, or explicit germs

    def track(self, numerator: Number, denominator: int) -> Track:
        """The coordinate behind a number; just below the scale s - s0 is -e."""
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
    """Bits that hold the e-part of all numbers and of all differences that are compared.

    With m = largest_coordinate * denominator a bound of the e-part of coordinates and r = longest a
    bound of the entries of directions: offsets are below 2 r m, places on a line (numerator, by
    cross(f, d)) below 8 r^3 m, points below 12 r^4 m with denominators D <= 4 r^4, middles of edges
    below 96 r^8 m over 32 r^8. Comparing two of those multiplies by 32 r^8 once more, by a
    direction 2 r, and takes a difference: below 2^16 r^17 m. Quotients also need the gap 1 / D^2 >=
    2^-10 r^-16 of the leading parts to exceed the e-parts.
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
