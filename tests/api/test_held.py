"""Held scales: laws, decisions at single scales, and values by hand."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from typing import Any

import minkref
import pytest
from minkref.fuzz.judges.motion.held_cases import KINDS, held_case
from minkref.fuzz.judges.motion.held_scales import (
    scales_beside,
    wrong_ends,
    wrong_scales,
    wrong_stops,
)
from minkref.fuzz.judges.motion.space_path_cases import SpacePathCase, space_path_case
from minkref.fuzz.judges.motion.space_path_collisions import StaticSum
from minkref.fuzz.motion.path_collisions import Collisions, by_triangles
from minkref.fuzz.plane.exact_shapes import set_of, shape_of
from minkref.fuzz.space.exact_sum import core_polyhedron

SEED = 8181
CONTACTS = ("allowed", "forbidden")
SQUARE = minkref.PolygonSet([(-1, -1), (1, -1), (1, 1), (-1, 1)])
#: [0, 8] x [0, 8] with a door of width 2 in the right wall.
ROOM = minkref.PolygonSet(
    [(-1, -1), (9, -1), (9, 3), (8, 3), (8, 0), (0, 0), (0, 8), (8, 8), (8, 5), (9, 5), (9, 9),
     (-1, 9)]
)  # fmt: skip
WAY = [(4, 4), (20, 4)]


def texts(found: Any) -> list[str]:
    return [str(one) for one in found.ranges]


@pytest.mark.parametrize(("contact", "held"), [("allowed", "(1, 4]"), ("forbidden", "[1, 4)")])
def test_a_square_is_held_between_door_and_room(contact: str, held: str) -> None:
    """From the door's half-width on, up to the room's."""
    found = minkref.held_scales(SQUARE, ROOM, WAY, contact)
    assert texts(found) == [held]
    [one] = found.held
    assert one.begin is not None and one.end is not None
    assert (one.begin.at_place, one.begin.contact.scale) == (False, Fraction(1))
    assert (one.end.at_place, one.end.contact.scale) == (True, Fraction(4))
    # At 5/2 the square's right side meets the right wall where its origin is at 8 - 5/2.
    assert (one.stop.scale, one.stop.at) == (Fraction(5, 2), (Fraction(11, 2), Fraction(4)))


def test_a_held_part_may_have_another_way() -> None:
    """Through the wall no part gets, and through the door beside that way up to 1 does."""
    blocked = minkref.held_scales(SQUARE, ROOM, [(4, 4), (-20, 4)])
    assert texts(blocked) == ["(0, 4]"]
    assert [str(one) for one in minkref.trapped_scales(SQUARE, ROOM, (4, 4)).ranges] == ["(1, 4]"]


@pytest.mark.parametrize("contact", CONTACTS)
def test_held_scales_are_as_the_definition_decides(contact: str) -> None:
    kinds: Counter[str] = Counter()
    for index in range(2 * len(KINDS)):
        case = held_case(SEED, index)
        found = minkref.held_scales(case.part, case.obstacles, case.way, contact)
        decide = by_triangles(case.part, case.obstacles)

        def collides(way: Any, scale: Fraction, case: Any = case, decide: Any = decide) -> bool:
            return Collisions(case.part, case.obstacles, way).collides(scale, contact, decide)

        told = f"seed {SEED}, case {index} ({case.kind}), {contact}"
        assert not list(wrong_scales(found, case.way, scales_beside(found), collides)), told
        assert not list(wrong_stops(found, case.way, contact, collides)), told
        assert not list(wrong_ends(found)), told
        kinds[case.kind] += bool(found.held)
    assert sum(count > 0 for count in kinds.values()) >= len(KINDS) - 3, kinds


@pytest.mark.parametrize("index", range(len(KINDS)))
@pytest.mark.parametrize("contact", CONTACTS)
def test_held_are_the_scales_that_fit_without_those_of_the_way(index: int, contact: str) -> None:
    """And moving everything, or another route, changes nothing."""
    case = held_case(SEED + 1, index)
    found = minkref.held_scales(case.part, case.obstacles, case.way, contact)
    fits = minkref.valid_scales(case.part, case.obstacles, case.way[:1], contact)
    way = minkref.valid_scales(case.part, case.obstacles, case.way, contact)
    assert (found.fits.ranges, found.way.ranges) == (fits.ranges, way.ranges)
    for scale in scales_beside(found):
        assert (scale in found) == (scale in fits and scale not in way), (SEED, index, scale)
    moved = [(x + 7, y - Fraction(1, 3)) for x, y in case.way]
    there = minkref.held_scales(
        case.part, case.obstacles.translated("7", "-1/3"), moved, contact, route="contacts"
    )
    assert there.ranges == found.ranges, (SEED, index)


@pytest.mark.parametrize("contact", CONTACTS)
def test_a_way_that_stays_holds_nothing(contact: str) -> None:
    for index in range(len(KINDS)):
        case = held_case(SEED + 2, index)
        for way in (case.way[:1], case.way[:1] * 3):
            found = minkref.held_scales(case.part, case.obstacles, way, contact)
            assert found.held == () and found.fits.ranges == found.way.ranges, (SEED, index)


@pytest.mark.parametrize("contact", CONTACTS)
def test_fewer_obstacles_hold_no_part_that_fits_among_more(contact: str) -> None:
    """A larger container holds less, among the scales that fit into the smaller one; it may hold
    larger parts, which did not fit before."""
    for index in range(len(KINDS)):
        case = held_case(SEED + 3, index)
        more = minkref.held_scales(case.part, case.obstacles, case.way, contact)
        x, y = case.way[0]
        away = minkref.PolygonSet([(x + 50, y), (x + 51, y), (x + 50, y + 1)])
        fewer = minkref.held_scales(case.part, away, case.way, contact)
        together = set_of([*shape_of(case.obstacles), *shape_of(away)])
        both = minkref.held_scales(case.part, together, case.way, contact)
        for scale in {*scales_beside(both), *scales_beside(more), *scales_beside(fewer)}:
            for some in (more, fewer):
                assert not (scale in some and scale in both.fits and scale not in both)


def test_a_window_cuts_the_answer() -> None:
    found = minkref.held_scales(SQUARE, ROOM, WAY, "allowed", 2, 3)
    assert texts(found) == ["[2, 3]"]
    assert (found.held[0].begin, found.held[0].end) == (None, None)
    assert texts(minkref.held_scales(SQUARE, ROOM, WAY, "allowed", "1/4", "1/2")) == []


@pytest.mark.parametrize("contact", CONTACTS)
def test_in_space_static_sums_decide_alike(contact: str) -> None:
    held = 0
    for index in range(6):
        case = space_path_case(SEED, index)
        part, obstacles = core_polyhedron(case.part), core_polyhedron(case.obstacles)
        found = minkref.held_scales(part, obstacles, case.path, contact)

        def collides(way: Any, scale: Fraction, case: SpacePathCase = case) -> bool:
            return StaticSum(case, scale, contact).meets(way)

        told = f"seed {SEED}, case {index} ({case.kind})"
        scales = scales_beside(found)[:12]
        assert not list(wrong_scales(found, case.path, scales, collides)), told
        assert not list(wrong_stops(found, case.path, contact, collides)), told
        assert not list(wrong_ends(found)), told
        held += len(found.held)
    assert held > 0
