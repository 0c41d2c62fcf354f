"""Notches with walls parallel to the other operand's walls, or nearly: up to 1e-2 or 1e-30. Two
such edges cross at a quotient of numbers that nearly cancel."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref.fuzz.geometry.plane import Ring, Shape
from minkref.fuzz.plane.families.drawing import family

EXPONENTS = (2, 4, 8, 12, 14, 15, 16, 17, 18, 20, 24, 30)


@family("leaning")
def leaning_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """Two blocks with notches in their tops; each block's walls lean by multiples of a power of
    ten, mostly the same for both."""
    first = dice.choice(EXPONENTS)
    second = first if dice.random() < 0.7 else dice.choice(EXPONENTS)
    of_both = max(2, size // 8)
    of_first = dice.randint(1, of_both - 1)
    return (
        [[_notched(dice, of_first, Fraction(1, 10**first))]],
        [[_notched(dice, of_both - of_first, Fraction(1, 10**second))]],
    )


def _notched(dice: random.Random, notches: int, lean: Fraction) -> Ring:
    height = dice.randint(2, 6)
    ring: Ring = [(0, 0)]
    tops: Ring = [(0, height)]
    x = Fraction(0)
    for _ in range(notches):
        left = x + dice.randint(1, 3)
        x = left + dice.randint(1, 2)
        floor = dice.randint(1, height - 1)
        tops += [
            (left + lean * dice.randint(-4, 4), height), (left, floor),
            (x, floor), (x + lean * dice.randint(-4, 4), height),
        ]  # fmt: skip
    right = x + dice.randint(1, 2)
    return [*ring, (right, 0), (right, height), *reversed(tops)]
