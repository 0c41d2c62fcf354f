"""Targets asked about a part on a path."""

from __future__ import annotations

from dataclasses import dataclass

from minkref.fuzz.motion.asked_claim import asked_claim
from minkref.fuzz.motion.asked_path import AskedPath
from minkref.fuzz.motion.path_judgement import judge_path, without_claim
from minkref.fuzz.plane.event_judgement import MOST_PAIRS
from minkref.fuzz.plane.judgement import without_answer
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.targets.asking import JUDGING, Asking
from minkref.fuzz.verdicts.verdict import Outcome, Verdict


@dataclass
class PathAsking(Asking):
    """The scales at which a part passes, as each target has them."""

    def outcomes(self, names: list[str]) -> list[Outcome]:
        return [outcome for name in names for outcome in self._passing(self.case, name)]

    def _passing(self, case: AskedPath, name: str) -> list[Outcome]:
        if name in self.lost:
            return [self.lost[name]]
        target = self.target(name)
        if not isinstance(target, AdapterTarget):
            return [Outcome(name, Verdict.SKIPPED, message=f"does not declare {case.verb}")]
        pairs = case.part.vertices * case.obstacles.vertices
        if pairs > MOST_PAIRS:
            message = f"{pairs:,} pairs of vertices, more than {MOST_PAIRS:,}"
            return [Outcome(name, Verdict.SKIPPED, message=message)]
        self.begin(name)
        claimed = asked_claim(target, case)
        if JUDGING + name in self.lost:
            return [without_answer(name, self._judgeable(name, Answer()))]
        self._judging(name)
        if isinstance(claimed, Answer):
            return [without_claim(case, name, claimed)]
        claim, declared = claimed
        if declared.boundary:
            message = "of the sum of the boundaries no paths are known"
            return [Outcome(name, Verdict.SKIPPED, message=message)]
        return judge_path(case, name, claim, declared)
