"""Validity of polygon sets in the slow engine, against the definition and against the reference.

Laws: a set is refused iff one of the conditions of docs/definitions.md, "Polygon set", fails; the
slow engine and the reference, which share no code, refuse the same sets.
"""

from __future__ import annotations

import json
from collections import Counter

import pytest
from minkref import _core
from minkref.exact import set_json
from minkref.fuzz.geometry.plane import Ring
from minkref.oracle.slow import InputError, operand_from_json
from minkref.oracle.slow.validity import refuse_invalid
from spoilt_shapes import shapes, toothed
from thoroughness import draws

SEED = 21
COUNT = draws(4, 12)  # pairs of each family; six shapes of each
SQUARE = [[0, 0], [9, 0], [9, 9], [0, 9]]


def slow_refusal(text: str) -> str:
    """The slow engine's refusal; empty for a valid set."""
    try:
        refuse_invalid(operand_from_json(json.loads(text), as_given=True).polygons)
    except InputError as error:
        return str(error)
    return ""


def refusal(text: str) -> str:
    try:
        _core.PolygonSet.from_json(text).validate("operand")
    except _core.BadInput as error:
        return error.code
    return ""


def test_the_reference_refuses_the_same_sets() -> None:
    seen: Counter[str] = Counter()
    for name, shape in shapes(SEED, 0, COUNT):
        text = set_json((rings[0], rings[1:]) for rings in shape)
        code, words = refusal(text), slow_refusal(text)
        assert bool(code) == bool(words), f"{name}: {code!r} {words!r} {text}"
        seen[code] += 1
    refused = seen.total() - seen[""]
    assert len(seen) >= 8 and min(seen[""], refused) > 50 * COUNT / 3, seen


def polygon_set(*polygons: list[object]) -> str:
    return json.dumps({"polygons": [{"outer": rings[0], "holes": rings[1:]} for rings in polygons]})


@pytest.mark.parametrize(
    "polygons",
    [
        [[SQUARE]],
        [[SQUARE, [[0, 0], [1, 2], [2, 1]]]],  # a hole at a vertex
        [[SQUARE, [[0, 4], [2, 5], [2, 3]], [[2, 5], [3, 9], [4, 5]]]],  # a chain of touches
        [[SQUARE], [[[9, 9], [12, 9], [12, 12]]], [[[0, 4], [-3, 5], [-3, 3]]]],
        [[SQUARE, [[1, 1], [1, 8], [8, 8], [8, 1]]], [[[1, 1], [7, 2], [2, 7]]]],
        [[[[0, 0], [3, 0], [9, 0], [9, 9], [9, 9.5], [0, 9]]]],
        [],
        [[[[1, 2]]]],
        [[[[1, 2], [3, 4]]]],
    ],
)
def test_valid_sets(polygons: list[list[object]]) -> None:
    text = polygon_set(*polygons).replace("9.5", '"19/2"')
    assert slow_refusal(text) == "" == refusal(text)


@pytest.mark.parametrize(
    ("polygons", "words"),
    [
        ([[[[0, 0], [9, 0], [9, 9], [3, -1]]]], "not simple.*cross"),
        ([[[[0, 0], [9, 0], [9, 9], [4, 0], [0, 9]]]], "not simple.*touch"),
        ([[[[0, 0], [9, 0], [9, 9], [9, 4], [0, 4]]]], "not simple"),
        ([[[[0, 0], [9, 0], [12, 0], [9, 0], [9, 9]]]], "not simple"),
        ([[SQUARE, [[1, 0], [1, 1], [2, 0]]]], "overlap along"),
        ([[SQUARE, [[1, -1], [1, 1], [2, 1]]]], "cross"),
        # Passes through a hole's vertices, not through its edges.
        ([[SQUARE, [[4, 4], [4, 6], [6, 6], [6, 4]], [[2, 2], [4, 4], [6, 6], [8, 5]]]], "cross"),
        ([[SQUARE, [[10, 0], [10, 1], [11, 0]]]], "outside of its outer"),
        ([[SQUARE, [[9, 4], [10, 5], [10, 4]]]], "outside of its outer"),
        ([[SQUARE, [[1, 1], [1, 8], [8, 8], [8, 1]], [[1, 1], [2, 3], [3, 2]]]], "another hole"),
        ([[SQUARE], [[[1, 1], [2, 1], [1, 2]]]], "polygons overlap"),
        ([[SQUARE], [SQUARE]], "overlap along"),
    ],
)
def test_invalid_sets(polygons: list[list[object]], words: str) -> None:
    text = polygon_set(*polygons)
    assert refusal(text)
    with pytest.raises(InputError, match=words):
        refuse_invalid(operand_from_json(json.loads(text), as_given=True).polygons)


TRIANGLE: Ring = [(0, 0), (8, 0), (4, 8)]


def as_lists(ring: Ring) -> list[list[str]]:
    return [[str(x), str(y)] for x, y in ring]


def touching_everywhere() -> tuple[str, str]:
    """A hole inside its outer ring, and two polygons, one inside the other. They touch at all
    vertices and edge midpoints of the inner ring: none of these points tells where the inner ring
    lies."""
    outer, inner = as_lists(toothed(TRIANGLE, 1)), as_lists(TRIANGLE)
    return polygon_set([outer, inner[::-1]]), polygon_set([outer], [inner])


def test_rings_that_touch_at_all_vertices_and_middles_of_edges() -> None:
    holed, overlapping = touching_everywhere()
    assert slow_refusal(holed) == ""
    assert "polygons overlap" in slow_refusal(overlapping)


def test_the_reference_on_rings_that_touch_at_all_vertices_and_middles_of_edges() -> None:
    assert [refusal(text) for text in touching_everywhere()] == ["", "overlapping-polygons"]
