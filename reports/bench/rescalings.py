"""The re-scalings of Table 1: seeded, never the same scale twice in a row."""

from __future__ import annotations

import random
from fractions import Fraction

WINDOW = ("1/10", "10")


def rescalings(seed: int, count: int) -> list[str]:
    """`count` exact scales from {0.1, 0.2, ..., 10.0}."""
    chosen: list[int] = []
    numbers = random.Random(seed)
    while len(chosen) < count:
        tenths = numbers.randint(1, 100)
        if not chosen or tenths != chosen[-1]:
            chosen.append(tenths)
    return [str(Fraction(tenths, 10)) for tenths in chosen]
