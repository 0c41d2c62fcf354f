"""Prisms over random polygons of a grid, with holes that touch nothing."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import combinations

from minkref import _core
from minkref.fuzz.geometry.plane import written_rings
from minkref.fuzz.plane.families.integer_rings import Ring, rings_meet
from minkref.fuzz.plane.families.random_pairs import random_operand
from minkref.fuzz.space.prism import Prism


def random_prism(dice: random.Random, grid: int, most_holes: int) -> Prism:
    """Integer corners in the plane; heights with small denominators."""
    while True:
        text = random_operand(dice, grid, most_holes)
        rings = written_rings(text)
        if not any(rings_meet(_whole(a), _whole(b)) for a, b in combinations(rings, 2)):
            break
    low = Fraction(dice.randint(-4, 4), dice.randint(1, 3))
    return Prism(
        _core.PolygonSet.from_json(text),
        low,
        low + Fraction(dice.randint(1, 6), dice.randint(1, 3)),
    )


def _whole(ring: list[list[str]]) -> Ring:
    return [(int(x), int(y)) for x, y in ring]
