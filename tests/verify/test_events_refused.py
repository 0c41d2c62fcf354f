"""Answers to `events` that are no list of scales, and scales and operands that the reference does
not take: each is charged to the adapter, with a reason and a witness, and the run goes on."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.event_judgement import judge_events
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.run import naming
from minkref.fuzz.settings import asking_about
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict

PROGRAM = """
import json, sys
answers = json.loads(sys.argv[1])
for line in sys.stdin:
    request = json.loads(line)
    if request["verb"] == "stop":
        break
    answer = answers.get(request["verb"], {"status": "errored", "reason": "not asked for"})
    print(json.dumps({"seq": request["seq"], **answer}), flush=True)
"""
ALL = ["plane", "non-convex", "holes", "components", "point", "segment", "empty", "rational"]
REJECTED = {"status": "rejected", "reason": "crosses itself"}
LOADED = {"status": "result"}
SQUARE = {"polygons": [{"outer": [[0, 0], [9, 0], [9, 9], [0, 9]]}]}
SEGMENT = {"polygons": [{"outer": [[0, 0], [1, 2]]}]}
EXACT = Declaration("exact")


def case_of(P: Any, Q: Any) -> Case:
    text = json.dumps({"P": P, "Q": Q, "scale": "1"})
    case = naming.load(CaseName(f"events({text})", "test"))
    assert isinstance(case, Case)
    return case


@pytest.fixture
def told(tmp_path: Path) -> Iterator[Callable[..., Outcome]]:
    """The outcome about a case's events for an adapter that gives these answers by verb."""
    program, made = tmp_path / "adapter.py", []
    program.write_text(PROGRAM, encoding="utf-8")

    def ask(answers: dict[str, Any], case: Case, **declared: Any) -> Outcome:
        hello = {"protocol": "adapter-v1", "capabilities": [*ALL, "events"], **declared}
        script = json.dumps({"hello": {"status": "result", **hello}, **answers})
        target = AdapterTarget("t", [sys.executable, str(program), script], Limits(seconds=20))
        made.append(target)
        limits = Limits()
        asked = {"t": target}
        named = lambda n: asked.get(n) or ALL_TARGETS.target(n, limits)  # noqa: E731
        asking = asking_about(case, named, lambda _: None, {}, limits)
        (outcome,) = asking.outcomes(["t"])
        return outcome

    yield ask
    for target in made:
        target.close()


@pytest.mark.parametrize("verb", ["load", "events"])
def test_valid_operands_that_are_rejected_have_a_reason_and_a_witness(
    told: Callable[..., Outcome], verb: str
) -> None:
    case = case_of(SQUARE, SQUARE)
    outcome = told({"load": LOADED, verb: REJECTED}, case)
    assert outcome.verdict is Verdict.WRONG
    assert outcome.reasons == (Reason.REJECTED_VALID,)
    assert outcome.witness is not None
    assert holds(case.P_json, case.Q_json, case.scale, outcome.witness)


@pytest.mark.parametrize("verb", ["load", "events"])
@pytest.mark.parametrize("status", ["errored", "skipped"])
def test_no_result_is_an_error_at_load_too(
    told: Callable[..., Outcome], verb: str, status: str
) -> None:
    answers = {"load": LOADED, verb: {"status": status, "reason": "no"}}
    assert told(answers, case_of(SQUARE, SQUARE)).verdict is Verdict.ERRORED


def test_scales_that_do_not_ascend_are_no_answer(told: Callable[..., Outcome]) -> None:
    answers = {"load": LOADED, "events": {"status": "result", "scales": ["3/2", "1"]}}
    outcome = told(answers, case_of(SQUARE, SQUARE))
    assert outcome.verdict is Verdict.ERRORED and "ascend" in outcome.message
    right = {"load": LOADED, "events": {"status": "result", "scales": []}}
    assert told(right, case_of(SQUARE, SQUARE)).verdict is Verdict.PASS


@pytest.mark.parametrize("scale", ["0", "-1", "1/1000", "1000000", "1", "1" + "0" * 300])
def test_an_invented_scale_may_be_any_number(scale: str) -> None:
    case = case_of(SQUARE, SQUARE)
    outcome = judge_events(case, "t", [Fraction(scale)], EXACT)
    assert outcome.reasons == (Reason.EVENT_INVENTED,)
    witness = outcome.witness
    assert witness is not None
    assert holds(case.P_json, case.Q_json, witness.scale or case.scale, witness)


def test_an_invented_scale_of_an_empty_sum_has_a_witness() -> None:
    case = case_of(SQUARE, {"polygons": []})
    outcome = judge_events(case, "t", [Fraction(1)], EXACT)
    assert outcome.reasons == (Reason.EVENT_INVENTED,)
    assert outcome.witness is not None and not outcome.witness.in_truth


def test_two_operands_without_area_are_not_asked_about(told: Callable[..., Outcome]) -> None:
    """The reference has no events for such operands."""
    answers = {"load": LOADED, "events": {"status": "result", "scales": []}}
    outcome = told(answers, case_of(SEGMENT, SEGMENT))
    assert outcome.verdict is Verdict.SKIPPED and "without area" in outcome.message
    assert told(answers, case_of(SEGMENT, SQUARE)).verdict is Verdict.PASS


def test_events_of_the_sum_of_the_boundaries_are_not_asked_about(
    told: Callable[..., Outcome],
) -> None:
    """The boundaries' events differ from the regions' events, and the reference has none."""
    answers = {"load": LOADED, "events": {"status": "result", "scales": []}}
    outcome = told(answers, case_of(SQUARE, SQUARE), sum="boundary")
    assert outcome.verdict is Verdict.SKIPPED and "boundaries" in outcome.message


def test_rejected_operands_whose_sum_is_empty_have_a_witness(told: Callable[..., Outcome]) -> None:
    """Rejection by `at` has a witness too: a run's document needs a witness for every wrong
    answer."""
    case = case_of(SQUARE, {"polygons": []})
    plain = naming.load(CaseName(case.literal, "test"))
    assert isinstance(plain, Case)
    outcome = told({"load": LOADED, "at": REJECTED}, plain)
    assert outcome.reasons == (Reason.REJECTED_VALID,)
    assert outcome.witness is not None
    assert holds(plain.P_json, plain.Q_json, plain.scale, outcome.witness)


def test_a_tolerance_beyond_all_doubles_is_no_fault_of_ours() -> None:
    huge = Declaration(
        "t", arithmetic="float64", absolute=Fraction(10) ** 1000, relative=Fraction(10) ** 1000
    )
    outcome = judge_events(case_of(SQUARE, SEGMENT), "t", [], huge)
    assert outcome.verdict is Verdict.SKIPPED
    assert "e1000" in outcome.message
