"""Pairs with a factor for each axis, from the families of the plane."""

from __future__ import annotations

from collections.abc import Iterator

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run import naming

SEED = 1203
# Taken in turn: every third pair comes from a degenerate family; many others have holes.
GENERAL = ("random", "convex", "holes", "star", "comb", "spiral", "cells", "rational")
DEGENERATE = ("fit", "collinear", "touching", "passing", "degenerate", "lattice", "nested")


def scaled_pair(index: int) -> Case:
    """The pair of an index. Even draws keep sP, so that what fits goes on to fit under S."""
    families = DEGENERATE if index % 3 == 2 else GENERAL
    family = families[index // 3 % len(families)]
    case = naming.load(CaseName(f"axes:{index}({family}:{SEED}:{index})", family))
    assert isinstance(case, Case)
    return case


def scaled_pairs(count: int) -> Iterator[Case]:
    """Pairs that have a sum: one operand at least is a region or empty."""
    index = found = 0
    while found < count:
        case = scaled_pair(index)
        index += 1
        if any(operand.is_region or operand.is_empty for operand in (case.P, case.Q)):
            found += 1
            yield case
