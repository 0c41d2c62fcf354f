"""Verdicts counted with honest denominators: passes among judged cases; skipped cases apart."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field

from minkref.fuzz.run.runner import Cell
from minkref.fuzz.verdicts.verdict import GOOD, Verdict
from minkref.output.terminal import escaped
from minkref.reports.conformance.run_words import general_reason
from minkref.reports.conformance.words import SIGNS

MOST_REASONS = 12
_APART = (*GOOD, Verdict.SKIPPED)
# The worst last.
_SEVERITY = (
    Verdict.UNDECIDED,
    Verdict.GAVE_UP,
    Verdict.KNOWN,
    Verdict.ERRORED,
    Verdict.TIMED_OUT,
    Verdict.OUT_OF_MEMORY,
    Verdict.CRASHED,
    Verdict.WRONG,
)


@dataclass
class Counts:
    """Counts for one target on one or more families. `cases` were run; `asked` cases have a
    verdict, including `skipped` cases."""

    cases: int = 0
    verdicts: Counter[str] = field(default_factory=Counter)
    reasons: Counter[str] = field(default_factory=Counter)
    seconds: float = 0.0

    def add(self, cell: Cell | None, cases: int) -> None:
        self.cases += cases
        if cell is None:
            return
        self.verdicts.update(cell.verdicts)
        for message, count in cell.skips.items():
            self.reasons[general_reason(message)] += count
        self.seconds += cell.seconds

    @property
    def asked(self) -> int:
        return sum(self.verdicts.values())

    @property
    def skipped(self) -> int:
        return self.verdicts[Verdict.SKIPPED]

    @property
    def judged(self) -> int:
        return self.asked - self.skipped

    @property
    def right(self) -> int:
        return sum(self.verdicts[verdict] for verdict in GOOD)

    @property
    def within(self) -> int:
        return self.verdicts[Verdict.PASS_WITHIN]

    @property
    def not_asked(self) -> int:
        """Cases without a verdict: the target is a check of the reference, or a route of ours that
        only steps in for another."""
        return max(self.cases - self.asked, 0)

    @property
    def amiss(self) -> list[tuple[str, int, str]]:
        """Verdict, number, sign: the most serious first."""
        return [
            (str(verdict), self.verdicts[verdict], SIGNS[verdict])
            for verdict in Verdict
            if verdict not in _APART and self.verdicts[verdict]
        ]

    @property
    def worst(self) -> str:
        """The cell's class: its worst verdict, `good` or `skipped`."""
        if not self.judged:
            return "skipped"
        found = [str(verdict) for verdict in _SEVERITY if self.verdicts[verdict]]
        return found[-1] if found else "good"

    @property
    def fraction(self) -> str:
        """`8/9`: passes among judged cases. A dash if nothing was judged."""
        return f"{self.right:,}/{self.judged:,}" if self.judged else "–"

    @property
    def why_skipped(self) -> list[tuple[str, int]]:
        """Reasons, most frequent first; rare reasons share a line."""
        found = [(escaped(reason), count) for reason, count in self.reasons.most_common()]
        rest = found[MOST_REASONS:]
        if rest:
            others = (f"{len(rest):,} other reasons", sum(count for _, count in rest))
            found = [*found[:MOST_REASONS], others]
        return found


def total(cells: Iterable[tuple[Cell | None, int]]) -> Counts:
    counts = Counts()
    for cell, cases in cells:
        counts.add(cell, cases)
    return counts
