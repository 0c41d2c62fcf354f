"""Degenerate shapes with merge trees and bars known by hand."""

from __future__ import annotations

import math
from collections import Counter
from fractions import Fraction
from typing import Any

import minkref
import pytest
from feature_shapes import (
    BAY_OF_THREE,
    CORNER_TO_CORNER,
    CORRIDOR,
    FLAT_TIPS,
    OCTAGON,
    TIP_TO_TIP,
    Shape,
    box,
    made,
    slot,
    with_hole,
)

NEVER = None


def features_of(shape: Shape) -> minkref.Features:
    return minkref.features(made(shape))


def bars_of(found: minkref.Features) -> Counter[tuple[Fraction, Fraction | None, bool]]:
    """Birth and death as exact squared radii (None: infinity), and whether a bar is essential."""
    squares = [node.squared_radius for node in found.tree]
    return Counter((squares[bar.leaf], squares[bar.end], bar.essential) for bar in found.bars)


def kinds_of(found: minkref.Features) -> dict[str, int]:
    return dict(Counter(node.kind for node in found.tree))


def node_of(found: minkref.Features, kind: str) -> Any:
    (node,) = (node for node in found.tree if node.kind == kind)
    return node


@pytest.mark.parametrize("shape", ["convex", "point", "segment"])
def test_what_is_convex_has_no_features(shape: str) -> None:
    sets = {
        "convex": made([[box(0, 0, 4, 3)]]),
        "point": minkref.read_text("POINT (1 2)", "wkt"),
        "segment": minkref.read_text("LINESTRING (0 0, 3 1)", "wkt"),
    }
    found = minkref.features(sets[shape])
    assert (found.bars, found.tree, found.tracks, found.at(5)) == ([], [], [], [])
    assert found.notches(0) == []


def test_a_deep_slot_is_one_feature_from_half_its_width_on() -> None:
    found = features_of(slot(2, 5))
    assert kinds_of(found) == {"reflex": 2, "merge": 1, "outside": 1}
    assert bars_of(found) == Counter({(0, 1, False): 1, (0, NEVER, True): 1})
    assert all(bar.tie for bar in found.bars)
    merge = node_of(found, "merge")
    assert merge.squared_radius == 1 and merge.tie
    assert len(merge.places) == 1  # one flat ridge
    assert {event.place for event in merge.places[0]} == {(3, 2), (3, 6)}
    (mouth,) = found.at(5)[0].bridges
    assert set(mouth.near) == {(2, 6), (4, 6)}
    (least,) = found.notches(5)
    assert (least.vertex, least.tie) == ((2, 1), True)


def test_a_shallow_slot_meets_as_far_from_its_mouth() -> None:
    width, depth = 8, 2
    found = features_of(slot(width, depth))
    radius = Fraction(width**2, 4) + depth**2
    radius /= 2 * depth
    assert node_of(found, "merge").squared_radius == radius**2
    assert bars_of(found) == Counter({(0, radius**2, False): 1, (0, NEVER, True): 1})


def test_a_square_hole_is_one_node_of_degree_four() -> None:
    found = features_of(with_hole(box(0, 0, 6, 6)))
    assert kinds_of(found) == {"reflex": 4, "merge": 1, "hole": 1}
    assert bars_of(found) == Counter({(0, 9, False): 3, (0, 9, True): 1})
    assert len(node_of(found, "merge").children) == 4
    assert [bar.tie for bar in found.bars] == [True] * 4
    assert len(found.at(6)) == 4 and found.at(7) == []


def test_an_octagonal_hole_merges_pair_by_pair() -> None:
    """The longer sides are nearer to the middle: the ends of each shorter side meet before. Four
    features with one radius at their births' ends are four nodes; all meet at one place."""
    found = features_of(with_hole(OCTAGON))
    assert kinds_of(found) == {"reflex": 8, "merge": 5, "hole": 1}
    *pairs, last = (node for node in found.tree if node.kind == "merge")
    assert len({node.alpha for node in pairs}) == 1
    assert [len(node.children) for node in (*pairs, last)] == [2, 2, 2, 2, 4]
    assert last.squared_radius == node_of(found, "hole").squared_radius == Fraction(79**2, 2)
    assert Counter(bar.death == last.alpha for bar in found.bars) == {True: 4, False: 4}
    assert sum(bar.essential for bar in found.bars) == 1
    assert all(node.tie for node in (*pairs, last))


def test_a_rectangle_is_one_node_along_a_ridge() -> None:
    found = features_of(with_hole(box(0, 0, 10, 6)))
    assert kinds_of(found) == {"reflex": 4, "merge": 1, "hole": 1}
    assert bars_of(found) == Counter({(0, 9, False): 3, (0, 9, True): 1})
    (ridge,) = node_of(found, "merge").places
    assert {event.place for event in ridge} == {(3, 3), (7, 3)}


def test_a_corridor_is_born_at_once() -> None:
    found = features_of(CORRIDOR)
    assert kinds_of(found) == {"minimum": 1, "outside": 1}
    assert bars_of(found) == Counter({(1, NEVER, True): 1})
    (ridge,) = node_of(found, "minimum").places
    assert {event.place for event in ridge} >= {(2, 2), (6, 2)}
    (alive,) = found.at(Fraction(21, 10))
    assert (alive.deepest, alive.leaves, len(alive.bridges)) == (None, (), 2)
    assert found.notches(3) == []


def test_tip_to_tip_is_a_saddle_with_a_constant_chord() -> None:
    found = features_of(TIP_TO_TIP)
    assert kinds_of(found) == {"minimum": 1, "outside": 1}
    for alpha in (Fraction(21, 10), Fraction(5, 2), Fraction(14, 5)):
        (alive,) = found.at(alpha)
        assert [set(bridge.near) for bridge in alive.bridges] == [{(0, 0), (2, 0)}] * 2


