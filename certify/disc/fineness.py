"""How many decimals tell the places of a boundary apart, by the digits of the input."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from math import log2

from minkref.certify.plane.certificate import NoProof

FEWEST = 16
MOST = 2000  # beyond: a set of five edges takes minutes
DIGIT = log2(10)  # bits


@dataclass(frozen=True)
class Fineness:
    """Counts for numbers of `length` digits. Places where curves meet have errors near
    10^(-9 length) of the size, and differ by more than 10^(-3 length) of the radius, unless a set
    is made so that roots of its numbers nearly agree."""

    length: int

    @classmethod
    def of(cls, coordinates: Iterable[Fraction], square: Fraction) -> Fineness:
        """Adds the digits before and after the point, of coordinates and radius. Raises NoProof for
        more than MOST."""
        numbers = list(coordinates)
        bits = max(c.numerator.bit_length() for c in numbers)
        bits += max(c.denominator.bit_length() for c in numbers)
        bits += (square.numerator.bit_length() + square.denominator.bit_length()) // 2
        length = max(FEWEST, int(bits / DIGIT) + 1)
        if length > MOST:
            raise NoProof(
                f"coordinates and radius have {length:,} digits together, before and after the "
                f"point; certificates of sums with a disc are made for {MOST:,} and fewer",
                "take numbers whose sizes differ less",
            )
        return cls(length)

    @property
    def digits(self) -> int:
        """Decimals are written with so many."""
        return 10 * self.length

    @property
    def same(self) -> Decimal:
        """Positions on a curve nearer to each other, by this part of the size, are one."""
        return Decimal(10) ** (-4 * self.length)

    @property
    def grid(self) -> Decimal:
        """Places nearer to each other, by this part of the radius, are one joint."""
        return Decimal(10) ** (-3 * self.length)
