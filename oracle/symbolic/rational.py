"""Exact rational numbers: read from text, written as text, and chosen between two others.

At run time `Rational` is gmpy2.mpq. Because gmpy2 has no types, type checkers see
fractions.Fraction, which has the same operations.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from fractions import Fraction as Rational
else:
    from gmpy2 import mpq as Rational  # noqa: N812

__all__ = ["Rational", "cells", "rational", "rationals", "text"]


def rational(value: str | int | Rational) -> Rational:
    """Convert a text, an integer or a number: 0.1 means 1/10. Exact.

    Raises ValueError for a text without a number, TypeError for a float, since no float counts as
    exact here."""
    if isinstance(value, float | bool):
        raise TypeError(f"{value!r} is no exact number; write it as a text or a fraction")
    if isinstance(value, str):
        value = value.strip()
    try:
        return Rational(value)
    except ZeroDivisionError:
        raise ValueError(f"{value!r} has the denominator zero") from None


def rationals(values: Iterable[str | int | Rational]) -> tuple[Rational, ...]:
    return tuple(rational(value) for value in values)


def text(value: Rational) -> str:
    """Write `n`, or `n/d` in lowest terms."""
    return str(value)


def cells(candidates: Iterable[Rational]) -> tuple[Sequence[Rational], Sequence[Rational]]:
    """Return the positive candidates ascending, and a rational from each open cell between them:
    `inner[i]` lies below `marks[i]`, `inner[-1]` above all. Exact, O(n log n)."""
    marks = sorted({mark for mark in candidates if mark > 0})
    if not marks:
        return marks, [Rational(1)]
    between = [(low + high) / 2 for low, high in pairwise(marks)]
    return marks, [marks[0] / 2, *between, marks[-1] + 1]
