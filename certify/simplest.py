"""Rationals of few digits."""

from __future__ import annotations

from fractions import Fraction


def simplest_between(low: Fraction, high: Fraction) -> Fraction:
    """Returns the rational with the least denominator between low and high, 0 <= low < high. Exact;
    continued fractions, a step for each term that the bounds share."""
    (a, b), (c, d) = low.as_integer_ratio(), high.as_integer_ratio()  # remainders of the bounds
    before, last = (0, 1), (1, 0)  # the last two convergents
    while True:
        whole = a // b
        if whole * b == a or (whole + 1) * d <= c:
            term = whole if whole * b == a else whole + 1
            return Fraction(term * last[0] + before[0], term * last[1] + before[1])
        before, last = last, (whole * last[0] + before[0], whole * last[1] + before[1])
        a, b, c, d = d, c - whole * d, b, a - whole * b
