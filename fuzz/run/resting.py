"""Stops asking targets that do not answer.

A time-out costs twice a call's limit. A target that left MOST_TIME_OUTS successive cases that it
takes unanswered rests for the rest of the run. Results are examined in the order of cases, and a
resting target's answer to a later case, which another worker had begun already, is left out: who
rests, and from which case on, depends on the cases alone.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field, replace

from minkref.fuzz.run.catalogue import is_judge
from minkref.fuzz.run.worker import CaseResult, all_skip
from minkref.fuzz.verdicts.verdict import Outcome, Verdict

MOST_TIME_OUTS = 3
RESTS = f"not asked: {MOST_TIME_OUTS} cases in a row had no answer"


@dataclass
class Resting:
    """`since`: the case after which each target rests, by target name."""

    targets: list[str]
    since: dict[str, str] = field(default_factory=dict)
    _in_a_row: Counter[str] = field(default_factory=Counter)

    @property
    def is_over(self) -> bool:
        """Nobody is left to be asked."""
        return bool(self.targets) and self.since.keys() >= set(self.targets)

    def applied(self, result: CaseResult) -> CaseResult:
        """Drops outcomes for resting targets; a generated case that no other target takes becomes a
        case that no target takes."""
        if not self.since or result.absent is not None:
            return result
        kept = [outcome for outcome in result.outcomes if outcome.target not in self.since]
        judged = any(map(is_judge, self.targets))
        if result.generated and not judged and all_skip(kept):
            return replace(result, untaken=kept[0].message)
        rests = [rest(name) for name in self.targets if name in self.since]
        return replace(result, outcomes=[*kept, *rests])

    def note(self, result: CaseResult) -> None:
        """Counts the time-outs in an applied result."""
        for outcome in result.outcomes:
            if outcome.verdict is Verdict.SKIPPED or outcome.target not in self.targets:
                continue
            if outcome.verdict is not Verdict.TIMED_OUT:
                self._in_a_row[outcome.target] = 0
                continue
            self._in_a_row[outcome.target] += 1
            if self._in_a_row[outcome.target] >= MOST_TIME_OUTS:
                self.since.setdefault(outcome.target, result.name.text)


def rest(target: str) -> Outcome:
    return Outcome(target, Verdict.SKIPPED, message=RESTS)
