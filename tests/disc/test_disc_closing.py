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


def boxes(*corners: tuple[int, int, int, int]) -> PolygonSet:
    return PolygonSet([[[(a, b), (c, b), (c, d), (a, d)]] for a, b, c, d in corners])


def test_a_disc_that_just_fits_is_covered_by_a_closing() -> None:
    """In a hole, between walls, in a passage shorter than the disc; the larger limit counts."""
    frame = PolygonSet([[(0, 0), (9, 0), (9, 9), (0, 9)], [(3, 3), (3, 5), (5, 5), (5, 3)]])
    found = close(frame, 1)
    assert (found.area, found.components, found.holes) == ((81.0, 81.0), 1, 0)
    found = close(boxes((0, 0, 4, 9), (6, 0, 10, 9)), 1)
    assert encloses(found.area, 90 - math.pi)
    assert (found.components, found.holes, len(found.rings), len(found.arcs)) == (1, 0, 1, 2)
    found = close(boxes((0, 0, 4, 1), (6, 0, 10, 1)), 1)
    assert encloses(found.area, 10 - math.sqrt(3) / 2 - math.pi / 3)
    assert (found.components, found.holes, len(found.arcs)) == (2, 0, 4)
    slit = PolygonSet([[(0, 0), (9, 0), (9, 4), (0, 4)], [(1, 1), (1, 3), (8, 3), (8, 1)]])
    found = close(slit, 1)
    assert (found.area, found.components, found.holes) == ((36.0, 36.0), 1, 0)


def test_closings_where_the_disc_just_fits_are_limits_from_larger_radii() -> None:
    """Parts that touch at a point hang together at larger radii. Prints the case."""
    tried = 0
    for number in range(2, 3 * draws(15, 200), 3):
        P, _, _ = inset_case(SEED + 2, number)
        P = _core.Outside(P).set if number % 2 else P
        rows = _core.disc_index(P)
        for row in rows.rows(0, len(rows.kinds())):
            if row[0] not in ("maximum", "ridge") or row[1] is None:
                continue
            square = row[1]
            if not _core.offset(P, square).tight_passages():
                continue
            tried += 1
            at = closed_by_disc(P, square, "P", 1)
            above = closed_by_disc(P, str(Fraction(square) * (1 + Fraction(1, 10**12))), "P", 1)
            assert at.components >= above.components, (number, square)
            assert at.area[0] == pytest.approx(above.area[0], rel=1e-4), (number, square)
            faults = faults_of(P, square, "closing", at)
            assert not faults, (number, square, faults)
            break
    assert tried > 5


def test_rest_that_falls_apart_beside_an_island() -> None:
    """A chamber around an island opens into a short passage, whose rest is in two parts."""
    tower = [
        ("-1/2", 2),
        ("-1/10", 2),
        ("-1/10", 5),
        (-2, 5),
        (-2, 9),
        (2, 9),
        (2, 5),
        ("1/10", 5),
        ("1/10", 2),
        ("1/2", 2),
        ("1/2", 4),
        (3, 4),
        (3, 10),
        (-3, 10),
        (-3, 4),
        ("-1/2", 4),
    ]
    half = Fraction(1, 2)
    island = [(-3 * half, 11 * half), (3 * half, 11 * half), (3 * half, 17 * half),
              (-3 * half, 17 * half)]  # fmt: skip
    below = [(-half, -5), (half, -5), (half, 0), (-half, 0)]
    P = PolygonSet([[tower], [island], [below]])
    found = close(P, Fraction(21, 20))
    assert (found.components, found.holes) == (2, 0)
    assert not faults_of(P, "441/400", "closing", found)


def test_points_are_not_closed() -> None:
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


def test_ridges_in_front_of_collinear_edges_are_cut() -> None:
    """Two triangles with tops on a line, two radii below a wall; they touch at a point."""
    P = PolygonSet([
        [[(-28, -18), (28, -18), (28, 22), (-28, 22)], [(-20, 5), (20, 5), (20, -4), (-20, -4)]],
        [[(-1, 4), (-3, 4), (0, 0)]],
        [[(3, 4), (1, 4), (0, 0)]],
    ])  # fmt: skip
    found = close(P, Fraction(1, 2))
    assert (found.components, found.holes) == (1, 2)
    assert not faults_of(P, "1/4", "closing", found)
