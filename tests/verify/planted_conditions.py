"""Sums with one planted condition each that makes them wrong, as targets
`py:planted_conditions:NAME`."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from faulty_sums import right

Set = dict[str, Any]


def rings(operand: Set) -> Iterator[list[list[str]]]:
    for polygon in operand["polygons"]:
        yield polygon["outer"]
        yield from polygon["holes"]


def holes(operand: Set) -> int:
    return sum(len(polygon["holes"]) for polygon in operand["polygons"])


def vertices(operand: Set) -> int:
    return sum(map(len, rings(operand)))


def largest(operand: Set) -> Fraction:
    return max((abs(Fraction(n)) for r in rings(operand) for p in r for n in p), default=Fraction())


def shifted(value: Set) -> Set:
    for ring in rings(value):
        for point in ring:
            point[0] = str(Fraction(point[0]) + 1)
    return value


def hole_and_vertices(P: Set, Q: Set) -> Set:
    """Wrong iff Q has a hole and P more than three vertices."""
    value = right(P, Q)
    return shifted(value) if holes(Q) and vertices(P) > 3 else value


def large(P: Set, Q: Set) -> Set:
    """Wrong iff a coordinate exceeds 100."""
    value = right(P, Q)
    return shifted(value) if max(largest(P), largest(Q)) > 100 else value


def fractions(P: Set, Q: Set) -> Set:
    """Wrong iff sP has a non-integer coordinate."""
    value = right(P, Q)
    odd = any(Fraction(n).denominator > 1 for r in rings(P) for p in r for n in p)
    return shifted(value) if odd else value


def dies_of_two_holes(P: Set, Q: Set) -> Set:
    if holes(P) + holes(Q) >= 2:
        os.kill(os.getpid(), signal.SIGFPE)
    return right(P, Q)


def two_faults(P: Set, Q: Set) -> Set:
    """Dies of two holes, and is wrong iff a hole exists."""
    value = dies_of_two_holes(P, Q)
    return shifted(value) if holes(P) + holes(Q) else value
