"""Corners that pass each other on one line: at one scale two pairs of corners touch and close a
pocket, which is open just below and just above. A topology event of the kind `touch`."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref.fuzz.geometry.plane import Polygon, Ring, Shape, box, scaled
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import placed, shape_text
from minkref.fuzz.plane.families.random_pairs import Pair

FRAME, WALL = 600, 50  # half the opening of a frame around everything, and its thickness
FRAMED, SCALED_FROM = 12, 60  # first indices of pairs with a frame, and at other scales than 1
SCALES = (Fraction(2), Fraction(5, 2), Fraction(3), Fraction(4))


def passing_pair(seed: int, index: int) -> Pair:
    """A pair at the touching scale, or at three quarters of it; for early pairs, and some others,
    the scale is 1."""
    dice = Dice(f"minkref passing {seed} {index}")
    scale = dice.choice(SCALES)
    left, right = -dice.randint(8, 12) * 2, dice.randint(8, 12) * 2
    tips, count = dice.randint(4, 8) * 2, dice.randint(2, 2 + min(index, 60) // 20)
    first = -dice.randint(20, 60)
    second = first + scale * (right - left)
    P: Shape = [[_wedge(dice, right, 1)], [_wedge(dice, left, -1)]]
    Q: Shape = [_teeth(dice, first, tips, count, 1), _teeth(dice, second, tips, count, -1)]
    if index >= FRAMED and dice.random() < 0.5:  # the pocket belongs to a hole, not to the outside
        side, inner = FRAME + WALL, 2 * FRAME
        Q.append([box(-side, -side, 2 * side, 2 * side), box(-FRAME, -FRAME, inner, inner)])
    turns, mirrored = dice.randrange(4), dice.random() < 0.5
    at = scale if dice.random() < 0.5 else scale * Fraction(3, 4)
    if index <= SCALED_FROM or dice.random() < 0.5:
        P, at = scaled(P, at), Fraction(1)
    texts = [shape_text(placed(shape, turns, mirrored)) for shape in (P, Q)]
    return Pair(seed, index, 6 + 8 * count, texts[0], texts[1], str(at))


def _wedge(dice: random.Random, x: Fraction | int, way: int) -> Ring:
    """A triangle standing on its tip at (x, 0), or hanging from it; steeper than the teeth."""
    height = dice.randint(5, 9)
    return [(x, 0), (x + 1, way * height), (x - 1, way * height)]


def _teeth(dice: random.Random, x: Fraction | int, apart: int, count: int, way: int) -> Polygon:
    """A bar above the line (or below) with teeth that reach the line."""
    height, width = dice.randint(6, 9), dice.randint(1, 4)
    ring: Ring = []
    for k in range(count):
        if k:
            ring.append((x + apart * k - Fraction(apart, 2), way * dice.randint(2, 5)))
        ring.append((x + apart * k, 0))
    ring += [(x + apart * (count - 1) + width, way * height), (x - width, way * height)]
    return [ring]
