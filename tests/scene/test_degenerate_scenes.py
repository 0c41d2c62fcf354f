"""Degenerate scenes and their answers, worked out by hand from the definitions."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import minkref
import pytest
from minkref import Copy, Scene
from scene_draws import POINT, UNIT, box, frame
from thoroughness import draws

TINY = Fraction(1, 10**30)
HOLE_OF_TWO = minkref.PolygonSet(
    [[(-4, -4), (4, -4), (4, 4), (-4, 4)], [(-1, -1), (1, -1), (1, 1), (-1, 1)]]
)


def points(*pairs: tuple[Any, Any]) -> list[tuple[Fraction, Fraction]]:
    return [(Fraction(x), Fraction(y)) for x, y in pairs]


def passages(scene: Scene) -> list[list[tuple[Fraction, Fraction]]]:
    return [list(one.points) for one in scene.passages()]


def boxes(*places: tuple[Any, Any], robot: minkref.PolygonSet = UNIT) -> Scene:
    """Unit squares at places."""
    return Scene(robot, [UNIT], [Copy(0, 1, place) for place in places], passages=True)


def free(scene: Scene) -> tuple[int, int]:
    """Numbers of free components, with contact forbidden and allowed."""
    return len(scene.free_components("forbidden")), len(scene.free_components("allowed"))


def sides(scene: Scene) -> dict[Any, set[int]]:
    """The copies behind each side of the union, by the side's ends."""
    rings = [ring for polygon in scene.union().rings() for ring in polygon]
    return {
        (ring[i], ring[(i + 1) % len(ring)]): {owner.copy for owner in side}
        for ring, owners in zip(rings, scene.owners(), strict=True)
        for i, side in enumerate(owners)
    }


def test_no_copy_leaves_everything_free() -> None:
    scene = Scene(UNIT, [UNIT], passages=True)
    assert (scene.union(), scene.components, scene.holes) == (minkref.PolygonSet(), 0, 0)
    assert (scene.owners(), scene.passages(), scene.copies) == ([], [], [])
    assert free(scene) == (1, 1)
    again = scene.add(0).remove(0)
    assert again == scene and again.digest == scene.digest


def test_two_equal_copies_are_one_set_with_two_owners() -> None:
    one, two = boxes((0, 0)), boxes((0, 0), (0, 0))
    assert one.digest == two.digest
    assert set(map(frozenset, sides(one).values())) == {frozenset({0})}
    assert set(map(frozenset, sides(two).values())) == {frozenset({0, 1})}
    for copy in (0, 1):
        left = two.remove(copy)
        assert left.digest == two.digest and sides(left) == sides(one)
    assert two.passages() == [] and free(two) == (1, 1)


def test_sums_of_obstacles_that_share_an_edge_overlap_there() -> None:
    scene = boxes((0, 0), (1, 0))
    assert (scene.union(), scene.passages()) == (box(-1, -1, 2, 1), [])
    whole = Scene(UNIT, [box(0, 0, 2, 1)], [Copy(0)])
    assert scene.digest == whole.digest


def test_a_seam_between_obstacles_blocks_a_point() -> None:
    """Obstacles make one regular set; its interior contains the seam."""
    scene = boxes((0, 0), (1, 0), robot=POINT)
    assert (scene.union(), scene.components, scene.passages()) == (box(0, 0, 2, 1), 1, [])
    walls = {"left": box(0, 0, 2, 5), "low": box(0, 0, 5, 2), "top": box(0, 3, 5, 5),
             "right": box(3, 0, 5, 5)}  # fmt: skip
    closed = Scene(POINT, walls, [Copy(wall) for wall in walls], passages=True)
    assert free(closed) == (2, 2)
    apart = {"left": box(0, 0, 2, 5), "right": box(2, 0, 4, 2), "roof": box(2, 3, 4, 5),
             "door": box(4, 0, 5, 5)}  # fmt: skip
    seams = Scene(POINT, apart, [Copy(wall) for wall in apart], passages=True)
    assert (free(seams), seams.passages()) == ((2, 2), [])


def test_a_seam_between_obstacles_blocks_a_segment_that_would_slide_along_it() -> None:
    upright = minkref.PolygonSet("LINESTRING (0 0, 0 1)")
    scene = boxes((0, 0), (1, 0), robot=upright)
    assert (scene.union(), scene.passages()) == (box(0, -1, 2, 1), [])


def test_a_segment_fits_into_a_gap_of_its_length() -> None:
    level = minkref.PolygonSet("LINESTRING (0 0, 1 0)")
    scene = boxes((0, 0), (2, 0), robot=level)
    assert scene.union() == box(-1, 0, 3, 1)
    assert passages(scene) == [points((1, 0), (1, 1))]
    assert passages(scene.change(1, place=(2 + TINY, 0))) == []
    assert passages(scene.change(1, place=(2 - TINY, 0))) == []


