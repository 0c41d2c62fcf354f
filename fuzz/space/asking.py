"""Targets asked about a case in space."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial

from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.convex_reference import ConvexReferenceTarget
from minkref.fuzz.space.judgement import judge_in_space
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.answer import REFERENCE
from minkref.fuzz.targets.asking import Asking, is_asked_again
from minkref.fuzz.verdicts.verdict import BROKEN, GOOD, Outcome, Reason, Verdict


@dataclass
class SpaceAsking(Asking):
    """Compares each answer with known facts about the sum."""

    def outcomes(self, names: list[str]) -> list[Outcome]:
        outcomes = []
        for name in names:
            if name in self.lost:
                outcomes.append(self.lost[name])
                continue
            outcomes.append(self._once_more(self.case, self._outcome(self.case, name)))
        return outcomes

    def _outcome(self, case: SpaceCase, name: str, fresh: bool = False) -> Outcome:
        """Asks by `update` if the case wants an update, unless `fresh`."""
        target, before = self.target(name), case.before
        if before is None or fresh:
            answer = self._in_time(name, lambda: target.sum(case))
        elif isinstance(target, AdapterTarget | ConvexReferenceTarget):
            answer = self._in_time(name, partial(target.updated_sum, before, case))
        else:
            return Outcome(name, Verdict.SKIPPED, message="does not declare update")
        answer = self._judgeable(name, answer)
        self._judging(name)
        return judge_in_space(case, name, answer)

    def _once_more(self, case: SpaceCase, outcome: Outcome) -> Outcome:
        """Repeats the question after a wrong answer, and after some right answers; after a wrong
        sum by `update`, asks for a fresh sum, to see whether it is wrong as well."""
        name, wrong = outcome.target, outcome.verdict is Verdict.WRONG
        if name.startswith(REFERENCE) or not is_asked_again(case, outcome):
            return outcome
        second = self._outcome(case, name, fresh=wrong)
        if second.verdict not in (*GOOD, Verdict.WRONG):
            return second if second.verdict in BROKEN and not wrong else outcome
        if wrong is (second.verdict is Verdict.WRONG):
            return outcome
        worse = outcome if wrong else second
        drifts = wrong and case.before is not None
        reason = Reason.STATE_DRIFT if drifts else Reason.NONDETERMINISTIC
        return replace(worse, reasons=(*worse.reasons, reason))
