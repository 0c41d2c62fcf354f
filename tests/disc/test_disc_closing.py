"""Closings and openings by a disc: cases by hand, sampled areas, and polygons around them."""

from __future__ import annotations

import math
import random
from dataclasses import replace
from fractions import Fraction

import pytest
from minkref import PolygonSet, _core
from minkref.disc.closed import DiscClosing, closed_by_disc, opened_by_disc
from minkref.errors import Refusal
from minkref.fuzz.features.place_draws import drawn_set, set_of
from minkref.fuzz.judges.disc.closings import closing_faults, faults_of
from minkref.fuzz.judges.disc.insets import inset_case
from thoroughness import draws

from tests.disc.sampled_closing import added_area

SEED = 6124
SLOT = PolygonSet([(0, 0), (9, 0), (9, 6), (5, 6), (5, 2), (4, 2), (4, 6), (0, 6)])


def close(P: PolygonSet, radius: Fraction | int) -> DiscClosing:
    return closed_by_disc(P, str(Fraction(radius) ** 2), "P", 1)


def open_(P: PolygonSet, radius: Fraction | int) -> DiscClosing:
    return opened_by_disc(P, str(Fraction(radius) ** 2), "P", 1)


def encloses(bounds: tuple[float, float], value: float) -> bool:
    return bounds[0] - 1e-12 <= value <= bounds[1] + 1e-12


def test_a_slot_is_filled_but_for_a_cap() -> None:
    found = close(SLOT, 1)
    angle = 2 * math.asin(1 / 2)
    assert encloses(found.area, 54 - (angle - math.sin(angle)) / 2)
    assert (found.components, found.holes, len(found.rings), len(found.arcs)) == (1, 0, 1, 1)


def test_corners_of_a_square_are_rounded() -> None:
    square = PolygonSet([(0, 0), (4, 0), (4, 4), (0, 4)])
    found = open_(square, 1)
    assert encloses(found.area, 12 + math.pi)
    assert (found.components, found.holes, len(found.arcs)) == (1, 0, 4)
    assert {centre for centre, *_ in found.arcs} == {
        ("1", "1"), ("3", "1"), ("1", "3"), ("3", "3"),
    }  # fmt: skip
    assert close(square, 1).area == (16.0, 16.0)
    assert open_(square, 3).components == 0
    whole = open_(square, 2)
    assert encloses(whole.area, 4 * math.pi) and whole.digest is None


def test_openings_fall_apart_and_closings_grow_together() -> None:
    """A dumb-bell loses its bar, two blocks get one."""
    bell = PolygonSet(
        [(0, 0), (6, 0), (6, 2), (10, 2), (10, 0), (16, 0), (16, 6), (10, 6), (10, 4), (6, 4),
         (6, 6), (0, 6)]
    )  # fmt: skip
    assert [open_(bell, Fraction(r)).components for r in ("1/2", "3/2", "4")] == [1, 2, 0]
    blocks = PolygonSet([[[(0, 0), (4, 0), (4, 9), (0, 9)]], [[(5, 0), (9, 0), (9, 9), (5, 9)]]])
    assert [close(blocks, Fraction(r)).components for r in ("1/4", "2")] == [2, 1]
    frame = PolygonSet([[(0, 0), (9, 0), (9, 9), (0, 9)], [(3, 3), (3, 5), (5, 5), (5, 3)]])
    assert [close(frame, Fraction(r)).holes for r in ("1/2", "3/2")] == [1, 0]
    assert [open_(frame, Fraction(r)).holes for r in ("1/2", "3/2")] == [1, 1]


def test_a_disc_that_just_fits_is_refused_for_a_closing_and_counts_for_an_opening() -> None:
    frame = PolygonSet([[(0, 0), (9, 0), (9, 9), (0, 9)], [(3, 3), (3, 5), (5, 5), (5, 3)]])
    with pytest.raises(Refusal) as refused:
        close(frame, 1)
    assert refused.value.code == "disc-fits"
    with pytest.raises(Refusal) as refused:
        open_(PolygonSet("POINT (0 0)"), 1)
    assert refused.value.code == "degenerate-operands"


def test_areas_lie_within_sampled_ones() -> None:
    """Prints the shape and the radius."""
    dice = random.Random(SEED)
    for number in range(draws(5, 80)):
        _, shape = drawn_set(SEED, number)
        P = set_of(shape)
        radius = Fraction(dice.randint(2, 40), 7)
        try:
            found = close(P, radius)
        except Refusal:
            continue
        own = float(Fraction(P.area()))
        low, high = added_area(shape, float(radius), 150)
        assert low - 1e-9 <= found.area[1] - own, (shape, radius)
        assert found.area[0] - own <= high + 1e-9, (shape, radius)


def test_polygons_lie_inside_and_around() -> None:
    """Sums and erosions with polygons know nothing of the diagram. Prints the case."""
    for number in range(draws(12, 120)):
        compared, faults = closing_faults(SEED, number)
        assert compared and not faults, faults


def test_the_judge_refuses_a_lost_ring_an_invented_one_and_a_moved_one() -> None:
    """Prints the case."""
    tried = 0
    for number in range(draws(4, 40)):
        P, square, _ = inset_case(SEED, number)
        found = opened_by_disc(P, square, "P", 1)
        away = math.sqrt(Fraction(square)) / 2
        for k, ring in enumerate(found.rings):
            moved = [(s[0], *(x + away for x in s[1:])) for s in ring]
            for rings in ([moved], [ring, moved], []):
                mutant = replace(found, rings=[*found.rings[:k], *rings, *found.rings[k + 1 :]])
                tried += 1
                assert faults_of(P, square, "opening", mutant), (number, k)
    assert tried > 6


def test_an_opening_is_what_a_closing_of_the_outside_leaves() -> None:
    """Openings and closings again change nothing: their canonical forms stay."""
    dice = random.Random(SEED + 1)
    for number in range(draws(5, 60)):
        P = set_of(drawn_set(SEED, number)[1])
        radius = Fraction(dice.randint(2, 30), 11)
        opened = open_(P, radius)
        outside = _core.closed_by_disc(_core.Outside(P).set, str(radius**2), False)
        if _core.inset(P, str(radius**2), 1).tight_passages(1):
            continue
        assert (opened.components, opened.holes) == (outside.holes, outside.components - 1)
        frame = float(Fraction(_core.Outside(P).set.area())) + float(Fraction(P.area()))
        assert opened.area[0] == pytest.approx(frame - outside.area()[0], rel=1e-12)
        assert opened.area[1] <= float(Fraction(P.area())) + 1e-9
