"""A box with many dented holes, and a triangle so small that most of each hole survives.

The remaining hole has thin places: this exposes code that decides by one point of a face whether
the face is a hole.
"""

from __future__ import annotations

import random

from minkref.fuzz.geometry.plane import Ring, Shape, box
from minkref.fuzz.plane.families.drawing import family
from minkref.fuzz.plane.families.integer_rings import scattered, untangled

CELL = 12  # across, for each hole
FEW = 14  # up to so many vertices, a pair has one hole


@family("dents")
def dented_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    across, corners = (1, 5) if size <= FEW else dice.choice(((3, 5), (4, 4)))
    side = across * CELL
    polygon: list[Ring] = [box(0, 0, side, side)]
    for x in range(0, side, CELL):
        for y in range(0, side, CELL):
            hole = _ring(dice, corners, CELL - 2)
            polygon.append([(a + x + 1, b + y + 1) for a, b in hole])
    return [polygon], [[_ring(dice, 3, 1)]]


def _ring(dice: random.Random, vertices: int, side: int) -> Ring:
    while True:
        ring = untangled(scattered(dice, vertices, side, side))
        if ring is not None:
            return list(ring)
