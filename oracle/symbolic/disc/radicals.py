"""Sums of square roots of rationals: exact sums, products, quotients, signs, minimal polynomials.

A number is the sum of c sqrt(m) over different squarefree integers m > 0, c rational. Square roots
of different squarefree integers are independent over Q (Besicovitch 1940), so a number is zero iff
all c are: every zero test is exact. Conjugates change signs of primes' roots; all are real, and the
different conjugates are the roots of the minimal polynomial.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from math import gcd, isqrt, lcm

import sympy as sp

from ..rational import Rational


@cache
def primes_of(m: int) -> tuple[int, ...]:
    return tuple(sorted(int(p) for p in sp.factorint(m)))


@dataclass(frozen=True, slots=True)
class Radical:
    """The number sum of c sqrt(m); `terms` are (m, c) by ascending m, no c zero."""

    terms: tuple[tuple[int, Rational], ...]

    @staticmethod
    def of(terms: Mapping[int, Rational]) -> Radical:
        return Radical(tuple(sorted((m, c) for m, c in terms.items() if c != 0)))

    def __add__(self, other: Radical | Rational | int) -> Radical:
        found = dict(self.terms)
        for m, c in number(other).terms:
            found[m] = found.get(m, Rational(0)) + c
        return Radical.of(found)

    def __neg__(self) -> Radical:
        return Radical(tuple((m, -c) for m, c in self.terms))

    def __sub__(self, other: Radical | Rational | int) -> Radical:
        return self + -number(other)

    def __rsub__(self, other: Radical | Rational | int) -> Radical:
        return number(other) - self

    def __mul__(self, other: Radical | Rational | int) -> Radical:
        found: dict[int, Rational] = {}
        for m, c in self.terms:
            for n, d in number(other).terms:
                common = gcd(m, n)
                key = m * n // common**2
                found[key] = found.get(key, Rational(0)) + c * d * common
        return Radical.of(found)

    __radd__ = __add__
    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> Radical:
        found = number(1)
        for _ in range(exponent):
            found = found * self
        return found

    def __truediv__(self, other: Radical | Rational | int) -> Radical:
        return self * number(other).inverse()

    def inverse(self) -> Radical:
        """Invert the number, by making the denominator rational prime after prime. Raises
        ZeroDivisionError."""
        if not self.terms:
            raise ZeroDivisionError("the inverse of zero")
        primes = {p for m, _ in self.terms for p in primes_of(m)}
        if not primes:
            return number(1 / self.terms[0][1])
        mirrored = self.flipped(max(primes))
        return mirrored * (self * mirrored).inverse()

    def flipped(self, prime: int) -> Radical:
        """Return the conjugate with the opposite sign for a prime's square root."""
        return Radical(tuple((m, -c if m % prime == 0 else c) for m, c in self.terms))

    def conjugates(self) -> list[Radical]:
        """List all different conjugates, this number first."""
        found = [self]
        for prime in sorted({p for m, _ in self.terms for p in primes_of(m)}):
            found = list(dict.fromkeys([*found, *(x.flipped(prime) for x in found)]))
        return found

    def minimal_polynomial(self) -> list[int]:
        """Return coprime integer coefficients, the highest power first and positive. Exact."""
        product = [number(1)]
        for root in self.conjugates():
            raised = [*product, number(0)]
            product = [x - root * y for x, y in zip(raised, [number(0), *product], strict=True)]
        rational = [dict(c.terms).get(1, Rational(0)) for c in product]
        scale = lcm(*(int(c.denominator) for c in rational))
        whole = [int(c * scale) for c in rational]
        return [c // gcd(*whole) for c in whole]

    def bounds(self, bits: int) -> tuple[Rational, Rational]:
        """Return rationals below and above (or equal to) the number, each root within 2^-bits."""
        low = high = Rational(0)
        for m, c in self.terms:
            floor = isqrt(m << 2 * bits)
            exact = floor * floor == m << 2 * bits
            ends = sorted((c * floor, c * (floor if exact else floor + 1)))
            low, high = low + ends[0], high + ends[1]
        return low / (1 << bits), high / (1 << bits)

    def sign(self) -> int:
        """Return -1, 0 or 1: exact, since only zero has no terms."""
        bits = 32
        while self.terms:
            low, high = self.bounds(bits)
            if low > 0 or high < 0:
                return 1 if low > 0 else -1
            bits *= 2
        return 0

    def isolated(self) -> tuple[Rational, Rational]:
        """Return an interval with rational ends and no other root of the minimal polynomial; its
        length is zero for a rational."""
        others, bits = self.conjugates()[1:], 16
        if not others:
            value = dict(self.terms).get(1, Rational(0))
            return value, value
        while True:
            low, high = self.bounds(bits)
            spans = [x.bounds(bits) for x in others]
            if all(above < low or high < below for below, above in spans):
                return low, high
            bits *= 2


def number(value: Radical | Rational | int) -> Radical:
    return value if isinstance(value, Radical) else Radical.of({1: Rational(value)})


def square_root(value: Rational) -> Radical:
    """Return the positive square root of a nonnegative rational; factors its integers."""
    n, d = int(value.numerator), int(value.denominator)
    if n < 0:
        raise ValueError("the square root of a negative number")
    if n == 0:
        return number(0)
    outside, inside = 1, 1
    for prime, exponent in sp.factorint(n * d).items():
        outside *= int(prime) ** (exponent // 2)
        inside *= int(prime) ** (exponent % 2)
    return Radical.of({inside: Rational(outside, d)})
