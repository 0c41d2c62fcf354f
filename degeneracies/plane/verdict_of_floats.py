"""The answers of the paper's method in floating point, and the bits it needs to be right."""

from __future__ import annotations

from collections.abc import Callable
from itertools import takewhile
from typing import Any

from minkref import _core

# Bits of a significand: all widths that are tried, ascending.
WIDTHS = (8, 12, 16, 20, 24, 28, 32, 40, 48, 53, 64, 80, 96, 113, 160, 237, 320, 512, 1024, 2048,
          4096)  # fmt: skip


def answer_in(arithmetic: str, P: _core.PolygonSet, Q: _core.PolygonSet, scale: str) -> list[int]:
    """Components, holes and vertices of the sum, operands rounded and all signs decided in this
    arithmetic; nothing where it breaks down."""
    try:
        found = _core.minkowski_sum(P, Q, scale, "paper", arithmetic)
    except (_core.BadInput, _core.UndecidedSign, RuntimeError):
        return []
    return [found.components, found.holes, found.region.vertices]


def precision(P: _core.PolygonSet, Q: _core.PolygonSet, scale: str, truth: _core.Sum) -> Any:
    """At one scale: the answer of doubles; whether its components and holes are as many as they
    should be (a vertex in the middle of a straight edge is no fault); and the least of WIDTHS from
    which on all of them answer so."""
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
    """The least of WIDTHS at which, and at all greater ones of which, the answer is right. None
    where it is wrong at the greatest."""
    good = list(takewhile(right, reversed(WIDTHS)))
    return good[-1] if good else None
