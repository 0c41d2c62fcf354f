"""The judge of features before sums with a disc, areas, and diagrams of CGAL and Boost; and sets
that are drawn for it."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction
from functools import cache

import pytest
from minkref.fuzz.features.feature_draws import KINDS, drawn_set, set_of
from minkref.fuzz.features.outer_diagram import BOOST, CGAL, DiagramJudge, absence
from minkref.fuzz.geometry.plane import Shape
from minkref.fuzz.judges.disc.feature_shape_laws import (
    Table,
    count,
    diagram_faults,
    rounded_bars,
    sum_faults,
)
from minkref.oracle.features import Judge
from minkref.oracle.features.graph import Graph
from minkref.oracle.features.outline import Outline
from minkref.oracle.features.tiles import doubled_area, doubled_room
from thoroughness import draws

SEED, SETS = 82, draws(20, 200)


@cache
def judged(number: int) -> tuple[str, Shape, Judge]:
    name, shape = drawn_set(SEED, number)
    return name, shape, Judge(shape)


def test_components_holes_and_bridges_are_those_of_sums() -> None:
    print(f"seed {SEED}")
    dice = random.Random(SEED)
    counts: Counter[str] = Counter()
    for number in range(SETS):
        name, shape, judge = judged(number)
        assert sum_faults(shape, judge, dice, counts) == [], name
    assert counts["radii"] > SETS


def test_chords_tile_the_hull_and_the_holes_without_the_set() -> None:
    print(f"seed {SEED}")
    for number in range(SETS):
        name, _, judge = judged(number)
        tiles, room = doubled_area(judge.levels), doubled_room(judge.levels)
        low, high = (tiles - room).bounds(80)
        assert low <= 0 <= high and high - low < 2**50, name


@pytest.mark.parametrize("library", [CGAL, BOOST])
def test_bars_are_those_along_diagrams_of_libraries(library: str) -> None:
    if told := absence(library):
        pytest.skip(told)
    print(f"seed {SEED}")
    table = Table()
    with DiagramJudge(library, 60) as diagram:
        for number in range(SETS):
            name, shape, judge = judged(number)
            diagram_faults(name, set_of(shape), rounded_bars(judge), diagram, table)
    assert table.faults == []
    assert table.counts[f"sets before {library}"] > SETS // 3


def test_half_of_the_sets_have_ties_and_each_kind_comes_with_both() -> None:
    print(f"seed {SEED}")
    counts: Counter[str] = Counter()
    for number in range(2 * len(KINDS)):
        name, _, judge = judged(number)
        count(name, judge, counts)
    for kind in KINDS:
        assert counts[f"sets: {kind}"] == counts[f"sets: {kind} shifted"] == 1
    assert counts["sets with several places at one radius"] >= len(KINDS) // 2
    assert counts["node"] and counts["minimum"] and counts["hole"] and counts["outside"]


def test_candidates_left_out_by_doubles_are_none_of_the_places() -> None:
    for number in (0, 5, 7):
        _, _, judge = judged(number)
        graph = Graph(judge.outline, in_doubles=False)
        assert len(graph.places) == len(judge.graph.places)


def test_far_and_small_sets_keep_their_tree() -> None:
    """The tree is covariant under a similarity with rational numbers."""
    _, shape, judge = judged(1)
    far = Fraction(10**15 + 1, 3), Fraction(-(10**12), 7)
    given = [
        [[(Fraction(x) / 3**20 + far[0], Fraction(y) / 3**20 + far[1]) for x, y in r] for r in p]
        for p in shape
    ]
    other = Judge(given)
    assert other.bars() == judge.bars() and other.tracks() == judge.tracks()


def test_an_outline_reads_rings_either_way_round() -> None:
    _, shape, judge = judged(4)
    turned = [[ring[::-1] for ring in polygon] for polygon in shape]
    given = [[[(Fraction(x), Fraction(y)) for x, y in r] for r in p] for p in turned]
    assert len(Outline(given).sites) == len(judge.outline.sites)
