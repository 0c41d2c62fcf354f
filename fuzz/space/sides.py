"""Points beside a face."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref.fuzz.geometry.space import Point, Whole
from minkref.fuzz.space.membership import Surface


def both_sides(surface: Surface, place: Point, n: Whole) -> tuple[Point, Point]:
    """Returns two points so near a place on a triangle with normal `n` that the surface has no
    point between: outside and inside. Neither lies on the surface."""
    dice = random.Random(f"side {place}")
    length = max(abs(number) for number in n)
    spread = 0
    while True:
        x, y, z = (Fraction(number + dice.randint(-spread, spread) * length // 64) for number in n)
        if n[0] * x + n[1] * y + n[2] * z > 0:
            t = surface.clear_step(place, (x, y, z))
            if t is not None:
                return (
                    (place[0] + t * x, place[1] + t * y, place[2] + t * z),
                    (place[0] - t * x, place[1] - t * y, place[2] - t * z),
                )
        length = max(length, 64)
        spread += 1