def test_a_gap_exactly_as_wide_as_the_robot_is_a_tight_passage() -> None:
    scene = boxes((0, 0), (2, 0))
    assert (scene.union(), scene.components) == (box(-1, -1, 3, 1), 1)
    assert passages(scene) == [points((1, -1), (1, 1))]
    [passage] = scene.passages()
    assert [{owner.copy for owner in side} for side in passage.owners] == [{0, 1}]


def test_a_door_exactly_as_wide_as_the_robot_lets_it_out_if_it_may_touch() -> None:
    walls = {
        "left": box(-5, -5, -3, 5), "low": box(-5, -5, 5, -3), "top": box(-5, 3, 5, 5),
        "below the door": box(3, -5, 5, 0), "above the door": box(3, 1, 5, 5),
    }  # fmt: skip
    scene = Scene(UNIT, walls, [Copy(wall) for wall in walls], passages=True)
    assert passages(scene) == [points((2, 0), (5, 0))]
    assert free(scene) == (2, 1)
    assert free(scene.change(4, place=(0, TINY))) == (1, 1)
    assert free(scene.change(4, place=(0, -TINY))) == (2, 2)


def test_a_passage_of_a_copy_ends_where_another_copy_covers_it() -> None:
    scene = boxes((0, 0), (2, 0)).add(0, "1/2", ("3/2", "1/2"))
    # The sum of the third square is [1/2, 2] x [-1/2, 1].
    assert passages(scene) == [points((1, -1), (1, "-1/2"))]
    assert passages(scene.remove(2)) == [points((1, -1), (1, 1))]
    assert passages(scene.change(2, scale=9, place=(-1, -1))) == []


def test_sums_that_touch_at_a_corner_are_two_components() -> None:
    scene = boxes((0, 0), (2, 2))
    assert (scene.components, scene.holes, scene.union().ring_count) == (2, 0, 2)
    assert (scene.union().area(), scene.passages()) == ("8", [])


def test_four_sums_in_a_ring_that_touch_at_corners_enclose_a_hole() -> None:
    scene = boxes((2, 0), (0, 2), (-2, 0), (0, -2))
    assert (scene.components, scene.holes) == (4, 1)
    assert free(scene) == (2, 1)


def test_a_robot_that_fits_exactly_between_three_copies_has_a_point() -> None:
    robot = minkref.PolygonSet([(0, 0), (1, 0), (0, 1)])
    shapes = {
        "wall": box(-2, -1, 0, 3),
        "floor": box(-1, -2, 3, 0),
        "ramp": minkref.PolygonSet([(2, -1), (3, 3), (-1, 2)]),
    }
    scene = Scene(robot, shapes, [Copy(name) for name in shapes], passages=True)
    assert passages(scene) == [points((0, 0))]
    [passage] = scene.passages()
    assert [{owner.copy for owner in side} for side in passage.owners] == [{0, 1, 2}]
    assert scene.holes == 0 and free(scene) == (1, 2)
    assert scene.free_components("allowed")[1].cells == ()
    assert scene.change(2, place=(TINY, TINY)).holes == 1
    assert passages(scene.change(2, place=(-TINY, -TINY))) == []


def test_a_hole_partly_covered_by_another_copy_has_edges_of_both() -> None:
    shapes = {"frame": frame(4, 2), "bar": box(0, -4, 1, 4)}
    scene = Scene(UNIT, shapes, [Copy("frame"), Copy("bar")], passages=True)
    # The frame's sum has the hole (-2, 1) x (-2, 1), the bar's sum is [-1, 1] x [-5, 4].
    assert scene.holes == 1
    # The robot also fits exactly between the bar and the frame's right wall.
    assert passages(scene) == [points((1, -2), (1, 1))] and free(scene) == (2, 3)
    [[_, hole]] = scene.union().rings()
    assert set(hole) == set(points((-2, -2), (-1, -2), (-1, 1), (-2, 1)))
    owners = {key: copies for key, copies in sides(scene).items() if set(key) <= set(hole)}
    assert sorted(map(sorted, owners.values())) == [[0], [0], [0], [1]]
    upward, downward = points((-1, -2), (-1, 1)), points((-1, 1), (-1, -2))
    assert owners.get(tuple(upward), owners.get(tuple(downward))) == {1}


def test_a_copy_inside_of_the_sum_of_another_owns_nothing() -> None:
    scene = Scene(UNIT, [box(-3, -3, 3, 3), UNIT], [Copy(0), Copy(1, "1/2")])
    assert {owner for side in sides(scene).values() for owner in side} == {0}
    left = scene.remove(1)
    assert left.digest == scene.digest and left.owners() == scene.owners()


