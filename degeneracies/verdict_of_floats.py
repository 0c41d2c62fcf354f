"""What the paper's method answers in floating point, and how many bits it needs to be right."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.fuzz.least_precision import least_bits

MOST_BITS = 4096


def answer_in(arithmetic: str, P: _core.PolygonSet, Q: _core.PolygonSet, scale: str) -> list[int]:
    """Components, holes and vertices of the sum, all signs decided in this arithmetic; nothing
    where it breaks down."""
    try:
        return counts_of(_core.minkowski_sum(P, Q, scale, "paper", arithmetic))
    except (_core.BadInput, _core.UndecidedSign, RuntimeError):
        return []


def counts_of(sum_: _core.Sum) -> list[int]:
    return [sum_.components, sum_.holes, sum_.region.vertices]


def precision(P: _core.PolygonSet, Q: _core.PolygonSet, scale: str, truth: list[int]) -> Any:
    """At one scale: the answer of doubles, whether it is right in these counts, and the least
    number of bits of a significand that is (None where 4096 are too few)."""
    doubles = answer_in("double", P, Q, scale)
    bits = least_bits(lambda bits: answer_in(f"mpfr:{bits}", P, Q, scale) == truth, MOST_BITS)
    return {
        "scale": scale,
        "doubles": doubles,
        "doubles_are_right": doubles == truth,
        "deciding_bits": bits,
    }
