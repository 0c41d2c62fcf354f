"""A target asked the same question again has to answer the same, in the plane and in space: a
target that breaks or errs the second time does not pass."""

from __future__ import annotations

import zlib
from collections.abc import Callable
from dataclasses import replace

import pytest
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run import naming
from minkref.fuzz.settings import asking_about
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.targets.answer import Answer, Limits, Target
from minkref.fuzz.targets.asking import ASKED_TWICE
from minkref.fuzz.verdicts.verdict import BROKEN, Outcome, Reason, Verdict

LIMITS = Limits()
CRASHED = Answer(verdict=Verdict.CRASHED, message="it ended", signal="SIGSEGV")
REJECTED = Answer(verdict=Verdict.WRONG, message="crosses itself")


def asked_twice(family: str, seed: int) -> Case | SpaceCase:
    """A case whose right answers are checked again."""
    names = (f"{family}:{seed}:{index}" for index in range(99))
    text = next(name for name in names if zlib.crc32(name.encode()) % ASKED_TWICE == 0)
    case = naming.load(CaseName(text, "test"))
    assert isinstance(case, Case | SpaceCase)
    return case


PLANE, SPACE = ("random", "minkref:paper"), ("space-convex", "minkref:convex")


class Turns:
    """The right answer, then `second`, and so in turn."""

    most_pairs = None

    def __init__(self, right: Target, second: Callable[[Answer], Answer]) -> None:
        self.name, self.right, self.second, self.calls = "turns", right, second, 0

    def sum(self, case: Case | SpaceCase) -> Answer:
        self.calls += 1
        answer = self.right.sum(case)
        return answer if self.calls % 2 else self.second(answer)

    def close(self) -> None:
        pass


def outcome_of(
    which: tuple[str, str], second: Callable[[Answer], Answer], calls: int = 2
) -> Outcome:
    family, reference = which
    turns = Turns(ALL_TARGETS.target(reference, LIMITS), second)

    def target(name: str) -> Target:
        return turns if name == turns.name else ALL_TARGETS.target(name, LIMITS)  # type: ignore[return-value]

    case = asked_twice(family, 5)
    (outcome,) = asking_about(case, target, lambda _: None, {}, LIMITS).outcomes([turns.name])
    assert turns.calls == calls
    return outcome


@pytest.mark.parametrize("which", [PLANE, SPACE], ids=["plane", "space"])
def test_the_same_twice_passes(which: tuple[str, str]) -> None:
    assert outcome_of(which, lambda answer: answer).verdict is Verdict.PASS


@pytest.mark.parametrize("which", [PLANE, SPACE], ids=["plane", "space"])
def test_one_that_is_late_once_is_asked_a_third_time(which: tuple[str, str]) -> None:
    """A machine may stand still."""
    late = replace(CRASHED, verdict=Verdict.TIMED_OUT)
    assert outcome_of(which, lambda _: late, calls=3).verdict is Verdict.PASS


@pytest.mark.parametrize("verdict", [v for v in BROKEN if v is not Verdict.TIMED_OUT])
@pytest.mark.parametrize("which", [PLANE, SPACE], ids=["plane", "space"])
def test_one_that_breaks_the_second_time_is_charged(
    which: tuple[str, str], verdict: Verdict
) -> None:
    broken = replace(CRASHED, verdict=verdict)
    assert outcome_of(which, lambda _: broken).verdict is verdict


@pytest.mark.parametrize("which", [PLANE, SPACE], ids=["plane", "space"])
def test_one_that_rejects_the_second_time_is_wrong(which: tuple[str, str]) -> None:
    outcome = outcome_of(which, lambda _: REJECTED)
    assert outcome.verdict is Verdict.WRONG
    assert outcome.reasons == (Reason.REJECTED_VALID, Reason.NONDETERMINISTIC)
    assert outcome.witness is not None
