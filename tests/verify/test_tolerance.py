"""The exact sandwich around the sum, and witnesses with a tolerance."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction

import pytest
from minkref import _core
from minkref.fuzz.geometry.plane import moved
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.exact_shapes import shape_of
from minkref.fuzz.plane.families.drawing import shape_text
from minkref.fuzz.plane.judgement import judge
from minkref.fuzz.plane.reference import ReferenceTarget
from minkref.fuzz.plane.tolerance import grown, shrunk
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.targets.answer import Answer, answered
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness
from named_cases import named

HALF = Fraction(1, 100)
FLOATS = Declaration("floats", arithmetic="float64", absolute=HALF)
FAMILIES = ("random", "holes", "comb", "thin", "cells", "touching")


def truth_of(case: Case) -> Answer:
    return ReferenceTarget("minkref:paper", "paper").sum(case)


def judged(case: Case, polygons: object) -> Outcome:
    answer = answered({"polygons": polygons}, 0.0, turned=True)
    answer.declaration = FLOATS
    outcomes = judge(case, {"minkref:paper": truth_of(case), "floats": answer}, ["floats"])
    (outcome,) = outcomes
    return outcome


def moved_by(case: Case, dx: Fraction, dy: Fraction | int) -> object:
    region = truth_of(case).region
    assert region is not None
    return json.loads(shape_text(moved(shape_of(region.set), dx, dy)))["polygons"]


def polygons_of(case: Case) -> list[dict[str, object]]:
    region = truth_of(case).region
    assert region is not None
    polygons: list[dict[str, object]] = json.loads(region.json)["polygons"]
    return polygons


@pytest.mark.parametrize("family", FAMILIES)
def test_growing_and_shrinking_are_dual(family: str) -> None:
    for index in range(8):
        region = truth_of(named(f"{family}:3:{index}")).region
        assert region is not None
        inner, outer = shrunk(region.set, HALF), grown(region.set, HALF)
        assert _core.minus(inner, region.set).is_empty
        assert _core.minus(region.set, outer).is_empty
        assert _core.minus(grown(inner, HALF), region.set).is_empty
        assert _core.minus(region.set, shrunk(outer, HALF)).is_empty


@pytest.mark.parametrize("family", FAMILIES)
def test_the_sum_moved_by_the_tolerance_is_within_and_by_more_is_not(family: str) -> None:
    for index in range(6):
        case = named(f"{family}:3:{index}")
        assert judged(case, moved_by(case, HALF, -HALF)).verdict is Verdict.PASS_WITHIN
        outcome = judged(case, moved_by(case, 3 * HALF, 0))
        assert outcome.verdict is Verdict.WRONG
        assert outcome.witness is not None and outcome.witness.tolerance == str(HALF)
        assert holds(case.P_json, case.Q_json, case.scale, outcome.witness)


def test_a_hole_larger_than_the_tolerance_may_not_be_lost() -> None:
    outer, hole = "[[0,0],[9,0],[9,9],[0,9]]", "[[3,3],[3,6],[6,6],[6,3]]"
    frame = f'{{"P":{{"polygons":[{{"outer":{outer},"holes":[{hole}]}}]}},'
    case = named(frame + '"Q":{"polygons":[{"outer":[[0,0],[1,0],[1,1],[0,1]]}]},"scale":"1"}')
    (polygon,) = polygons_of(case)
    outcome = judged(case, [{"outer": polygon["outer"], "holes": []}])
    assert outcome.reasons == (Reason.HOLE_LOST,)
    assert outcome.witness is not None and not outcome.witness.in_truth


def test_a_witness_with_a_tolerance_needs_all_of_its_square() -> None:
    case = named("random:1:0")
    x, y = polygons_of(case)[0]["outer"][0]  # type: ignore[index]
    inside = _core.decide(case.P, case.Q, case.scale, x, y)
    corner = Witness((x, y), True, tuple(inside["p"]), tuple(inside["q"]))
    assert holds(case.P_json, case.Q_json, case.scale, corner)
    assert not holds(case.P_json, case.Q_json, case.scale, replace(corner, tolerance="1/10"))
    outside = Witness((str(Fraction(x) - 1), y), False)
    assert holds(case.P_json, case.Q_json, case.scale, outside)
    assert holds(case.P_json, case.Q_json, case.scale, replace(outside, tolerance="99/100"))
    assert not holds(case.P_json, case.Q_json, case.scale, replace(outside, tolerance="1"))
