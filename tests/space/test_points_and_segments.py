"""Points and segments as operands in space: membership by brute force, verdicts with a witness."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from minkref.errors import Refusal
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.cells import surface_of
from minkref.fuzz.space.comparison import compare
from minkref.fuzz.space.convex_sum import reference_sum
from minkref.fuzz.space.fault_search import decided
from minkref.fuzz.space.generators.convex import cube
from minkref.fuzz.space.generators.polycube import random_polycube
from minkref.fuzz.space.pair import SpacePair
from minkref.fuzz.space.pairs import space_pair
from minkref.fuzz.space.witness import holds
from minkref.fuzz.verdicts.verdict import Witness

ONE = Fraction(1)
EPS = Fraction(1, 10**6)
PAIRS = [space_pair("thin", 5, index) for index in range(40)]


def point(*numbers: int | Fraction) -> Point:
    x, y, z = (Fraction(number) for number in numbers)
    return (x, y, z)


def segment(a: Point, b: Point) -> Polyhedron:
    return Polyhedron((a, b), ())


def test_the_reference_and_the_hull_are_the_same_set() -> None:
    for pair in PAIRS:
        assert compare(pair, reference_sum(pair.P, pair.Q, pair.scale)).proven


def test_one_end_alone_is_wrong_and_the_witness_holds() -> None:
    found = 0
    for pair in PAIRS:
        flat = pair.P if pair.P.is_thin else pair.Q
        if len(flat.vertices) == 1:
            continue
        end = Polyhedron(flat.vertices[:1], ())
        P, Q = (end, pair.Q) if pair.P.is_thin else (pair.P, end)
        claimed = reference_sum(P, Q, pair.scale)
        for exact, tolerance in ((True, Fraction(0)), (False, EPS)):
            comparison = compare(pair, claimed, exact, tolerance)
            assert comparison.verdict == "wrong" and comparison.witness
            assert holds(pair.P, pair.Q, pair.scale, comparison.witness)
        found += 1
    assert found > 10


def test_a_point_that_is_forgotten_is_wrong() -> None:
    for pair in PAIRS:
        flat = pair.P if pair.P.is_thin else pair.Q
        if len(flat.vertices) == 1 and any(any(v) for v in flat.vertices):
            body = pair.Q if pair.P.is_thin else pair.P.scaled(pair.scale)
            assert compare(pair, body).verdict == "wrong"


@pytest.mark.parametrize("seed", range(6))
def test_a_point_lies_in_the_sum_of_a_segment_and_cells_where_a_cell_says_so(seed: int) -> None:
    """For a segment along x: the line from the point backwards meets a cell."""
    dice = random.Random(seed)
    cells = random_polycube(dice, 9)
    length = Fraction(dice.randint(1, 5), 2)
    flat = segment(point(0, 0, 0), point(length, 0, 0))
    for swapped in (False, True):
        solid = surface_of(cells)
        pair = SpacePair(*((solid, flat) if swapped else (flat, solid)), ONE, "named")
        for _ in range(60):
            x = point(*(Fraction(dice.randint(-6, 12), dice.choice((1, 2, 3))) for _ in range(3)))
            truth = any(
                a <= x[0] and x[0] - length <= a + 1 and b <= x[1] <= b + 1 and c <= x[2] <= c + 1
                for a, b, c in cells
            )
            witness = decided(pair, x)
            assert witness.in_truth == truth
            assert holds(pair.P, pair.Q, pair.scale, witness)


def test_a_witness_that_is_false_does_not_hold() -> None:
    flat, solid = segment(point(0, 0, 0), point(4, 0, 0)), cube(point(0, 0, 0), ONE)
    in_sum = Witness(("3", "1/2", "1/2"), False)
    beside = Witness(("3", "1/2", "1/2"), True, ("3", "1", "0"), ("0", "-1/2", "1/2"))
    off_the_segment = Witness(("3", "3/2", "1/2"), True, ("3", "1", "0"), ("0", "1/2", "1/2"))
    behind = Witness(("-1/2", "1/2", "1/2"), True, ("-1", "0", "0"), ("1/2", "1/2", "1/2"))
    for witness in (in_sum, beside, off_the_segment, behind):
        assert not holds(flat, solid, ONE, witness)
    assert holds(flat, solid, ONE, Witness(("6", "1/2", "1/2"), False))
    assert holds(flat, solid, ONE, Witness(("6", "1/2", "1/2"), False), Fraction(1, 2))
    assert not holds(flat, solid, ONE, Witness(("6", "1/2", "1/2"), False), ONE)


def test_points_apart_by_a_distance() -> None:
    solid = cube(point(0, 0, 0), ONE)
    pair = SpacePair(segment(point(0, 0, 0), point(4, 4, 4)), solid, ONE, "named")
    outside = point(5, 6, Fraction(11, 2))
    assert pair.meeting.apart(outside, Fraction(0))
    assert pair.meeting.apart(outside, Fraction(1, 3))
    assert not pair.meeting.apart(outside, ONE)


def test_two_operands_without_volume_are_refused() -> None:
    thin = {"vertices": [["0", "0", "0"]], "faces": []}
    with pytest.raises(Refusal, match="neither operand has a volume"):
        SpaceCase.of(CaseName("x", "named"), [thin, thin], "1", "here")


def test_a_segment_between_equal_ends_is_refused() -> None:
    ends = {"vertices": [["0", "0", "0"], ["0", "0", "0"]], "faces": []}
    body = cube(point(0, 0, 0), ONE).document()
    with pytest.raises(Refusal, match="the same point"):
        SpaceCase.of(CaseName("x", "named"), [ends, body], "1", "here")
