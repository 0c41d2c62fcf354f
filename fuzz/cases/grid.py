"""Coordinates on grids: numbers that an implementation on a grid takes without rounding."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from minkref.fuzz.geometry.plane import Number


def bits_of(numbers: Iterable[Fraction]) -> int | None:
    """Returns the least b such that all numbers are integers, at most 2^b in absolute value, times
    one power of two; None if a denominator is no power of two."""
    unit = 0  # the finest unit's exponent
    values = [number for number in numbers if number]
    for number in values:
        if number.denominator & (number.denominator - 1):
            return None
        unit = max(unit, number.denominator.bit_length() - 1)
    wholes = [abs(number.numerator << unit) // number.denominator for number in values]
    if not wholes:
        return 0
    common = min((whole & -whole).bit_length() - 1 for whole in wholes)
    return (max(wholes) >> common).bit_length()


def rounded(number: Number, unit: Fraction) -> Fraction:
    """The nearest multiple of the unit."""
    return unit * round(number / unit)


def unit_for(largest: Fraction, bits: int) -> Fraction:
    """Returns the least power of two such that `largest` is at most 2^bits units."""
    exponent = 0
    while largest > Fraction(2) ** (exponent + bits):
        exponent += 1
    while exponent > -4096 and largest <= Fraction(2) ** (exponent + bits - 1):
        exponent -= 1
    return Fraction(2) ** exponent
