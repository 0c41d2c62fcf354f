"""Targets asked to unite sets."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from minkref.fuzz.plane.asking import PlaneAsking
from minkref.fuzz.targets.adapter import ProgramTarget
from minkref.fuzz.targets.answer import Answer, skipped
from minkref.fuzz.unions.asked_union import AskedUnion
from minkref.fuzz.unions.judgement import doubt_about, in_doubt, judge_union
from minkref.fuzz.verdicts.verdict import Outcome


@dataclass
class UnionAsking(PlaneAsking):
    """The union, as each target has it."""

    def outcomes(self, names: list[str]) -> list[Outcome]:
        for name in names:
            self.answers[name] = self._ask(name, self.case)
        judged = self._judged(self.case, self.answers, names)
        return [self._once_more(self.case, outcome) for outcome in judged]

    def coverage(self) -> None:
        """No mutants are drawn."""

    def expected(self, outcomes: list[Outcome]) -> str:
        case: AskedUnion = self.case
        return case.expected.json

    @cached_property
    def _doubt(self) -> str | None:
        """The doubt about the truth, decided once for all targets."""
        return doubt_about(self.case)

    def _ask(self, name: str, case: Any) -> Answer:
        if name in self.lost:
            lost = self.lost[name]
            return Answer(
                verdict=lost.verdict, message=lost.message, signal=lost.signal, seconds=lost.seconds
            )
        return self._asked(name, case)

    def _asked(self, name: str, case: AskedUnion) -> Answer:
        target = self.target(name)
        if not isinstance(target, ProgramTarget):
            return skipped("does not declare union")
        return self._in_time(name, lambda: target.union(case, case.texts))

    def _judged(  # type: ignore[override]
        self, case: AskedUnion, answers: dict[str, Answer], names: list[str]
    ) -> list[Outcome]:
        found: list[Outcome] = []
        for name in names:
            answer = self._judgeable(name, answers[name])
            self._judging(name)
            doubt = self._doubt if answer.region is not None else None
            found += in_doubt(name, answer, doubt) if doubt else judge_union(case, name, answer)
        return found
