"""Brackets of the scales at which a part that keeps a distance fits, passes or is trapped. Laws:
both ends are decided, a rational end is met, and less distance takes nothing away."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from fractions import Fraction

import minkref
import pytest
from minkref.fuzz.judges.motion.clear_brackets import bracket_case, bracket_faults
from minkref.motion.scale_bracket import BracketSearch, Room, simplest

SEED = 2608
SQUARE = minkref.PolygonSet([(-1, -1), (1, -1), (1, 1), (-1, 1)])
DIAMOND = minkref.PolygonSet([(-1, 0), (0, -1), (1, 0), (0, 1)])
HALL = minkref.PolygonSet([(0, 0), (20, 0), (20, 9), (0, 9)])
#: Two rooms and a door of width 3 between x = 8 and 12.
ROOMS = minkref.PolygonSet(
    [(0, 0), (8, 0), (8, 3), (12, 3), (12, 0), (20, 0), (20, 9), (12, 9), (12, 6), (8, 6), (8, 9),
     (0, 9)]
)  # fmt: skip
#: Two walls with a gap of width 3 on the right, around a room.
CAGE = minkref.PolygonSet(
    [(-1, -1), (10, -1), (10, 3), (9, 3), (9, 0), (0, 0), (0, 9), (9, 9), (9, 6), (10, 6),
     (10, 10), (-1, 10)]
)  # fmt: skip
WAY = ((4, "9/2"), (16, "9/2"))


@pytest.mark.parametrize("contact", ["allowed", "forbidden"])
def test_a_box_in_a_box_has_its_exact_end(contact: str) -> None:
    for clearance in ("1", "1/2", "7/3"):
        found = minkref.clear_fits(SQUARE, HALL, clearance, contact=contact)
        end = (9 - 2 * Fraction(clearance)) / 2
        assert found.is_exact and found.holds_to == found.fails_from == end
        assert found.end_in == (contact == "allowed")


def test_a_door_lets_through_what_leaves_the_distance_on_both_sides() -> None:
    found = minkref.clear_fits(SQUARE, ROOMS, "1/7", between=WAY)
    assert found.is_exact and found.holds_to == (3 - Fraction(2, 7)) / 2
    assert found.cause == "neck"


def test_an_irrational_end_lies_between_the_scales() -> None:
    # What is left of a triangle at a scale is a triangle of the same shape: 1 - s of its inradius.
    triangle = minkref.PolygonSet([(0, 0), (4, 0), (0, 4)])
    inradius = 4 - 2 * 2**0.5
    end = (inradius - 0.5) / inradius
    for tolerance in ("1/1000000000", "1/10"):
        found = minkref.clear_fits(triangle, triangle, "1/2", tolerance=tolerance)
        assert found.fails_from is not None and not found.is_exact
        assert float(found.holds_to) - 1e-12 <= end <= float(found.fails_from) + 1e-12
        assert found.fails_from - found.holds_to <= found.fails_from * Fraction(tolerance)


def test_a_cage_holds_what_the_gap_does_not_let_through() -> None:
    found = minkref.clear_trap(SQUARE, CAGE, (4, 4), "1/4")
    assert found.escapes is not None and found.escapes.is_exact and found.escapes.end_in
    assert found.escapes.holds_to == Fraction(5, 4)
    assert [str(one) for one in found.free.ranges] == ["(0, 15/4]"]
    assert not found.is_empty
    shut = minkref.clear_trap(SQUARE, CAGE, (4, 4), "3/2")
    assert shut.escapes is not None and shut.escapes.is_empty and not shut.is_empty
    away = minkref.clear_trap(SQUARE, CAGE, (30, 4), "1/4")
    assert away.is_empty and minkref.clear_trap(SQUARE, CAGE, (0, 4), "1/4").escapes is None
    nothing = minkref.clear_trap(SQUARE, minkref.PolygonSet(), (4, 4), "1/4")
    assert nothing.is_empty and nothing.escapes is None
    late = minkref.clear_trap(SQUARE, CAGE, (4, 4), "1/4", from_scale=2, to_scale=3)
    assert late.escapes is not None and late.escapes.fails_from == 2 and not late.is_empty


def test_no_room_means_no_scale_and_is_exact() -> None:
    for clearance in ("9/2", "5"):
        assert minkref.clear_fits(SQUARE, HALL, clearance).is_empty
    assert minkref.clear_fits(SQUARE, ROOMS, "3/2", between=WAY).is_empty
    assert not minkref.clear_fits(SQUARE, ROOMS, "149/100", between=WAY).is_empty


def test_a_segment_along_a_corridor_keeps_the_same_distance_at_all_scales() -> None:
    # Not star-shaped in the strict sense: the distance does not shrink, and equality is no end.
    rod = minkref.read_text("LINESTRING (-1 0, 1 0)", "wkt")
    corridor = minkref.PolygonSet([(0, 0), (20, 0), (20, 2), (0, 2)])
    found = minkref.clear_fits(rod, corridor, 1)
    assert found.is_exact and found.end_in and found.holds_to == found.fails_from == 9
    assert minkref.clear_fits(rod, corridor, 1, contact="forbidden").is_empty


def test_less_distance_takes_nothing_away_and_none_is_the_limit() -> None:
    part, last = DIAMOND, Fraction(0)
    whole = minkref.largest_fit(part, ROOMS, between=WAY).largest
    assert whole is not None
    for clearance in ("1/2", "1/8", "1/64", "1/4096"):
        found = minkref.clear_fits(part, ROOMS, clearance, between=WAY)
        assert found.fails_from is not None and last < found.holds_to <= whole
        # The diamond holds a disc of radius 1/2 about its origin: 2 C more scale reaches C farther.
        assert found.fails_from + 2 * Fraction(clearance) >= whole
        last = found.holds_to
    assert whole - last < Fraction(1, 1000)


def test_no_straight_way_beats_the_best_way() -> None:
    outside = minkref.subtract(
        minkref.PolygonSet([(-9, -9), (29, -9), (29, 18), (-9, 18)]), [ROOMS]
    )
    best = minkref.clear_fits(DIAMOND, ROOMS, "1/3", between=[(4, 5), (16, 4)])
    one = minkref.clear_scales(DIAMOND, outside, [(4, 5), (16, 4)], "1/3")
    assert best.fails_from is not None and one.ranges[0].high is not None
    assert one.ranges[0].high.bounds[0] < float(best.fails_from)


def test_brackets_before_a_judge_of_all_pairs() -> None:
    print("seed", SEED)
    tally: Counter[str] = Counter()
    faults = [fault for k in range(5) for fault in bracket_faults(bracket_case(SEED, k), tally)]
    assert faults == [] and tally["grids"] > 4 and tally["traps"] > 0


def test_parts_whose_smaller_copies_may_need_more_room_are_refused() -> None:
    hook = minkref.PolygonSet([(0, 0), (4, 0), (4, 4), (3, 4), (3, 1), (1, 1), (1, 4), (0, 4)])
    with pytest.raises(minkref.Refusal, match="no point of the part"):
        minkref.clear_fits(hook, HALL, 1)
    aside = SQUARE.translated("5", "0")
    assert minkref.clear_fits(aside, HALL, 1).holds_to == Fraction(7, 2)
    for ask in (
        lambda: minkref.clear_fits(aside, ROOMS, 1, between=WAY),
        lambda: minkref.clear_trap(aside, CAGE, (4, 4), 1),
    ):
        with pytest.raises(minkref.Refusal, match="not star-shaped about its origin") as refused:
            ask()
        assert "(5, 0)" in refused.value.mend
    with pytest.raises(minkref.Refusal, match="no extent"):
        minkref.clear_fits(minkref.read_text("POINT (0 0)", "wkt"), HALL, 1)


def _linear(end: Fraction) -> Callable[[Fraction], Room]:
    def room(scale: Fraction) -> Room:
        far = 2 - scale / end
        return Room((far > 1) - (far < 1), float(far), "room")

    return room


def test_a_search_asks_few_scales_and_ends_as_narrow_as_asked() -> None:
    for end in (Fraction(1, 3), Fraction(355, 113), Fraction(10**15 + 1, 10**15)):
        for tolerance in (Fraction(1, 100), Fraction(1, 10**9), Fraction(1, 10**30)):
            search = BracketSearch(_linear(end), Fraction(1), True, False, tolerance)
            found = search.between(Fraction(0), Fraction(5))
            assert found.fails_from is not None
            assert found.holds_to <= end < found.fails_from
            assert found.fails_from - found.holds_to <= tolerance * found.fails_from
            if tolerance > Fraction(1, 10**15):  # doubles no longer choose the scales below
                assert found.decisions < 20


def test_the_simplest_fraction_of_an_interval() -> None:
    for low, high, found in (
        ("1/3", "1/2", "1/2"),
        ("0.3", "0.34", "1/3"),
        ("3.14", "3.15", "22/7"),
        ("2", "2", "2"),
        ("7/3", "5/2", "5/2"),
    ):
        assert simplest(Fraction(low), Fraction(high)) == Fraction(found)
