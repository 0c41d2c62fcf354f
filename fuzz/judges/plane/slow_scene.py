"""A scene by the slow engine."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from minkref import _core
from minkref.oracle.slow import Operand, operand_from_json
from minkref.oracle.slow.scene import scene_sum

Place = tuple[Fraction, Fraction]


class SlowScene(NamedTuple):
    """The union of the sums of all copies, and its tight passages."""

    digest: str
    components: int
    holes: int
    tight: list[list[Place]]


def slow_scene(
    robot: _core.PolygonSet,
    shapes: Sequence[_core.PolygonSet],
    copies: Sequence[tuple[int, Fraction, Place]],
) -> SlowScene:
    """From the definition: all pairs of convex pieces, of all copies. Slow."""
    operands = [_operand(shape) for shape in shapes]
    placed = [(operands[shape], scale, place) for shape, scale, place in copies]
    found = scene_sum(_operand(robot), placed)
    return SlowScene(found.digest, found.components, found.holes, found.tight)


def _operand(given: _core.PolygonSet) -> Operand:
    return operand_from_json(json.loads(given.to_json()))
