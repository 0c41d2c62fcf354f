"""Targets that declare boundary sums."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from minkref import _core
from minkref.fuzz.plane.boundary_sum import boundary_sum, decide_boundary
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.judgement import judge
from minkref.fuzz.plane.reference import ReferenceTarget
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.targets.answer import answered
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import Outcome, Verdict
from named_cases import named

CURVES = Declaration("curves", sum="boundary")
BIG_AND_SMALL = (
    '{"P":{"polygons":[{"outer":[[0,0],[10,0],[10,10],[0,10]]}]},'
    '"Q":{"polygons":[{"outer":[[0,0],[1,0],[1,1],[0,1]]}]},"scale":"1"}'
)


def judged(case: Case, text: str) -> Outcome:
    answer = answered(text, 0.0)
    answer.declaration = CURVES
    truth = ReferenceTarget("minkref:paper", "paper").sum(case)
    (outcome,) = judge(case, {"minkref:paper": truth, "curves": answer}, ["curves"])
    return outcome


def test_sum_of_a_large_and_a_small_square_is_a_ring_of_area_40() -> None:
    region = boundary_sum(named(BIG_AND_SMALL))
    assert (region.set.area(), region.holes) == ("40", 1)


@pytest.mark.parametrize("family", ["random", "holes", "comb", "convex", "cells"])
def test_sum_of_boundaries_is_a_part_of_the_sum_that_misses_containment_only(family: str) -> None:
    for index in range(8):
        case = named(f"{family}:5:{index}")
        region = ReferenceTarget("minkref:paper", "paper").sum(case).region
        assert region is not None
        curves = boundary_sum(case)
        assert _core.minus(curves.set, region.set).is_empty
        point = _core.inner_point(_core.minus(region.set, curves.set))
        if point is not None:
            witness = decide_boundary(case, point)
            assert not witness.in_truth
            assert holds(case.P_json, case.Q_json, case.scale, witness)
            assert holds(case.P_json, case.Q_json, case.scale, replace(witness, tolerance="0"))


def test_region_in_place_of_the_boundaries_is_wrong_with_a_witness() -> None:
    case = named(BIG_AND_SMALL)
    right = judged(case, boundary_sum(case).json)
    assert right.verdict is Verdict.PASS
    region = ReferenceTarget("minkref:paper", "paper").sum(case).region
    assert region is not None
    outcome = judged(case, region.json)
    assert outcome.verdict is Verdict.WRONG
    assert outcome.witness is not None and outcome.witness.boundary
    assert holds(case.P_json, case.Q_json, case.scale, outcome.witness)


def test_witness_on_the_boundaries_names_points_on_them() -> None:
    case = named(BIG_AND_SMALL)
    witness = decide_boundary(case, ("1/2", "5"))
    assert witness.in_truth and witness.p and witness.q
    p, q = [Fraction(x) for x in witness.p], [Fraction(x) for x in witness.q]
    assert [p[0] + q[0], p[1] + q[1]] == [Fraction(1, 2), 5]
    assert holds(case.P_json, case.Q_json, case.scale, witness)
    moved = replace(witness, p=("1/4", "5"), q=("1/4", "0"))
    assert not holds(case.P_json, case.Q_json, case.scale, moved)
