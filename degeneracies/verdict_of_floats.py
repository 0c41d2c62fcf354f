"""What the paper's method answers in floating point, and how many bits it needs to be right."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable
from typing import Any

from minkref import _core

FEWEST_BITS, MOST_BITS = 8, 4096


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
    """At one scale: the answer of doubles, whether it is right in these counts, and the number of
    bits of a significand from which on it is."""
    doubles = answer_in("double", P, Q, scale)
    bits = bits_from_which(lambda bits: answer_in(f"mpfr:{bits}", P, Q, scale) == truth)
    return {
        "scale": scale,
        "doubles": doubles,
        "doubles_are_right": doubles == truth,
        "deciding_bits": bits,
    }


def bits_from_which(right: Callable[[int], bool]) -> int | None:
    """Found by halving from 4096 bits until an answer is wrong, then by bisection between the last
    two: fewer bits may be right by luck, and bits between those that were tried may be wrong. None
    where 4096 are too few."""
    high = MOST_BITS
    if not right(high):
        return None
    while high > FEWEST_BITS and right(high // 2):
        high //= 2
    if high == FEWEST_BITS:
        return high
    return bisect_left(range(high), True, high // 2 + 1, key=right)
