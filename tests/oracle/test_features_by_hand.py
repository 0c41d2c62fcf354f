"""The judge of features finds trees, bars, bridges and tracks known by hand."""

from __future__ import annotations

from fractions import Fraction

import pytest
from known_features import bars, box, holed, only_root, slot, squares, tangent_hole
from minkref.oracle.features import Judge
from minkref.oracle.features.form import canonical_json
from minkref.oracle.features.number import number, order, root

HALF = Fraction(1, 2)


@pytest.mark.parametrize(
    "ring", [box(0, 0, 2, 1), [(0, 0)], [(0, 0), (3, 1)], [(0, 0), (2, 0), (3, 0), (0, 5)]]
)
def test_convex_sets_points_and_segments_have_no_features(ring: list[tuple[int, int]]) -> None:
    judge = Judge([[ring]])
    assert judge.tree.roots == [] and judge.bars() == [] and judge.tracks() == []
    assert judge.alive(Fraction(1)) == []
    assert judge.shape_counts(Fraction(1)) == (1, 0)


@pytest.mark.parametrize("depth", [Fraction(6), HALF * 3, Fraction(11, 10)])
def test_a_deep_slot_is_one_node_with_its_ridge_then_a_mouth(depth: Fraction) -> None:
    judge = Judge(slot(Fraction(2), depth))
    assert squares(judge, judge.bars()) == [(0, 1), (0, None)]
    root = only_root(judge)
    [node] = root.children
    assert root.kind == "outside" and node.kind == "node" and node.tie
    [ridge] = node.groups
    assert len(node.children) == 2 and len(ridge) == 2
    assert sorted(judge.place_near(k) for k in ridge) == [(0, float(1 - depth)), (0, 0)]
    assert [len(f.bridges) for f in judge.alive(Fraction(1, 4))] == [1, 1]
    [mouth] = judge.alive(Fraction(9, 4))
    [(_, chord)] = mouth.bridges
    assert sorted((float(x), float(y)) for x, y in chord) == [(-1, 0), (1, 0)]
    assert len(mouth.leaves) == 2 and mouth.tie
    assert mouth.depth is not None and mouth.depth.rational == depth**2
    assert squares(judge, judge.tracks()) == [(0, 1), (0, 1), (1, None)]


def test_a_shallow_slot_has_its_node_as_far_from_mouth_and_bottom() -> None:
    width, depth = Fraction(4), Fraction(1)
    radius = (width**2 / 4 + depth**2) / (2 * depth)
    assert bars(slot(width, depth)) == [(0, radius**2), (0, None)]


@pytest.mark.parametrize(
    ("hole", "corners", "radius"), [(box(0, 0, 6, 6), 4, 3), (tangent_hole(), 8, 1),
                                    ([(5, 5), (5, 1), (2, 5)], 3, 1)],
)  # fmt: skip
def test_a_hole_about_a_circle_is_one_node(
    hole: list[tuple[int, int]], corners: int, radius: int
) -> None:
    judge = Judge(holed(hole))
    assert squares(judge, judge.bars()) == [(0, radius**2)] * corners
    assert sum(bar.is_essential for bar in judge.tree.bars) == 1
    root = only_root(judge)
    [node] = root.children
    assert root.kind == "hole" and root.level == node.level and root.groups == node.groups
    assert len(node.children) == corners and len(node.groups[0]) == 1


def test_a_rectangle_as_a_hole_is_one_node_with_a_ridge() -> None:
    judge = Judge(holed(box(0, 0, 9, 4)))
    assert squares(judge, judge.bars()) == [(0, 4)] * 4
    [node] = only_root(judge).children
    [ridge] = node.groups
    assert len(node.children) == 4
    assert sorted(judge.place_near(k) for k in ridge) == [(2, 2), (7, 2)]
    assert [len(judge.alive(Fraction(r))) for r in (1, 4, 5)] == [4, 4, 0]


def test_a_corridor_is_one_leaf_at_half_its_width() -> None:
    judge = Judge([[box(0, 0, 5, 1)], [box(2, 4, 5, 1)]])
    [leaf] = only_root(judge).children
    assert leaf.kind == "minimum" and squares(judge, judge.bars()) == [(Fraction(9, 4), None)]
    assert sorted(judge.place_near(k) for k in leaf.groups[0]) == [(2, 2.5), (5, 2.5)]
    assert judge.alive(Fraction(2)) == [] and len(judge.alive(Fraction(3))) == 1
    assert judge.shape_counts(Fraction(2)) == (2, 0) and judge.shape_counts(Fraction(3)) == (1, 0)
    [feature] = judge.alive(Fraction(3))
    assert len(feature.bridges) == 2 and feature.pocket is None


def test_tip_to_tip_is_a_saddle_with_a_constant_chord() -> None:
    judge = Judge([[[(-4, -2), (0, 0), (-4, 2)]], [[(2, 0), (6, -2), (6, 2)]]])
    [leaf] = only_root(judge).children
    assert leaf.kind == "minimum" and squares(judge, judge.bars()) == [(1, None)]
    for square in (Fraction(3, 2), Fraction(4)):
        [feature] = judge.alive(square)
        for _, chord in feature.bridges:
            assert sorted((float(x), float(y)) for x, y in chord) == [(0, 0), (2, 0)]
    assert judge.shape_counts(Fraction(1)) == (1, 0)


