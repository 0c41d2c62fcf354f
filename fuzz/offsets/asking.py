"""Targets asked to grow or erode a set by a disc."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

from minkref.fuzz.cases.verbs import LINES
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.curves import form_of
from minkref.fuzz.offsets.join_judgement import expected_text
from minkref.fuzz.offsets.judgement import doubt_about, in_doubt, judge_offset
from minkref.fuzz.plane.reference import INDEX, ReferenceTarget
from minkref.fuzz.targets.adapter import ProgramTarget
from minkref.fuzz.targets.answer import Answer, skipped
from minkref.fuzz.unions.asking import UnionAsking
from minkref.fuzz.verdicts.verdict import Outcome


@dataclass
class OffsetAsking(UnionAsking):
    """The grown set, as each target has it: curves, or polygons near them."""

    def expected(self, outcomes: list[Outcome]) -> str:
        case: AskedOffset = self.case
        return case.form if case.manner.is_round else expected_text(case)

    @cached_property
    def _doubt(self) -> str | None:
        """The doubt about the truth, decided once for all targets."""
        return doubt_about(self.case)

    def _asked(self, name: str, case: AskedOffset) -> Answer:  # type: ignore[override]
        target = self.target(name)
        if isinstance(target, ReferenceTarget):
            if not case.manner.is_round or (case.lines and target.route == INDEX):
                return skipped("does not declare " + ", ".join(sorted(case.manner.needs | {LINES})))
            if case.is_nothing:
                return Answer(curves=case.form)
            answer = target.offset(case.set, str(case.radius**2), case.inward)
            if answer.curves is None:
                return answer
            return replace(answer, curves=form_of(answer.curves))
        if not isinstance(target, ProgramTarget):
            return skipped("does not declare offset")
        return self._in_time(
            name, lambda: target.offset(case, case.asked_json, case.radius, case.manner.members)
        )

    def _judged(  # type: ignore[override]
        self, case: AskedOffset, answers: dict[str, Answer], names: list[str]
    ) -> list[Outcome]:
        found: list[Outcome] = []
        for name in names:
            answer = self._judgeable(name, answers[name])
            self._judging(name)
            doubt = self._doubt if answer.text is not None else None
            found += in_doubt(name, answer, doubt) if doubt else judge_offset(case, name, answer)
        return found
