"""Rationals of few digits."""

from __future__ import annotations

from fractions import Fraction
from math import floor


def simplest_between(low: Fraction, high: Fraction) -> Fraction:
    """The rational of the least denominator in [low, high], 0 <= low < high (continued
    fractions)."""
    whole = floor(low)
    if whole == low:
        return low
    if whole + 1 <= high:
        return Fraction(whole + 1)
    return whole + 1 / simplest_between(1 / (high - whole), 1 / (low - whole))
