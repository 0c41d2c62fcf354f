"""A rounded sum beside the exact one: the same structure, or another with a witness."""

from __future__ import annotations

from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest
from minkref import _core
from minkref.fuzz.judges.plane.rounded_sums import Comparison, compare

SQUARE = _core.PolygonSet([(0, 0), (1, 0), (1, 1), (0, 1)])
FRAME = _core.PolygonSet([[(0, 0), (8, 0), (8, 8), (0, 8)], [(2, 2), (2, 6), (6, 6), (6, 2)]])
ULP = Fraction(1, 2**49)  # of 53 bits at 9


def beside(got: Any, bits: int | None = 53) -> Comparison:
    answer: Any = SimpleNamespace(region=_core.PolygonSet(got, validate=False))
    return compare(FRAME, SQUARE, "1", answer, bits)


def sum_with(right: object = 9, hole: object = 6) -> list[Any]:
    """The sum of the frame and the square: [0, 9]^2 without ]3, 6[^2."""
    outer = [(0, 0), (right, 0), (9, 9), (0, 9)]
    return [outer, [(3, 3), (3, 6), (hole, 6), (6, 3)]]


def test_the_exact_sum_is_none_off() -> None:
    for bits in (None, 53):
        assert beside(sum_with(), bits) == Comparison(True, Fraction(0))


@pytest.mark.parametrize("ulps", [1, 5, 1000])
def test_coordinates_a_few_ulps_off_keep_the_structure(ulps: int) -> None:
    assert beside(sum_with(right=9 - ulps * ULP)) == Comparison(True, Fraction(ulps))
    assert beside(sum_with(hole=6 + ulps * ULP)) == Comparison(True, Fraction(ulps))


def test_exact_numbers_have_no_ulps() -> None:
    assert not beside(sum_with(right=9 - ULP), None).same_structure


def test_a_lost_hole_is_proven_by_a_point_outside_of_the_sum() -> None:
    found = beside(sum_with()[:1])
    assert (found.same_structure, found.in_sum) == (False, False)
    assert found.point is not None
    x, y = map(Fraction, found.point)
    assert 3 < x < 6 and 3 < y < 6


def test_a_lost_corner_is_proven_by_a_point_of_the_sum() -> None:
    found = beside([[(0, 0), (9, 0), (0, 9)], sum_with()[1]])
    assert (found.same_structure, found.in_sum) == (False, True)


def test_a_vertex_more_is_another_structure_however_near_it_is() -> None:
    outer, hole = sum_with()
    assert not beside([[*outer, (-ULP, Fraction(1, 2))], hole]).same_structure
