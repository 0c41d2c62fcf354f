"""Asks targets about operands with one invalid."""

from __future__ import annotations

from dataclasses import dataclass

from minkref.fuzz.invalid.invalid_case import InvalidCase
from minkref.fuzz.invalid.invalid_judgement import judge_invalid
from minkref.fuzz.targets.asking import Asking
from minkref.fuzz.verdicts.verdict import Outcome


@dataclass
class InvalidAsking(Asking):
    """Each target has to refuse."""

    def outcomes(self, names: list[str]) -> list[Outcome]:
        return [self._refused(self.case, name) for name in names]

    def _refused(self, case: InvalidCase, name: str) -> Outcome:
        if name in self.lost:
            return self.lost[name]
        target = self.target(name)
        self.begin(name)
        return judge_invalid(case, name, target.sum(case))
