"""Scenes against the slow engine, which unites sums of all pairs of pieces."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

import minkref
import pytest
from minkref.oracle.slow import Operand, operand_from_json
from minkref.oracle.slow.minkowski import Sum
from minkref.oracle.slow.scene import scene_sum
from scene_draws import Draw, scenes
from thoroughness import draws

SEED = 8112
BLOCKS = 6


def operand(given: minkref.PolygonSet) -> Operand:
    return operand_from_json(json.loads(given.to_json()))


def slow(draw: Draw) -> Sum:
    shapes = {name: operand(shape) for name, shape in draw.shapes.items()}
    copies = [(shapes[str(copy.shape)], copy.scale, copy.place) for copy in draw.copies]
    return scene_sum(operand(draw.robot), copies)


@pytest.mark.parametrize("block", range(BLOCKS))
def test_a_scene_is_the_union_of_the_sums_of_all_pieces(block: int) -> None:
    """Digest, components, holes and tight passages agree."""
    for draw in list(scenes(SEED, draws(21, 70) * BLOCKS))[block::BLOCKS]:
        expected = slow(draw)
        found = draw.scene(passages=True)
        assert found.digest == expected.digest, draw.told
        counts = (found.components, found.holes)
        assert counts == (expected.components, expected.holes), draw.told
        passages = [list(passage.points) for passage in found.passages()]
        assert passages == expected.tight, draw.told


UNIT = operand_from_json({"polygons": [{"outer": [[0, 0], [1, 0], [1, 1], [0, 1]]}]})


def at(x: Any, y: Any, scale: Any = 1) -> tuple[Operand, Fraction, tuple[Fraction, Fraction]]:
    return UNIT, Fraction(scale), (Fraction(x), Fraction(y))


def line(*points: tuple[int, int]) -> list[tuple[Fraction, Fraction]]:
    return [(Fraction(x), Fraction(y)) for x, y in points]


def test_by_hand_a_gap_as_wide_as_the_robot_is_a_tight_segment() -> None:
    found = scene_sum(UNIT, [at(0, 0), at(2, 0)])
    assert (found.area, found.components, found.tight) == (8, 1, [line((1, -1), (1, 1))])
    assert scene_sum(UNIT, [at(0, 0), at(1, 0)]).tight == []


def test_by_hand_a_point_does_not_pass_a_seam_and_a_segment_does_not_slide_in_it() -> None:
    upright = Operand([], line((0, 0), (0, 1)))
    for robot, area in ((Operand([], line((0, 0))), 2), (upright, 4)):
        found = scene_sum(robot, [at(0, 0), at(1, 0)])
        assert (found.area, found.components, found.tight) == (area, 1, [])
    level = Operand([], line((0, 0), (1, 0)))
    assert scene_sum(level, [at(0, 0), at(2, 0)]).tight == [line((1, 0), (1, 1))]


def test_by_hand_a_scene_without_copies_is_empty() -> None:
    found = scene_sum(UNIT, [])
    assert (found.area, found.components, found.holes, found.tight) == (0, 0, 0, [])
