"""Exact areas and volumes: fractions that may also be called for their text."""

from __future__ import annotations

from fractions import Fraction


class Quantity(Fraction):
    """An exact area or volume, a Fraction. `quantity()` gives the text `n` or `n/d`, as methods of
    the same name did."""

    def __call__(self) -> str:
        return str(self)

    def __repr__(self) -> str:
        return f"Fraction({self.numerator}, {self.denominator})"
