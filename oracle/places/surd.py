"""Exact numbers a + b √d with one square root."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import isqrt, sqrt


def sign_of(value: Fraction | int) -> int:
    return (value > 0) - (value < 0)


@dataclass(frozen=True, slots=True)
class Surd:
    """A number a + b √d with a rational d ≥ 0. Sums and products need a common root or a rational
    operand (b = 0), else ValueError."""

    a: Fraction
    b: Fraction = Fraction(0)
    d: Fraction = Fraction(0)

    @classmethod
    def root(cls, square: Fraction) -> Surd:
        """Return √square, rational where possible."""
        top, below = isqrt(square.numerator), isqrt(square.denominator)
        if top * top == square.numerator and below * below == square.denominator:
            return cls(Fraction(top, below))
        return cls(Fraction(0), Fraction(1), square)

    def _with(self, other: Surd) -> Fraction:
        """Return the common root."""
        if self.b and other.b and self.d != other.d:
            raise ValueError("numbers of two roots")
        return self.d if self.b else other.d

    def __add__(self, other: Surd) -> Surd:
        return Surd(self.a + other.a, self.b + other.b, self._with(other))

    def __sub__(self, other: Surd) -> Surd:
        return Surd(self.a - other.a, self.b - other.b, self._with(other))

    def __mul__(self, other: Surd) -> Surd:
        d = self._with(other)
        return Surd(self.a * other.a + self.b * other.b * d, self.a * other.b + self.b * other.a, d)

    def times(self, factor: Fraction) -> Surd:
        return Surd(self.a * factor, self.b * factor, self.d)

    def sign(self) -> int:
        first, second = sign_of(self.a), sign_of(self.b) * sign_of(self.d)
        if first * second >= 0:
            return first or second
        return first * sign_of(self.a * self.a - self.b * self.b * self.d)

    @property
    def rational(self) -> Fraction | None:
        return self.a if not self.b or not self.d else None

    def __float__(self) -> float:
        return float(self.a) + float(self.b) * sqrt(self.d)


def order(x: Surd, y: Surd) -> int:
    """Return the sign of x - y, for different roots too."""
    if not x.b or not y.b or x.d == y.d:
        return (x - y).sign()
    left, right = Surd(x.a - y.a, x.b, x.d), Surd(Fraction(0), y.b, y.d)
    of_left, of_right = left.sign(), right.sign()
    if of_left != of_right:
        return sign_of(of_left - of_right)
    return of_left * (left * left - right * right).sign()


def surd(value: Fraction | int) -> Surd:
    return Surd(Fraction(value))
