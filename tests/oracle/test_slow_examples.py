"""Hand-made sums with their derivations, held against the slow engine."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from minkref.oracle.slow import Operand, minkowski_sum, operand_from_json, topology
from minkref.oracle.slow.cover import Cover
from minkref.oracle.slow.frame import frame_of
from minkref.oracle.slow.germ import side_of
from minkref.oracle.slow.outline import outline


def polygons(*parts: tuple[Any, ...]) -> Operand:
    """Each part: outer ring, then holes."""
    return operand_from_json({"polygons": [{"outer": p[0], "holes": list(p[1:])} for p in parts]})


def box(x0: int, y0: int, x1: int, y1: int) -> list[list[int]]:
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


UNIT = polygons((box(0, 0, 1, 1),))


def points(*pairs: tuple[int, int]) -> list[tuple[Fraction, Fraction]]:
    return [(Fraction(x), Fraction(y)) for x, y in pairs]


def test_digest_of_the_unit_square_is_that_of_the_definitions() -> None:
    origin = Operand([], points((0, 0)))
    assert minkowski_sum(UNIT, origin).digest == (
        "3c64a3cbd9e9a139f48c6a763f8baefec8849c20d8267e53306bcdf4da5f31bc"
    )


def test_square_plus_diamond_is_an_octagon_of_area_seven() -> None:
    """Area 1 + 2 plus the mixed area, which is 4 for a unit square and a diamond 2 wide."""
    diamond = polygons(([[1, 0], [0, 1], [-1, 0], [0, -1]],))
    found = minkowski_sum(UNIT, diamond)
    assert (found.area, found.components, found.holes) == (7, 1, 0)
    assert len(found.polygons[0].outer) == 8


def test_triangles_in_every_other_wedge_of_three_lines_are_three_components() -> None:
    """The boundary goes straight on through their common corner, along each of the lines."""
    wedges = ([[0, 0], [2, 0], [2, 2]], [[0, 0], [-2, 2], [-2, 0]], [[0, 0], [-2, -2], [2, -2]])
    origin = Operand([], points((0, 0)))
    found = minkowski_sum(polygons(*((wedge,) for wedge in wedges)), origin)
    assert (found.components, found.holes, found.area) == (3, 0, 8)
    assert [len(polygon.outer) for polygon in found.polygons] == [3, 3, 3]


def test_square_that_fits_a_square_hole_leaves_one_point() -> None:
    frame = polygons((box(0, 0, 4, 4), box(1, 1, 2, 2)))
    assert minkowski_sum(frame, UNIT).tight == [points((2, 2))]
    # A slightly smaller scale leaves nothing tight, a slightly larger one a hole.
    assert minkowski_sum(frame, UNIT, Fraction(101, 100)).holes == 1
    assert minkowski_sum(frame, UNIT, Fraction(99, 100)).tight == []


def test_square_in_a_corridor_of_width_one_leaves_a_segment() -> None:
    frame = polygons((box(0, 0, 6, 4), box(1, 1, 4, 2)))
    assert minkowski_sum(frame, UNIT).tight == [points((2, 2), (4, 2))]


def test_corridor_with_a_bend_leaves_a_bent_polyline() -> None:
    """The corridor runs from (1,1) right to (5,2) and up to (5,5); the square slides along (2,2)
    (5,2) (5,5), the positions of its upper right corner."""
    bend = [[1, 1], [5, 1], [5, 5], [4, 5], [4, 2], [1, 2]]
    frame = polygons((box(0, 0, 6, 6), bend))
    assert minkowski_sum(frame, UNIT).tight == [points((2, 2), (5, 2), (5, 5))]


def test_crossing_corridors_leave_four_polylines() -> None:
    cross = [[1, 3], [3, 3], [3, 1], [4, 1], [4, 3], [6, 3], [6, 4]]
    cross += [[4, 4], [4, 6], [3, 6], [3, 4], [1, 4]]
    frame = polygons((box(0, 0, 7, 7), cross))
    assert minkowski_sum(frame, UNIT).tight == [
        points((2, 4), (4, 4)),
        points((4, 2), (4, 4)),
        points((4, 4), (4, 6)),
        points((4, 4), (6, 4)),
    ]


def test_corridor_around_an_island_leaves_a_closed_polyline() -> None:
    frame = polygons((box(0, 0, 6, 6), box(1, 1, 5, 5)), (box(2, 2, 4, 4),))
    assert minkowski_sum(frame, UNIT).tight == [points((2, 2), (2, 5), (5, 5), (5, 2), (2, 2))]


def test_segment_slides_along_a_slot_of_its_length() -> None:
    """A hole 1 high and 3 wide, and a vertical segment of length 1."""
    frame = polygons((box(0, 0, 6, 4), box(1, 1, 4, 2)))
    assert minkowski_sum(frame, Operand([], points((0, 0), (0, 1)))).tight == [
        points((1, 2), (4, 2))
    ]


def test_segment_along_an_inner_diagonal_is_in_the_sum_of_the_interiors() -> None:
    """The segment from (0,-5/3) to (0,1/3) ends at the hole's upper side, begins at no boundary,
    and runs through the material along the line from (0,-2) to (0,-2/3)."""
    third = Fraction(1, 3)
    hole = [(Fraction(0), -2 * third), (2 * third, third), (-2 * third, third)]
    star = polygons((points((0, -2), (2, 1), (-2, 1)), hole))
    segment = Operand([], points((-2, -2), (-2, -1)))
    assert minkowski_sum(segment, star, Fraction(2)).tight == []


def test_diamond_hole_that_touches_two_sides_parts_the_set() -> None:
    hole = [[0, 1], [1, 0], [2, 1], [1, 2]]
    tall = polygons((box(-1, 0, 3, 2), hole))
    found = minkowski_sum(tall, Operand([], points((0, 0))))
    assert (found.components, found.holes, len(found.polygons)) == (2, 1, 2)
    assert all(not part.holes for part in found.polygons)


def test_hole_pinched_at_a_point_is_two_holes_in_one_walk() -> None:
    """Two diamonds that touch at (3,2), inside a frame: the ring through the point is split."""
    left, right = [[1, 2], [2, 1], [3, 2], [2, 3]], [[3, 2], [4, 1], [5, 2], [4, 3]]
    frame = polygons((box(0, 0, 6, 4), left, right))
    found = minkowski_sum(frame, Operand([], points((0, 0))))
    assert (found.components, found.holes) == (1, 2)
    assert [len(hole) for hole in found.polygons[0].holes] == [4, 4]


def test_hole_dies_at_a_triple_event() -> None:
    """The example of docs/definitions.md, "Critical scales"."""
    P = polygons(([[-3, -2], [4, -1], [1, 3]],))
    Q = polygons((box(-40, -40, 40, 40), [[0, 20], [17, -11], [-19, -9]]))
    found = topology(P, Q, Fraction(541, 186))
    assert [len(state.complement) for state in (found.below, found.at, found.above)] == [1, 0, 0]
    assert sorted(link.change for link in found.holes) == ["death", "same"]
    assert len(found.result.tight) == 1 and len(found.result.tight[0]) == 1


def test_frames_that_touch_merge_their_components() -> None:
    """Two unit squares, one apart; a square of side s closes the gap at s = 1."""
    P = polygons((box(0, 0, 1, 1),))
    Q = polygons((box(0, 0, 1, 1),), (box(2, 0, 3, 1),))
    found = topology(P, Q)
    assert [link.change for link in found.components] == ["merge"]
    assert (len(found.below.interior), len(found.at.interior)) == (2, 1)
    assert found.result.tight == [points((2, 0), (2, 2))]


@pytest.mark.parametrize("s", [Fraction(1, 2), Fraction(1), Fraction(2)])
def test_sum_that_closes_a_bay_splits_the_outside(s: Fraction) -> None:
    """A room 2 x 2 behind a gate of width 1; a square of side 1 closes the gate, of side 2 the
    room."""
    room = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 2.5], [1, 2.5], [1, 3], [3, 3], [3, 1], [1, 1]]
    room += [[1, 1.5], [0, 1.5]]
    Q = polygons(([[str(x), str(y)] for x, y in room],))
    found = topology(UNIT, Q, s)
    changes = {link.change for link in found.holes}
    assert changes == {Fraction(1, 2): {"same"}, Fraction(1): {"split"}}.get(s, {"same", "death"})


def test_edges_of_inner_diagonals_may_be_left_out() -> None:
    """The same outline with all edges of all convex sums as candidates."""
    from random_pairs import pair

    for index in range(40):
        P, Q = (source.operand() for source in pair(31, index))
        if P.ends and Q.ends:
            continue
        frame = frame_of(P, Q)
        side = side_of(Fraction(1 + index % 3), 0, frame.P.unit, 0, False)
        few, all_of_them = outline(Cover(frame, side)), outline(Cover(frame, side, True))
        for one, other in ((few.edges, all_of_them.edges), (few.slits, all_of_them.slits)):
            assert {(e.start, e.end) for e in one} == {(e.start, e.end) for e in other}, index
        assert few.points == all_of_them.points, index