def test_a_scale_at_which_something_happens_has_its_exact_boundary() -> None:
    """A hole of side 2 s, for a robot of side 1: at 1/2 it shrinks to a point."""
    for scale, holes, tight in (
        ("1/2", 0, [points((Fraction(-1, 2), Fraction(-1, 2)))]),
        (Fraction(1, 2) + TINY, 1, []),
        (Fraction(1, 2) - TINY, 0, []),
    ):
        scene = Scene(UNIT, [HOLE_OF_TWO], [Copy(0, scale)], passages=True)
        assert (scene.holes, passages(scene)) == (holes, tight)
        changed = Scene(UNIT, [HOLE_OF_TWO], [Copy(0, 1)], passages=True).change(0, scale)
        assert changed.digest == scene.digest and changed.passages() == scene.passages()


@pytest.mark.parametrize("scale", ["1/1000", "1/7", "2", "1000", "1e40"])
def test_a_scale_outside_of_the_window_is_no_extrapolation(scale: str) -> None:
    first = Scene(UNIT, [HOLE_OF_TWO, UNIT], [Copy(0), Copy(1, 1, (5, 5))])
    changed = first.change(0, scale)
    alone = minkref.minkowski_sum(HOLE_OF_TWO, box(-1, -1, 0, 0), scale).region
    assert changed.sum_of(0) == alone
    assert changed.union() == minkref.unite([alone, first.sum_of(1)])
    assert changed.change(0, 1).digest == first.digest


def test_an_obstacle_inside_the_hole_of_a_robot_has_a_ring_as_its_sum() -> None:
    robot, pin = frame(3, 2), box(-1, -1, 1, 1)
    scene = Scene(robot, {"pin": pin}, [Copy("pin")], passages=True)
    ring = minkref.subtract(box(-4, -4, 4, 4), [box(-1, -1, 1, 1)])
    assert (scene.union(), scene.components, scene.holes) == (ring, 1, 1)
    assert scene.passages() == [] and free(scene) == (2, 2)
    # A pin as wide as the hole: the free place in the middle is a point, and then gone.
    assert passages(scene.change(0, 2)) == [points((0, 0))]
    assert free(scene.change(0, 2)) == (1, 2)
    assert passages(scene.change(0, 2 + TINY)) == []


def test_a_robot_of_two_parts_blocks_by_each() -> None:
    robot = minkref.PolygonSet(
        [[[(0, 0), (1, 0), (1, 1), (0, 1)]], [[(4, 0), (5, 0), (5, 1), (4, 1)]]]
    )
    scene = Scene(robot, [UNIT], [Copy(0)])
    assert (scene.components, scene.union().area()) == (2, "8")


def test_copies_that_differ_by_little_are_kept_apart() -> None:
    scene = boxes((0, 0), (TINY, 0))
    assert scene.union().area() == str(4 + 2 * TINY)
    assert sides(scene)[tuple(points((1 + TINY, -1), (1 + TINY, 1)))] == {1}
    apart = boxes((0, 0), (2 + TINY, 0))
    assert (apart.components, apart.passages()) == (2, [])
    sliver = boxes((0, 0), (2 - TINY, 0))
    assert (sliver.components, sliver.passages(), sliver.union().area()) == (
        1, [], str(8 - 2 * TINY),
    )  # fmt: skip


def test_many_copies_in_one_place_all_own_each_edge() -> None:
    count = draws(200, 10_000)
    scene = Scene.of_arrays(UNIT, [UNIT], [0] * count, [1] * count, [(0, 0)] * count)
    assert scene.union() == box(-1, -1, 1, 1)
    assert set(map(frozenset, sides(scene).values())) == {frozenset(range(count))}


def test_a_point_and_a_segment_are_obstacles_of_a_robot_with_an_area() -> None:
    shapes = {"pin": POINT, "wire": minkref.PolygonSet("LINESTRING (0 0, 3 0)")}
    scene = Scene(UNIT, shapes, [Copy("pin", 1, (5, 5)), Copy("wire")])
    assert scene.union() == minkref.unite([box(4, 4, 5, 5), box(-1, -1, 3, 0)])


def test_an_empty_shape_blocks_nothing() -> None:
    scene = Scene(UNIT, [minkref.PolygonSet(), UNIT], [Copy(0), Copy(1)])
    assert (scene.union(), scene.sum_of(0)) == (box(-1, -1, 1, 1), minkref.PolygonSet())
    assert {owner for side in sides(scene).values() for owner in side} == {1}


@pytest.mark.parametrize("robot", [POINT, minkref.PolygonSet("LINESTRING (0 0, 0 1)")])
def test_robot_and_shape_cannot_both_lack_an_area(robot: minkref.PolygonSet) -> None:
    with pytest.raises(minkref.BadInput) as refused:
        Scene(robot, [POINT], [Copy(0)])
    assert refused.value.code == "no-area"
