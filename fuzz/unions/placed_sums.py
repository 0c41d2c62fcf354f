"""Placed sums of a scene as sets to unite: copies of few shapes, scaled and placed on a lattice,
each plus the reflected robot."""

from __future__ import annotations

from minkref import _core
from minkref.fuzz.geometry.plane import Shape
from minkref.fuzz.plane.exact_shapes import shape_of
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import reflected
from minkref.fuzz.plane.families.lattice_pairs import lattice_operand

SCALES = ("1", "1", "2", "3")  # whole, as places are: many sums touch or abut
ROOM = 14


def scene_sets(dice: Dice) -> list[Shape]:
    """Draws a robot, one or two shapes, and two to six copies; returns their placed sums."""
    robot = reflected(_operand(dice, 4))
    shapes = [_operand(dice, 6) for _ in range(dice.randint(1, 2))]
    sets = []
    for _ in range(dice.randint(2, 6)):
        shape, scale = dice.choice(shapes), dice.choice(SCALES)
        placed = _core.minkowski_sum(shape, robot, scale).region
        x, y = dice.randint(0, ROOM), dice.randint(0, ROOM)
        sets.append(shape_of(placed.translated(str(x), str(y))))
    return sets


def _operand(dice: Dice, most: int) -> _core.PolygonSet:
    return _core.PolygonSet.from_json(lattice_operand(dice, most < 6, most + 2))
