"""The laws of the sum as tests for a target: the reference keeps each law, and each breach is
found."""

from __future__ import annotations

import pytest
from minkref.fuzz.geometry.plane import moved, read_shape
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.families.drawing import shape_text
from minkref.fuzz.plane.law_judgement import judge_law
from minkref.fuzz.plane.laws import LAWS
from minkref.fuzz.plane.reference import ReferenceTarget
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.targets.answer import Answer, answered
from minkref.fuzz.verdicts.verdict import Outcome, Verdict
from named_cases import named

SOUND = ReferenceTarget("minkref:paper", "paper")
FAMILIES = ("random", "holes", "comb", "touching", "degenerate", "rational", "offset")


def shifted(case: Case, by: int = 1) -> Answer:
    """A target's sum, moved if P is not at the origin: this breaks translation."""
    answer = SOUND.sum(case)
    assert answer.region is not None
    return answered(shape_text(moved(read_shape(answer.region.json), by, 0)), 0.0)


def judged(law: str, case: Case, answer: Answer) -> Outcome:
    assert case.law is not None
    base = case.law[1]
    before = None if LAWS[law].constant else SOUND.sum(base)
    (outcome,) = judge_law(law, "target", base, before, case, answer, _no_truth)
    return outcome


def _no_truth() -> list[Outcome]:
    raise AssertionError("an exact target is asked for no expected value")


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("family", FAMILIES)
def test_the_reference_keeps_every_law(law: str, family: str) -> None:
    for index in range(6):
        case = named(f"{law}({family}:7:{index})")
        assert judged(law, case, SOUND.sum(case)).verdict in (Verdict.PASS, Verdict.SKIPPED)


@pytest.mark.parametrize("law", [law for law in LAWS if law not in ("empty",)])
def test_a_sum_that_is_moved_breaks_every_law(law: str) -> None:
    case = named(f"{law}(holes:7:3)")
    outcome = judged(law, case, shifted(case))
    assert outcome.verdict is Verdict.WRONG
    assert outcome.witness is not None
    assert LAWS[law].title in outcome.message
    assert holds(case.P_json, case.Q_json, case.scale, outcome.witness)


def test_a_result_for_the_empty_set_breaks_its_law() -> None:
    case = named("empty(random:7:1)")
    square = {"polygons": [{"outer": [[0, 0], [1, 0], [1, 1], [0, 1]], "holes": []}]}
    outcome = judged("empty", case, answered(square, 0.0))
    assert outcome.verdict is Verdict.WRONG
    assert outcome.witness is not None and not outcome.witness.in_truth


def test_monotonicity_allows_more_and_not_less() -> None:
    case = named("monotonicity(holes:7:4)")
    assert judged("monotonicity", case, SOUND.sum(case)).verdict is Verdict.PASS
    nothing = answered({"polygons": []}, 0.0)
    assert judged("monotonicity", case, nothing).verdict is Verdict.WRONG
