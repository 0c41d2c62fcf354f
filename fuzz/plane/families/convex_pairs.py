"""Convex operands, and operands on which many vertices lie on a line and many edges are
parallel."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref.fuzz.geometry.plane import Ring, Shape, box
from minkref.fuzz.plane.families.drawing import convex, family


@family("convex")
def convex_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    first = dice.randint(3, size - 3)
    reach = dice.choice((6, 20, 100, 1000) if size < 20 else (100, 300, 1000))
    return [[convex(dice, first, reach)]], [[convex(dice, size - first, reach)]]


@family("collinear")
def collinear_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """Two rings with edges of the same directions, all cut into collinear parts."""
    corners = dice.randint(3, max(3, min(8, size // 4)))
    P = _of_steps(dice, corners)
    Q: Ring
    kind = dice.random()
    if kind < 0.3:
        Q = box(0, 0, dice.randint(1, 4), dice.randint(1, 4))
    elif kind < 0.6:
        factor = Fraction(dice.randint(1, 3), dice.randint(1, 3))
        Q = [(x * factor, y * factor) for x, y in P]
    elif kind < 0.8:
        Q = [(-x, -y) for x, y in P]
    else:
        Q = _of_steps(dice, corners)
    each = max(1, size // 2 - corners)
    return [[_cut(dice, P, each)]], [[_cut(dice, Q, dice.randint(0, each))]]


def _of_steps(dice: random.Random, corners: int) -> Ring:
    """An L, a T, a staircase or a convex ring."""
    kind = dice.random()
    a, b, c, d = (dice.randint(1, 4) for _ in range(4))
    if kind < 0.3 and corners >= 6:
        return [(0, 0), (a + b, 0), (a + b, c), (a, c), (a, c + d), (0, c + d)]
    if kind < 0.5 and corners >= 8:
        return [
            (0, 0), (a, 0), (a, c), (a + b, c), (a + b, c + d), (-d, c + d), (-d, c), (0, c)
        ]  # fmt: skip
    if kind < 0.7:
        steps = max(1, corners // 2 - 1)
        ring: Ring = [(0, 0), (steps, 0)]
        for k in range(steps, 0, -1):
            ring += [(k, steps - k + 1), (k - 1, steps - k + 1)]
        return ring[:-1] if steps == 1 else ring
    return convex(dice, corners, 8)


def _cut(dice: random.Random, ring: Ring, more: int) -> Ring:
    """With so many vertices more, all on edges."""
    ring = list(ring)
    for _ in range(more):
        k = dice.randrange(len(ring))
        (ax, ay), (bx, by) = ring[k - 1], ring[k]
        t = Fraction(dice.randint(1, 5), 6)
        ring.insert(k, (ax + t * (bx - ax), ay + t * (by - ay)))
    return ring
