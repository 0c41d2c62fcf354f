"""Results have importable classes, and refusals are of the documented kind."""

from __future__ import annotations

import copy
import pickle
from fractions import Fraction

import minkref
import pytest

SQUARE = minkref.PolygonSet([(0, 0), (2, 0), (2, 2), (0, 2)])
WALL = minkref.PolygonSet([(5, -9), (6, -9), (6, 9), (5, 9)])
SLOT = minkref.PolygonSet([[(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (3, 1), (3, 3), (1, 3)]])


def test_values_of_paths_and_fits_are_of_classes_that_are_exported() -> None:
    found = minkref.valid_scales(SQUARE, WALL, [(-9, 0), (0, 0)])
    assert isinstance(found.ranges[0], minkref.ScaleRange)
    assert isinstance(found.bounds[0], minkref.PathBound)
    assert isinstance(found.bounds[0].part, minkref.Feature)
    fit = minkref.largest_fit(SQUARE, SLOT)
    assert all(isinstance(bound, minkref.FreeBound) for bound in fit.bounds)
    proof = minkref.PathCertificate(SQUARE, WALL, [(-9, 0)])
    assert proof.free(minkref.ScaleRange(Fraction(1), Fraction(2), True, True)) == 0
    assert {"SpaceFeature", "SpacePathBound"} <= set(minkref.__all__)


def test_a_refusal_is_bad_input_with_all_its_attributes() -> None:
    with pytest.raises(minkref.BadInput) as refused:
        minkref.largest_fit(SQUARE, SLOT, at=(0, 0), between=((0, 0), (1, 1)))
    error = refused.value
    assert isinstance(error, minkref.Refusal) and isinstance(error, ValueError)
    assert (error.code, error.source) == ("usage", "largest_fit")
    assert error.line is error.ring is error.face is None
    assert error.problem == error.what and error.vertices == error.coordinates == []
    again = pickle.loads(pickle.dumps(error))
    assert (again.what, again.where, again.mend) == (error.what, error.where, error.mend)
    assert copy.copy(error).mend == error.mend


@pytest.mark.parametrize("arithmetic", ["rational", "interval", "double", "mpfr:53"])
def test_tight_passages_of_a_sum_are_found_when_asked_for(arithmetic: str) -> None:
    """They used to be None for sums without the request, which reads as `none`."""
    hole = minkref.PolygonSet(
        [[(-9, -9), (9, -9), (9, 9), (-9, 9)], [(0, 0), (2, 0), (2, 2), (0, 2)]]
    )
    found = minkref.minkowski_sum(SQUARE, hole, arithmetic=arithmetic)
    expected = minkref.tight_passages(SQUARE, hole)
    assert [passage["points"] for passage in expected] == [[(2, 2)]]
    assert found.tight_passages == expected == found.tight_passages
    index = minkref.build_index(SQUARE, hole, "1/2", 2)
    assert index.sum(1).tight_passages == expected
    assert index.sum("3/2").tight_passages == []


def test_operands_of_a_sum_may_go_before_its_passages_are_asked_for() -> None:
    found = minkref.minkowski_sum(SQUARE.translated(1, 1), SLOT.scaled(2))
    assert found.tight_passages == minkref.tight_passages(SQUARE.translated(1, 1), SLOT.scaled(2))
