"""The targets asked about one case, and what is said of their answers."""

from __future__ import annotations

import zlib
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.targets.answer import Answer, Limits, Target
from minkref.fuzz.verdicts.verdict import GOOD, Outcome, Verdict

ASKED_TWICE = 8  # one of so many right answers
JUDGING = "judging "  # and a target: the step in which its answer is looked at


@dataclass
class Asking(ABC):
    """`begin` is told what is about to run; `lost` has those that took a worker down before."""

    case: Any  # of the setting
    target: Callable[[str], Target]
    begin: Callable[[str], None]
    lost: dict[str, Outcome]
    limits: Limits
    answers: dict[str, Answer] = field(default_factory=dict)

    @abstractmethod
    def outcomes(self, names: list[str]) -> list[Outcome]:
        """One for each target, and for each of our own routes that is refuted."""

    def coverage(self) -> str | None:
        """The coverage of a case, for which mutants are drawn; None if the case showed nothing."""
        return None

    def expected(self, outcomes: list[Outcome]) -> str | None:
        """The right answer, where there was one to hold others against."""
        return None

    def _in_time(self, name: str, ask: Callable[[], Answer]) -> Answer:
        for _ in range(self.limits.tries):  # a machine may stand still
            self.begin(name)
            answer = ask()
            if answer.verdict is not Verdict.TIMED_OUT:
                break
        return answer

    def _judging(self, name: str) -> None:
        self.begin(JUDGING + name)

    def _judgeable(self, name: str, answer: Answer) -> Answer:
        """The answer; or, where a look at it took a worker down, that it is undecided."""
        lost = self.lost.get(JUDGING + name)
        if lost is None:
            return answer
        return replace(answer, region=None, solid=None, verdict=lost.verdict, message=lost.message)


def is_asked_again(case: AnyCase, outcome: Outcome) -> bool:
    """Whether it is looked at if the answer stays: always of a wrong one, at times of a right."""
    if outcome.verdict is Verdict.WRONG:
        return True
    return outcome.verdict in GOOD and zlib.crc32(case.name.text.encode()) % ASKED_TWICE == 0
