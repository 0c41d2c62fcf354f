"""How large a disc may be on a path, in a container and among obstacles; parts that keep a
distance. Laws: the radius is the least distance, or a bottleneck of all ways (docs/paths.md)."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction

import minkref
import pytest
from minkref.fuzz.judges.motion.disc_comparison import clearance_faults, disc_faults, fit_faults
from minkref.fuzz.judges.motion.disc_draws import disc_case
from minkref.fuzz.motion.path_cases import path_case

SEED = 8112
ROOMS = "POLYGON((0 0,30 0,30 9,36 9,36 0,70 0,70 30,36 30,36 19,30 19,30 30,0 30,0 0))"
ROOM = "POLYGON((-1 -1,9 -1,9 3,8 3,8 0,0 0,0 8,8 8,8 5,9 5,9 9,-1 9,-1 -1))"


def shape(text: str) -> minkref.PolygonSet:
    return minkref.read_text(text, "wkt")


def test_radii_before_a_judge_of_all_pairs() -> None:
    print("seed", SEED)
    tally: Counter[str] = Counter()
    faults = [fault for index in range(10) for fault in disc_faults(disc_case(SEED, index), tally)]
    assert faults == []
    assert tally["paths"] == 10 and tally["ways"] == 10


def test_clearances_before_a_judge_of_all_pairs() -> None:
    print("seed", SEED)
    tally: Counter[str] = Counter()
    faults = [
        fault
        for index in range(6)
        for fault in clearance_faults(path_case(SEED, index), tally, index)
    ]
    faults += [
        fault for index in range(4) for fault in fit_faults(disc_case(SEED, index), tally, index)
    ]
    assert faults == [] and tally["ends with a root"] > 0 and tally["ends of fits"] > 0


def test_a_slot_of_one_width_is_the_neck_and_is_named_once() -> None:
    found = minkref.largest_disc(shape(ROOMS), between=[(15, 15), (53, 15)])
    assert found.cause == "neck" and found.high is not None
    assert found.high.squared_distance == 25
    [neck] = found.events
    assert ("vertex", "30", "9") in neck.features and ("edge", "0", "2") in neck.features


def test_equal_doors_in_a_row_are_named_in_their_order() -> None:
    boxes = [(0, 0, 6, 6), (5, 2, 9, 4), (8, 0, 14, 6), (13, 2, 17, 4), (16, 0, 22, 6)]
    text = [f"POLYGON(({a} {b},{c} {b},{c} {d},{a} {d},{a} {b}))" for a, b, c, d in boxes]
    row = minkref.unite([shape(each) for each in text])
    found = minkref.largest_disc(row, between=[(3, 3), (19, 3)])
    assert found.high is not None and found.high.squared_distance == 1
    assert [neck.place[0] < 11 for neck in found.events] == [True, False]
    back = minkref.largest_disc(row, between=[(19, 3), (3, 3)])
    assert [neck.place[0] < 11 for neck in back.events] == [False, True]


@pytest.mark.parametrize(("contact", "low_in"), [("allowed", False), ("forbidden", True)])
def test_a_disc_is_trapped_beyond_its_door_and_at_it_if_it_may_not_touch(
    contact: str, low_in: bool
) -> None:
    found = minkref.trapped_radii(shape(ROOM), (4, 4), contact)
    assert found.low is not None and found.high is not None
    assert (found.low.squared_distance, found.high.squared_distance) == (1, 16)
    assert (found.low_in, found.high_in) == (low_in, not low_in)


def test_a_closed_room_traps_all_discs_that_are_free_there() -> None:
    frame = shape("POLYGON((0 0,9 0,9 9,0 9,0 0),(2 2,2 7,7 7,7 2,2 2))")
    found = minkref.trapped_radii(frame, (4, 4))
    assert found.cause == "apart" and found.low is None and not found.is_empty
    assert minkref.trapped_radii(frame, (20, 4)).cause == "free"
    assert minkref.trapped_radii(frame, (2, 4)).cause == "meets"


def test_a_path_that_touches_leaves_no_radius_and_says_where() -> None:
    found = minkref.valid_radii(shape(ROOM), [(20, 20), (20, 9), (9, 9)])
    assert found.is_empty and found.cause == "meets" and found.contact is not None
    assert found.contact.at == found.contact.touching == (9, 9)
    assert minkref.valid_radii(shape(ROOM), [(-1, 0)]).cause == "meets"


def test_a_clearance_is_taken_from_the_radius() -> None:
    found = minkref.valid_radii(shape(ROOM), [(11, 0), (11, 8)], clearance="1/2")
    assert found.high is not None and found.high.bounds == (1.5, 1.5)
    assert minkref.valid_radii(shape(ROOM), [(11, 0)], clearance=2).is_empty
    trapped = minkref.trapped_radii(shape(ROOM), (4, 4), clearance=1)
    assert trapped.low is None and trapped.high is not None and trapped.high.bounds == (3, 3)


def test_a_segment_and_a_point_are_obstacles() -> None:
    wall, pin = shape("LINESTRING(0 0,4 0)"), shape("POINT(0 0)")
    found = minkref.valid_radii(wall, [(-3, 4), (9, 4)])
    assert found.high is not None and found.high.squared_distance == 16
    assert minkref.trapped_radii(wall, (2, 1)).cause == "free"
    assert minkref.trapped_radii(pin, (2, 1)).cause == "free"


def test_a_square_keeps_a_distance_from_a_corner_up_to_a_root() -> None:
    square = shape("POLYGON((-1 -1,1 -1,1 1,-1 1,-1 -1))")
    block = shape("POLYGON((3 3,9 3,9 9,3 9,3 3))")
    found = minkref.clear_scales(square, block, [(0, 0)], 1)
    assert [str(one) for one in found.ranges] == ["(0, 3 - 1/2*sqrt(2)]"]
    [bound] = found.bounds
    assert (bound.part.index, bound.obstacle.index, bound.blocks) == (2, 0, True)
    assert found.holds(Fraction(2292, 1000)) and not found.holds(Fraction(2293, 1000))


def test_a_tip_comes_near_to_the_inside_of_a_side() -> None:
    square = shape("POLYGON((-1 -1,1 -1,1 1,-1 1,-1 -1))")
    tip = shape("POLYGON((3 0,9 -1,9 1,3 0))")
    found = minkref.clear_scales(square, tip, [(0, 0)], 1, "forbidden")
    assert [str(one) for one in found.ranges] == ["(0, 2)"]
    assert found.bounds[0].part.is_edge and not found.bounds[0].obstacle.is_edge


def test_bad_clearances_are_refused() -> None:
    with pytest.raises(minkref.BadInput, match="clearance"):
        minkref.clear_scales(shape(ROOM), shape(ROOMS), [(0, 0)], 0)
    with pytest.raises(minkref.Refusal, match="negative"):
        minkref.valid_radii(shape(ROOM), [(0, 0)], clearance=-1)
