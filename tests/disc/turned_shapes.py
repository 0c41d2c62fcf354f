"""Sets on which doubles lose the corners of a sum with a disc: rectilinear sets turned in doubles,
and others."""

from __future__ import annotations

import math
import random
from fractions import Fraction

Shape = list[list[tuple[Fraction, Fraction]]]
KINDS = ("slot", "walls", "flat", "street", "far", "board", "comb")


def turned_shape(kind: str, dice: random.Random) -> tuple[Shape, Fraction]:
    """A polygon set's outer rings, and a difficult squared radius."""
    if kind == "walls":
        return _walls(dice)
    angle = dice.uniform(0, 2 * math.pi)
    scale, at = 1.0, (0.0, 0.0)
    if kind == "far":
        at = dice.uniform(4e5, 6e5), dice.uniform(5e6, 7e6)
    if kind == "board":
        scale, at = 1e-9, (dice.uniform(0, 1), dice.uniform(0, 1))
    width = dice.choice((1.0, 0.25, dice.uniform(0.2, 1.5)))
    radius = Fraction(width) / 2
    rings = [[(0, 0), (5, 0), (5, 4), (3 + width, 4), (3 + width, 1), (3, 1), (3, 4), (0, 4)]]
    if kind == "street":
        rings = [[(0, 0), (3, 0), (3, 2), (0, 2)], [(1, 2 + width), (4, 2 + width), (4, 5), (1, 5)]]
    if kind == "comb":
        rings = [[(0, 0), (7, 0), (7, 3), (6, 3), (6, 1), (6 - width, 1), (6 - width, 3),
                  (2 + width, 3), (2 + width, 1), (2, 1), (2, 3), (0, 3)]]  # fmt: skip
    if kind == "flat":
        rings = [[(0, 0), (0, 3), (0, 10), (-5, 10), (-5, 0)]]
    c, s = math.cos(angle), math.sin(angle)

    def moved(x: float, y: float) -> tuple[Fraction, Fraction]:
        return (
            Fraction(scale * (c * x - s * y) + at[0]), Fraction(scale * (s * x + c * y) + at[1])
        )  # fmt: skip

    shape = [[moved(*point) for point in ring] for ring in rings]
    return shape, (radius * Fraction(scale)) ** 2


def _walls(dice: random.Random) -> tuple[Shape, Fraction]:
    """A slot with a slightly wider bottom, and a radius between both half widths."""
    more = Fraction(1, 10 ** dice.choice((8, 16, 18, 30)))
    shape = [[(0, 0), (3, 0), (3, 4), (2, 4), (2 + more, 1), (1, 1), (1, 4), (0, 4)]]
    half = Fraction(1, 2) + more * dice.choice((Fraction(1, 4), Fraction(1, 8), Fraction(7, 16)))
    return [[(Fraction(x), Fraction(y)) for x, y in ring] for ring in shape], half**2


def shape_json(shape: Shape) -> str:
    rings = ",".join(
        '{"outer":[' + ",".join(f'["{x}","{y}"]' for x, y in ring) + "]}" for ring in shape
    )
    return '{"polygons":[' + rings + "]}"
