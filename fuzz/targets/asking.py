"""Asks targets about one case, and judges their answers."""

from __future__ import annotations

import zlib
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.targets.answer import Answer, Limits, Target
from minkref.fuzz.verdicts.verdict import GOOD, Outcome, Verdict

ASKED_TWICE = 8  # repeats one right answer among so many
JUDGING = "judging "  # followed by a target: the step that judges its answer


@dataclass
class Asking(ABC):
    """`begin` announces the next step; `lost` holds targets that took down a worker before."""

    case: Any  # from the setting
    target: Callable[[str], Target]
    begin: Callable[[str], None]
    lost: dict[str, Outcome]
    limits: Limits
    answers: dict[str, Answer] = field(default_factory=dict)

    @abstractmethod
    def outcomes(self, names: list[str]) -> list[Outcome]:
        """Returns one outcome for each target, and for each refuted route of ours."""

    def coverage(self) -> str | None:
        """Returns a case's coverage, for drawing mutants; None if the case showed nothing."""
        return None

    def expected(self, outcomes: list[Outcome]) -> str | None:
        """Returns the right answer for comparison, if known."""
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
        """Returns the answer; or an undecided answer, if judging it took down a worker."""
        lost = self.lost.get(JUDGING + name)
        if lost is None:
            return answer
        unread = replace(answer, region=None, solid=None, curves=None, features=None)
        return replace(unread, verdict=lost.verdict, message=lost.message)


def is_asked_again(case: AnyCase, outcome: Outcome) -> bool:
    """Whether to ask again for a stable answer: always after a wrong answer, sometimes after a
    right one."""
    if outcome.verdict is Verdict.WRONG:
        return True
    return outcome.verdict in GOOD and zlib.crc32(case.name.text.encode()) % ASKED_TWICE == 0
