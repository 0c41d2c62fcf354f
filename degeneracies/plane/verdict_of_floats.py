"""The answers of the paper's method in floating point, and the bits needed for a right answer."""

from __future__ import annotations

from collections.abc import Callable
from itertools import takewhile
from typing import Any

from minkref import _core

# Significand bits: all widths to try, ascending.
WIDTHS = (8, 12, 16, 20, 24, 28, 32, 40, 48, 53, 64, 80, 96, 113, 160, 237, 320, 512, 1024, 2048,
          4096)  # fmt: skip


def answer_in(arithmetic: str, P: _core.PolygonSet, Q: _core.PolygonSet, scale: str) -> list[int]:
    """Components, holes and vertices of the sum, with operands rounded and all signs decided in
    this arithmetic; empty if the method breaks down."""
    try:
        found = _core.minkowski_sum(P, Q, scale, "paper", arithmetic)
    except (_core.BadInput, _core.UndecidedSign, RuntimeError):
        return []
    return [found.components, found.holes, found.region.vertices]


def precision(P: _core.PolygonSet, Q: _core.PolygonSet, scale: str, truth: _core.Sum) -> Any:
    """Returns, for one scale, the answer in doubles; whether its component and hole counts are
    right (a vertex in the middle of a straight edge is no fault); and the least of WIDTHS from
    which on all widths give the right counts."""
    right = [truth.components, truth.holes]
    doubles = answer_in("double", P, Q, scale)
    return {
        "scale": scale,
        "doubles": doubles,
        "doubles_are_right": doubles[:2] == right,
        "deciding_bits": deciding_bits(
            lambda bits: answer_in(f"mpfr:{bits}", P, Q, scale)[:2] == right
        ),
    }


def deciding_bits(right: Callable[[int], bool]) -> int | None:
    """Returns the least of WIDTHS from which on every width answers right. None if the greatest
    width answers wrong."""
    good = list(takewhile(right, reversed(WIDTHS)))
    return good[-1] if good else None
