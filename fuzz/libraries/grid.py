"""Doubles and integer grids, as the adapters of libraries on a grid choose them."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable
from fractions import Fraction

Ring = list[tuple[str, str]]


def polygons_of(text: str) -> list[list[Ring]]:
    """Returns, for each polygon, the outer ring and holes, numbers as texts."""
    return [
        [[(x, y) for x, y in ring] for ring in (polygon["outer"], *polygon.get("holes", []))]
        for polygon in json.loads(text)["polygons"]
    ]


def shift_of(operands: Iterable[list[list[Ring]]], bits: int) -> int:
    """Coordinates are multiplied by 2 to this power (fuzz/adapters/integer_grid.hpp)."""
    size = sum(
        max(
            (abs(float(Fraction(n))) for rings in operand for r in rings for p in r for n in p),
            default=0.0,
        )
        for operand in operands
    )
    return bits - (math.frexp(size)[1] if size else 0)


def to_grid(number: str, shift: int) -> int:
    """The nearest double, times 2 to `shift`, rounded half away from zero."""
    exact = Fraction(float(Fraction(number))) * Fraction(2) ** shift
    rounded = math.floor(abs(exact) + Fraction(1, 2))
    return rounded if exact >= 0 else -rounded


def long_double(number: str, shift: int = 0) -> str:
    """A C++ expression for the number times 2 to `shift`, to the precision of a long double."""
    value = Fraction(number) * Fraction(2) ** shift
    if value.denominator == 1:
        return f"{value.numerator}.0L"
    return f"{value.numerator}.0L / {value.denominator}.0L"