def test_flat_tips_have_no_event_where_the_closing_falls_apart() -> None:
    found = features_of(FLAT_TIPS)
    assert kinds_of(found) == {"minimum": 1, "outside": 1}
    assert bars_of(found) == Counter({(1, NEVER, True): 1})


def test_each_wedge_of_less_than_half_a_turn_is_a_leaf() -> None:
    found = features_of(CORNER_TO_CORNER)
    leaves = [node for node in found.tree if node.kind == "reflex"]
    assert [(leaf.vertex, leaf.along) for leaf in leaves] == [((2, 2), (-1, 0)), ((2, 2), (1, 0))]
    assert bars_of(found) == Counter({(0, NEVER, True): 1, (0, NEVER, False): 1})


def test_straight_vertices_are_no_leaves() -> None:
    (plain,) = slot(2, 5)
    ring = plain[0]
    more = []
    for (x, y), (z, w) in zip(ring, [*ring[1:], ring[0]], strict=True):
        more += [(x, y), (Fraction(x + z, 2), Fraction(y + w, 2))]
    assert features_of([[more]]).digest == features_of([plain]).digest


def test_points_in_line_on_the_hull_have_a_gap_between_each_two() -> None:
    comb = [[[(0, 0), (6, 0), (6, 2), (5, 2), (5, 1), (3, 1), (3, 2), (2, 2), (2, 1), (1, 1),
              (1, 2), (0, 2)]]]  # fmt: skip
    found = features_of(comb)
    alive = found.at(1000)
    assert sorted(sorted(b.near) for feature in alive for b in feature.bridges) == [
        [(1, 2), (2, 2)], [(3, 2), (5, 2)],
    ]  # fmt: skip
    assert sum(math.isinf(bar.death[0]) for bar in found.bars) == 2


def test_each_component_of_the_complement_has_a_root() -> None:
    nested = [[box(0, 0, 40, 40), box(5, 5, 30, 30)], [box(10, 10, 20, 20), box(15, 15, 10, 10)]]
    found = features_of(nested)
    assert kinds_of(found) == {"reflex": 8, "minimum": 4, "merge": 2, "hole": 2}
    assert sum(bar.essential for bar in found.bars) == 2
    around, inside = (node for node in found.tree if node.kind == "merge")
    # Loops count for nothing: four corners at once close the way around the island.
    assert (len(around.children), len(around.places)) == (8, 4)
    assert (len(inside.children), len(inside.places)) == (4, 1)


def test_a_bay_between_three_blocks_has_three_bridges() -> None:
    found = features_of(BAY_OF_THREE)
    radius = Fraction(37, 12)
    assert node_of(found, "merge").squared_radius == radius**2
    assert bars_of(found) == Counter({(1, NEVER, True): 1, (9, radius**2, False): 2})
    assert not any(bar.tie for bar in found.bars)
    (alive,) = found.at(8)
    assert sorted(sorted(bridge.near) for bridge in alive.bridges) == [
        [(0, 2), (0, 8)], [(4, 10), (6, 10)], [(10, 2), (10, 8)],
    ]  # fmt: skip


def leaning(x: Any, y: Any) -> tuple[Any, Any]:
    """Turned and stretched so that lengths of edges become roots."""
    return 2 * x - y, x + 2 * y


def test_slots_that_are_alike_are_tied() -> None:
    ring: list[tuple[int, int]] = [(0, 0), (41, 0), (41, 5)]
    for x in range(39, 0, -2):
        ring += [(x + 1, 5), (x + 1, 2), (x, 2), (x, 5)]
    found = minkref.features(made([[[*ring, (0, 5)]]], leaning))
    assert kinds_of(found) == {"reflex": 40, "merge": 20, "outside": 1}
    assert all(node.tie for node in found.tree if node.children)
    notches = found.notches(Fraction(1, 2))
    # Equal bars and equal depths: by place, those that live on before the others.
    assert [found.bars[n.bar].death[0] for n in notches] == sorted(
        (bar.death[0] for bar in found.bars), reverse=True
    )
    assert len({notch.depth for notch in notches}) == 1


def test_mirror_images_are_tied_at_places_of_different_fields() -> None:
    """A pit and its image in the floor of a bay, with walls of roots."""
    half = [(18, 20), (18, 6), (16, 5), (13, 2), (11, 6)]
    ring = [(0, 0), (20, 0), (20, 20), *half, *((20 - x, y) for x, y in reversed(half)), (0, 20)]
    for move in (lambda x, y: (x, y), leaning):
        found = minkref.features(made([[ring]], move))
        tied = [node for node in found.tree if node.tie]
        assert len(tied) == 1 and len(tied[0].children) == 2
        births, deaths = zip(*((bar.birth, bar.death) for bar in found.bars), strict=True)
        assert set(births) == {(0, 0)}
        assert sorted(Counter(deaths).values()) == [1, 1, 2]


def test_congruent_bridges_are_tied_beyond_four_roots() -> None:
    """Triangles and their images: equal depths whose roots no field of ours holds. As nested roots
    they took minutes."""
    half = [[(3, 5), (5, -2), (1, 0)], [(6, 9), (7, 7), (4, 9)], [(-1, -6), (4, 0), (-1, -3)],
            [(5, -5), (10, -8), (12, -2)]]  # fmt: skip
    pieces = [minkref.PolygonSet(ring) for ring in half]
    pieces += [minkref.PolygonSet([(-x, y) for x, y in ring]) for ring in half]
    found = minkref.features(minkref.unite(pieces))
    assert sum(node.tie for node in found.tree) == 2
