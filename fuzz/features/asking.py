"""Targets asked for the features of a set."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from minkref import _core
from minkref.errors import message_of
from minkref.fuzz.features.asked_features import AskedFeatures
from minkref.fuzz.features.judgement import doubt_about, in_doubt, judge_features
from minkref.fuzz.features.true_features import TrueFeatures
from minkref.fuzz.plane.reference import INDEX, ReferenceTarget
from minkref.fuzz.targets.adapter import ProgramTarget
from minkref.fuzz.targets.answer import Answer, skipped
from minkref.fuzz.unions.asking import UnionAsking
from minkref.fuzz.verdicts.verdict import Outcome, Verdict


@dataclass
class FeaturesAsking(UnionAsking):
    """Bars and bridges, as each target has them."""

    def expected(self, outcomes: list[Outcome]) -> str:
        case: AskedFeatures = self.case
        return case.expected

    @cached_property
    def _doubt(self) -> str | None:
        """The doubt about the truth, decided once for all targets."""
        return doubt_about(self.case)

    def _asked(self, name: str, case: AskedFeatures) -> Answer:  # type: ignore[override]
        target = self.target(name)
        if isinstance(target, ReferenceTarget) and target.route == INDEX:
            return _by_reference(case)
        if not isinstance(target, ProgramTarget):
            return skipped("does not declare features")
        return self._in_time(name, lambda: target.features(case, case.P_json, case.radius))

    def _judged(  # type: ignore[override]
        self, case: AskedFeatures, answers: dict[str, Answer], names: list[str]
    ) -> list[Outcome]:
        found: list[Outcome] = []
        for name in names:
            answer = self._judgeable(name, answers[name])
            self._judging(name)
            doubt = self._doubt if answer.text is not None else None
            found += in_doubt(name, answer, doubt) if doubt else judge_features(case, name, answer)
        return found


def _by_reference(case: AskedFeatures) -> Answer:
    """Found anew, from the set as it is sent."""
    try:
        P = _core.PolygonSet.from_json(case.P_json)
        return Answer(features=TrueFeatures(P).answer(case.radius))
    except MemoryError as error:
        return Answer(verdict=Verdict.OUT_OF_MEMORY, message=str(error))
    except Exception as error:  # noqa: BLE001 any exception is the target's fault
        return Answer(verdict=Verdict.ERRORED, message=message_of(error))
