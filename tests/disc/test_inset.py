"""Erosions by a disc: exact distances, known answers, and rings that touch."""

from __future__ import annotations

import json
from fractions import Fraction

import minkref
import pytest
from minkref import PolygonSet, _core
from minkref.fuzz.judges.disc.inset_remnants import remnant_faults
from minkref.fuzz.judges.disc.insets import inset_case, inset_faults
from thoroughness import draws

SEED = 3321


@pytest.mark.parametrize("index", range(draws(45, 300)))
def test_insets_keep_their_distance(index: int) -> None:
    """Corners, polygon sets inside and around, random points; prints seed, index and radius."""
    compared, faults = inset_faults(SEED, index)
    assert compared and not faults, faults[:3]


def test_a_square_leaves_a_square_and_its_middle() -> None:
    square = PolygonSet([(0, 0), (4, 0), (4, 4), (0, 4)])
    left = minkref.inset(square, 1)
    assert (left.components, left.area, left.length) == (1, (4.0, 4.0), (8.0, 8.0))
    form = json.loads(left.canonical_json())
    assert form["inward"] is True
    assert [curve[0] for curve in form["components"][0]["outer"]] == ["line"] * 4
    last = minkref.inset(square, 2)
    assert (last.components, last.area) == (0, (0.0, 0.0))
    assert [points for points, *_ in last.tight_passages()] == [[("2", "2")]]
    assert minkref.inset(square, "2.001").tight_passages() == []
    assert [(event.kind, event.radius) for event in minkref.inradius(square)] == [
        ("maximum", (2.0, 2.0))
    ]


def test_parts_that_touch_are_parts_of_their_own() -> None:
    """A door as wide as the disc at one point only: both rooms have rings of their own, which meet
    there."""
    half = [(9, 0), (10, 4), (11, 0), (20, 0), (20, 9), (11, 9), (10, 6), (9, 9)]
    rooms = PolygonSet([(0, 0), *half, (0, 9)])
    left = minkref.inset(rooms, 1)
    assert (left.components, left.holes) == (2, 0)
    assert minkref.inset(rooms, "999/1000").components == 1
    assert minkref.inset(rooms, "1001/1000").components == 2


def test_an_island_between_two_parts_is_a_hole() -> None:
    """Where the disc just passes at two points, both parts meet there, around the island."""
    wall = [(0, 0), (12, 0), (12, 12), (0, 12)]
    hole = [(6, 2), (8, 6), (6, 10), (4, 6)]
    room = PolygonSet([[wall, hole]])
    for radius, components, holes in ((Fraction(9, 10), 1, 1), (1, 2, 1), (Fraction(11, 10), 2, 0)):
        left = minkref.inset(room, radius)
        assert (left.components, left.holes) == (components, holes), radius
        assert left == minkref.inset(room, radius, route="paper")


def test_nothing_is_left_of_a_segment() -> None:
    left = minkref.inset(PolygonSet("LINESTRING(0 0,3 1)"), 1)
    assert (left.components, left.holes, left.curves) == (0, 0, 0)
    assert left.tight_passages() == []


def test_the_judge_refuses_lost_invented_and_changed_remnants() -> None:
    """Prints the case."""
    tried = 0
    for index in range(2, 3 * draws(20, 100), 3):
        P, square, around = inset_case(SEED, index)
        truth = [spots for _, spots, _ in _core.inset(P, square).tight_passages()]
        assert not list(remnant_faults(P, Fraction(square), around, truth)), index
        for mutant in mutants(truth):
            tried += 1
            assert list(remnant_faults(P, Fraction(square), around, mutant)), (index, mutant)
    assert tried > 20


def mutants(truth: list[list[tuple[float, float]]]) -> list[list[list[tuple[float, float]]]]:
    found = [[*truth, [(99.0, 99.0)]]]
    for k, one in enumerate(truth):
        before, after = truth[:k], truth[k + 1 :]
        (ax, ay), (bx, by) = one[0], one[-1]
        moved = [(x + 1e-3, y + 1e-3) for x, y in one]
        found += [[*before, *after], [*before, moved, *after]]
        if len(one) > 1:
            middle, beyond = ((ax + bx) / 2, (ay + by) / 2), (2 * bx - ax, 2 * by - ay)
            found += [[*before, [one[0], end], *after] for end in (middle, beyond)]
    return found
