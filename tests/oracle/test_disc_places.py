"""The judge of event places for a disc: it agrees with the reference, knows examples by hand, and
refuses answers with a single error."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction
from functools import cache
from typing import Any

import pytest
from minkref.fuzz.features.place_draws import KINDS, drawn_set, set_of
from minkref.fuzz.judges.disc.disc_places import Table, compare, faults_of, law_faults, rows_of
from minkref.fuzz.judges.disc.place_mutants import MUTANTS
from minkref.oracle.places import Boundary
from minkref.oracle.places.bridges import bridges
from minkref.oracle.places.chambers import Chambers
from minkref.oracle.places.surd import Surd, order, surd
from thoroughness import draws

SEED, SETS = 46, draws(1, 2)
BOXES = [[(16, 12), (17, 12), (17, 13), (16, 13)], [(15, 7), (16, 7), (16, 8), (15, 8)],
         [(11, 10), (12, 10), (12, 13), (11, 13)],
         [(19, 10), (20, 10), (20, 11), (19, 11)]]  # fmt: skip
EQUAL = [[ring] for ring in BOXES]


@cache
def judged(kind: str) -> Table:
    """Judges one or two sets of a kind."""
    print(f"seed {SEED}")
    first = list(KINDS).index(kind)
    table = Table()
    compare(SEED, range(first, SETS * len(KINDS), len(KINDS)), table)
    return table


@pytest.mark.parametrize("kind", KINDS)
def test_events_are_where_and_what_the_judge_finds(kind: str) -> None:
    table = judged(kind)
    assert table.faults == []
    assert table.counts["events"] > 0 and table.counts[f"sets: {kind}"] == SETS


def test_all_kinds_of_sets_and_events_are_drawn() -> None:
    counts = sum((Counter(judged(kind).counts) for kind in KINDS), Counter[str]())
    assert all(counts[f"sets: {kind}"] for kind in KINDS)
    assert all(counts[kind] for kind in ("corner", "joint", "saddle", "ridge", "maximum"))
    assert counts["sets with several births at one radius"] > 1


@pytest.mark.parametrize("name", MUTANTS)
def test_an_answer_with_one_thing_wrong_is_refused(name: str) -> None:
    print(f"seed {SEED}")
    dice = random.Random(f"{SEED} {name}")
    for number in range(200):
        _, shape = drawn_set(SEED, number)
        changed = MUTANTS[name](dice, shape, rows_of(set_of(shape)))
        if changed is not None and faults_of(shape, changed):
            return
    pytest.fail("the judge accepts all of them")


def test_bridges_of_four_boxes() -> None:
    """By hand: between the boxes on the left and at the top, 4 apart, all along one side."""
    boundary = Boundary(EQUAL)
    found = {(bridge.square, bridge.middle): bridge for bridge in bridges(boundary)}
    at_two = [middle for square, middle in found if square == 4]
    assert (Fraction(16), Fraction(10)) in at_two
    flat = [bridge.flat for bridge in found.values() if bridge.flat is not None]
    assert ((14.0, 12.0), (14.0, 13.0)) in [tuple(sorted(each)) for each in flat]
    chambers = Chambers(boundary, list(found.values()))
    assert sum(chambers.is_outer(face) for face in range(len(chambers.faces))) == 1


def test_a_square_is_no_bridge_but_a_greatest_value() -> None:
    """The middle of a square frame is equally far from four walls: nothing is cut off there."""
    outer, hole = [(0, 0), (8, 0), (8, 8), (0, 8)], [(2, 2), (2, 6), (6, 6), (6, 2)]
    assert bridges(Boundary([[outer, hole]])) == []
    assert faults_of([[outer, hole]], rows_of(set_of([[outer, hole]]))) == []


def test_a_hole_that_is_not_listed_is_missed() -> None:
    outer, hole = [(0, 0), (8, 0), (8, 8), (0, 8)], [(2, 2), (2, 6), (6, 6), (6, 2)]
    events, _ = rows_of(set_of([[outer, hole]]))
    assert any("not listed" in fault for fault in faults_of([[outer, hole]], (events, [])))


def test_straight_vertices_and_further_edges_on_a_line_have_their_own_names() -> None:
    shape: Any = [[[(0, 0), (9, 0), (9, 4), (8, 4), (8, 1), (7, 1), (7, 4), (6, 4), (6, 2), (5, 2),
                    (3, 2), (3, 4), (2, 4), (2, 2), (1, 2), (1, 4), (0, 4)]]]  # fmt: skip
    events, _ = rows_of(set_of(shape))
    names = {tuple(each["edge"]) for row in events for each in row["features"] if "edge" in each}
    assert {(0, 9), (0, 13)} <= names and (0, 8) not in names
    assert faults_of(shape, rows_of(set_of(shape))) == []


def test_laws_see_a_place_that_depends_on_how_a_set_is_written() -> None:
    rows = rows_of(set_of(EQUAL))
    assert law_faults(SEED, 0, EQUAL, rows) == []
    rows[0][0]["place"] = [0.0, 0.0]
    assert law_faults(SEED, 0, EQUAL, rows) != []


def test_numbers_of_one_root_and_of_two_are_ordered() -> None:
    two, three = Surd.root(Fraction(2)), Surd.root(Fraction(3))
    assert (two * two).rational == 2 and Surd.root(Fraction(9, 4)) == surd(Fraction(3, 2))
    assert order(two, three) < 0 < order(three + surd(1), two.times(Fraction(3, 2)))
    assert order(two + surd(1), two + surd(1)) == 0
    # 17/12 exceeds the square root of 2 by less than 0.003.
    assert (surd(Fraction(17, 12)) - two).sign() > 0 > (surd(Fraction(41, 29)) - two).sign()
    with pytest.raises(ValueError, match="two roots"):
        two + three
