"""How two results differ: reasons, and witnesses against whichever is wrong."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

import pytest
from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.geometry.region import region_of_rings
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.comparison import SumOf, settle
from minkref.fuzz.plane.judgement import judge
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.verdicts.verdict import Reason, Verdict


def ring(xmin: str, ymin: str, xmax: str, ymax: str) -> list[list[str]]:
    return [[x, y] for x, y in ((xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax))]


def frame(
    *holes: tuple[str, str, str, str], outer: tuple[str, ...] = ("0", "0", "11", "11")
) -> Any:
    return {"polygons": [{"outer": ring(*outer), "holes": [ring(*h)[::-1] for h in holes]}]}


HOLE = ("3", "3", "8", "8")
TRUTH = frame(HOLE)  # of [0,10]^2 less (2,8)^2, plus [0,1]^2


@pytest.fixture
def case() -> Case:
    P = _core.PolygonSet.from_json(
        json.dumps(frame(("2", "2", "8", "8"), outer=("0", "0", "10", "10")))
    )
    Q = _core.PolygonSet.from_json(json.dumps(frame(outer=("0", "0", "1", "1"))))
    return Case(CaseName("frame", "test"), P, Q, "1", "P", "Q")


WITH_FAR = {"polygons": TRUTH["polygons"] + frame(outer=("20", "20", "21", "21"))["polygons"]}

DIFFERENT = [
    (frame(), [Reason.HOLE_LOST]),
    (frame(("4", "4", "7", "7")), [Reason.EXTRA]),
    (frame(("2", "2", "9", "9")), [Reason.MISSING]),
    (frame(("4", "4", "9", "7")), [Reason.EXTRA, Reason.MISSING]),
    (frame(HOLE, ("1", "1", "2", "2")), [Reason.HOLE_INVENTED]),
    (frame(HOLE, outer=("0", "0", "12", "11")), [Reason.EXTRA]),
    (frame(outer=("0", "0", "12", "11")), [Reason.HOLE_LOST, Reason.EXTRA]),
    (WITH_FAR, [Reason.COMPONENT]),
    ({"polygons": []}, [Reason.COMPONENT]),
]


@pytest.mark.parametrize(("rings", "reasons"), DIFFERENT, ids=lambda v: str(v)[-30:])
def test_difference_is_named_and_proven(case: Case, rings: Any, reasons: list[Reason]) -> None:
    settled = settle(SumOf(case), region_of_rings(TRUTH), region_of_rings(rings))
    assert settled.truth is None
    assert settled.reasons == reasons
    assert settled.claim is not None
    assert holds(case.P_json, case.Q_json, case.scale, settled.claim)


@pytest.mark.parametrize(("rings", "reasons"), DIFFERENT, ids=lambda v: str(v)[-30:])
def test_wrong_reference_is_the_one_that_is_refuted(
    case: Case, rings: Any, reasons: list[Reason]
) -> None:
    settled = settle(SumOf(case), region_of_rings(rings), region_of_rings(TRUTH))
    assert settled.claim is None
    assert settled.truth is not None
    assert holds(case.P_json, case.Q_json, case.scale, settled.truth)


def verdicts(case: Case, **rings: Any) -> dict[str, Any]:
    answers = {
        name.replace("_", ":"): Answer(region_of_rings(value)) for name, value in rings.items()
    }
    return {outcome.target: outcome for outcome in judge(case, answers, list(answers))}


def test_finding_is_against_the_reference_where_the_reference_is_wrong(case: Case) -> None:
    found = verdicts(case, minkref_paper=frame(), minkref_winding=TRUTH, other=TRUTH)
    assert found["minkref:paper"].verdict is Verdict.WRONG
    assert found["minkref:paper"].witness.in_truth is False
    assert found["minkref:winding"].verdict is Verdict.PASS
    assert found["other"].verdict is Verdict.PASS


def test_wrong_reference_is_no_measure_for_others(case: Case) -> None:
    found = verdicts(case, minkref_paper=frame(), other=TRUTH)
    assert found["minkref:paper"].verdict is Verdict.WRONG
    assert found["other"].verdict is Verdict.UNDECIDED


def test_wrong_route_is_reported_even_if_it_was_not_asked_for(case: Case) -> None:
    answers = {
        "minkref:paper": Answer(region_of_rings(frame())),
        "other": Answer(region_of_rings(TRUTH)),
    }
    outcomes = judge(case, answers, ["other"])
    assert {outcome.target for outcome in outcomes} == {"minkref:paper", "other"}


def test_rings_that_cover_a_part_twice_are_self_intersecting(case: Case) -> None:
    twice = {"polygons": TRUTH["polygons"] + frame(outer=("0", "0", "1", "1"))["polygons"]}
    outcome = verdicts(case, minkref_paper=TRUTH, other=twice)["other"]
    assert (outcome.verdict, outcome.reasons) == (Verdict.WRONG, (Reason.SELF_INTERSECTING,))
    x, y = (Fraction(number) for number in outcome.witness.point)
    assert 0 < x < 1 and 0 < y < 1


def test_ring_of_two_vertices_is_not_closed(case: Case) -> None:
    stub = {"outer": [["0", "0"], ["5", "0"]], "holes": []}
    outcome = verdicts(case, minkref_paper=TRUTH, other={"polygons": [*TRUTH["polygons"], stub]})[
        "other"
    ]
    assert (outcome.verdict, outcome.reasons) == (Verdict.WRONG, (Reason.NOT_CLOSED,))


def test_touching_pieces_and_a_ring_with_a_pinch_are_the_same_set(case: Case) -> None:
    """A square with a diamond hole that touches two of its sides, as outer and hole or as two
    outers."""
    square = [["0", "0"], ["4", "0"], ["4", "4"], ["0", "4"]]
    diamond = [["0", "2"], ["2", "3"], ["4", "2"], ["2", "1"]]
    low = [["0", "0"], ["4", "0"], ["4", "2"], ["2", "1"], ["0", "2"]]
    high = [["0", "2"], ["2", "3"], ["4", "2"], ["4", "4"], ["0", "4"]]
    one = region_of_rings({"polygons": [{"outer": square, "holes": [diamond]}]})
    two = region_of_rings({"polygons": [{"outer": low, "holes": []}, {"outer": high, "holes": []}]})
    assert one.digest == two.digest
    assert (one.components, two.components) == (2, 2)


def test_minus_is_the_difference_of_closed_sets() -> None:
    truth = region_of_rings(TRUTH).set
    left = _core.minus(truth, region_of_rings(frame(outer=("0", "0", "11", "3"))).set)
    assert left.area() == str(121 - 25 - 33)
    assert _core.minus(truth, truth).is_empty