def test_flat_tips_at_distance_two_have_a_ridge_and_no_event_at_five_quarters() -> None:
    half = HALF
    judge = Judge([[[(-4, -2), (0, -half), (0, half), (-4, 2)]],
                   [[(2, half), (2, -half), (6, -2), (6, 2)]]])  # fmt: skip
    [leaf] = only_root(judge).children
    assert sorted(judge.place_near(k) for k in leaf.groups[0]) == [(1, -0.5), (1, 0.5)]
    assert squares(judge, judge.bars()) == [(1, None)]
    assert Fraction(25, 16) not in {square.rational for square in judge.levels.squares}


def test_rings_that_touch_have_an_end_in_each_wedge() -> None:
    judge = Judge([[box(-2, -2, 2, 2)], [box(0, 0, 2, 2)]])
    names = {judge.wedge_name(k) for k in range(len(judge.outline.wedges))}
    assert names == {("end", "0", "0", "1", "0"), ("end", "0", "0", "-1", "0")}
    assert squares(judge, judge.bars()) == [(0, None), (0, None)]
    root = only_root(judge)
    assert root.kind == "outside" and len(root.children) == 2
    assert judge.shape_counts(Fraction(1)) == (1, 0)


def test_a_vertex_on_a_wall_has_a_wedge_on_each_side_and_none_behind() -> None:
    judge = Judge([[box(0, 0, 6, 1)], [[(3, 1), (5, 4), (1, 4)]]])
    assert {judge.wedge_name(k)[1:3] for k in range(len(judge.outline.wedges))} == {("3", "1")}
    assert len(judge.outline.wedges) == 2


def test_straight_vertices_order_and_start_of_rings_change_nothing() -> None:
    [[ring]] = slot(Fraction(2), Fraction(6))
    told = canonical_json(Judge([[ring]]))
    halves = [
        each for p, q in zip(ring, [*ring[1:], ring[0]], strict=True)
        for each in (p, ((p[0] + q[0]) / 2, (p[1] + q[1]) / 2))
    ]  # fmt: skip
    assert canonical_json(Judge([[halves[3:] + halves[:3]]])) == told
    assert canonical_json(Judge([[ring[::-1]]])) == told


def test_collinear_points_on_the_hull_have_a_gap_each() -> None:
    judge = Judge([[box(0, 0, 1, 1)], [box(3, 0, 1, 1)], [box(6, 0, 1, 1)]])
    assert len(judge.outline.gaps) == 4
    assert squares(judge, judge.bars()) == [(1, None), (1, None)]
    assert len(only_root(judge).children) == 2


def test_an_island_in_a_hole_has_loops_that_the_tree_ignores() -> None:
    judge = Judge([[box(0, 0, 10, 10), box(1, 1, 8, 8)], [box(4, 4, 2, 2)]])
    top = root(2) * 3 / (root(2) + 1)  # as far from a corner's walls and the island's corner
    node = only_root(judge).children[0]
    assert len(node.children) == 8 and len(node.groups) == 4
    assert order(judge.levels.squares[node.level], top * top) == 0
    assert squares(judge, [bar for bar in judge.bars() if bar[0]])[0][0] == Fraction(9, 4)
    assert [bar[0] for bar in judge.bars()].count(0) == 4
    assert judge.shape_counts(Fraction(1)) == (2, 1) and judge.shape_counts(Fraction(3)) == (1, 4)
    assert judge.shape_counts(Fraction(4)) == (1, 0)


def test_nested_frames_have_a_root_each() -> None:
    judge = Judge([[box(0, 0, 20, 20), box(1, 1, 18, 18)], [box(4, 4, 12, 12), box(5, 5, 10, 10)]])
    assert [root.kind for root in judge.tree.roots] == ["hole", "hole"]


def test_a_bay_like_a_t_has_three_bridges() -> None:
    judge = Judge([[box(-10, 1, 20, 2)], [box(-10, -10, 9, 9)], [box(1, -10, 9, 9)]])
    [node] = only_root(judge).children
    assert len(node.children) == 3 and judge.levels.squares[node.level].rational == Fraction(25, 16)
    assert squares(judge, judge.bars()) == [(1, Fraction(25, 16))] * 2 + [(1, None)]
    assert [len(f.bridges) for f in judge.alive(Fraction(5, 4))] == [2, 2, 2]
    assert [len(f.bridges) for f in judge.alive(Fraction(4))] == [3]
    assert node.tie


def test_a_tie_of_radii_alone_is_told_by_depth() -> None:
    """Two wells of one slot: the deeper corner's bar lives on."""
    judge = Judge([[[(-9, -9), (9, -9), (9, 0), (1, 0), (1, -6), (-1, -4), (-1, 0), (-9, 0)]]])
    bar = next(bar for bar in judge.tree.bars if bar.is_essential)
    assert judge.wedge_name(bar.leaf.wedge)[1:3] == ("1", "-6")
    [node] = only_root(judge).children
    assert not node.tie


def test_numbers_are_proven_equal() -> None:
    two, three = root(2), root(3)
    assert order(root(number(5) + root(6) * 2), two + three) == 0
    assert order(two + three, root(number(5) + root(6) * 2) + Fraction(1, 10**60)) < 0
    assert (root(8) - two * 2).sign() == 0 and root(Fraction(9, 4)).rational == Fraction(3, 2)
    assert ((number(1) / (two - 1)) - (two + 1)).sign() == 0
