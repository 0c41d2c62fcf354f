"""Exact radii where features change, compared with numbers."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import isqrt


@dataclass(frozen=True)
class ExactRadius:
    """A radius between `low` and `high`; its rational square, else a polynomial with that root,
    lowest coefficient first."""

    low: Fraction
    high: Fraction
    square: Fraction | None = None
    polynomial: tuple[Fraction, ...] = ()

    def compare_square(self, number: Fraction) -> int:
        """The sign of squared radius minus number. Exact if the polynomial has one root between
        both squared bounds, which belong to it; else 0 there."""
        if self.square is not None:
            return (self.square > number) - (self.square < number)
        low, high = self.low**2, self.high**2
        if not low <= number <= high:
            return 1 if number < low else -1
        at_low, here, at_high = (_sign(self.polynomial, x) for x in (low, number, high))
        if here == 0 or low == high:
            return 0
        if number in (low, high):
            return 1 if number == low else -1
        if at_low * at_high >= 0:
            return 0
        return 1 if here == at_low else -1

    @property
    def text(self) -> str:
        """Number, square root, or nearby double."""
        if self.square is None:
            return f"about {float(self.low)!r}"
        root = Fraction(isqrt(self.square.numerator), isqrt(self.square.denominator))
        return str(root) if root**2 == self.square else f"sqrt({self.square})"

    @property
    def near(self) -> float:
        return float((self.low + self.high) / 2)


ZERO = ExactRadius(Fraction(0), Fraction(0), Fraction(0))


def _sign(polynomial: tuple[Fraction, ...], at: Fraction) -> int:
    total = Fraction(0)
    for factor in reversed(polynomial):
        total = total * at + factor
    return (total > 0) - (total < 0)
