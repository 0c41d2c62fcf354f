"""The degree of the squared radii at which a sum with a disc changes, as docs/disc.md states it:
the fields of the lengths of edges have degree 8, but a change of the signs of all of them changes
the sign of the radius, and leaves its square."""

from __future__ import annotations

import random

import pytest
from minkref import _core
from minkref.plane.operand import read_operand
from turned_shapes import KINDS, shape_json, turned_shape

DEGREE = 4


def most(P: _core.PolygonSet) -> int:
    """The greatest degree among the events' squared radii; 0 without events."""
    events = _core.diagram_events(P)
    return max((len(row[2]) - 1 for row in events.rows(0, len(events))), default=0)


@pytest.mark.parametrize("model", ["g4", "glyph275"])
def test_squared_radii_of_models_have_degree_4_at_most(model: str) -> None:
    assert most(read_operand(model).set) == DEGREE


@pytest.mark.parametrize("kind", KINDS)
def test_squared_radii_of_turned_sets_have_degree_4_at_most(kind: str) -> None:
    dice = random.Random(f"degrees {kind}")
    shape, _ = turned_shape(kind, dice)
    assert most(_core.PolygonSet.from_json(shape_json(shape))) <= DEGREE
