"""Sums by the paper's programs beside CGAL's: agreements, and the culprits of differences."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

from minkref import _core
from minkref.fuzz.verdicts.verdict import Witness

AGREE, GAVE_UP, ABSENT = "agree", "gave up", "no answer of CGAL"
OURS, THEIRS, NEITHER = "the program's fault", "CGAL's fault", "not settled"
COMPARED = (AGREE, OURS, THEIRS, GAVE_UP, NEITHER)
REFUSALS = (_core.UndecidedSign, _core.BadInput, _core.LimitExceeded)


@dataclass
class Beside:
    """A program's sums beside CGAL's, counted. `shown`: each kind's first difference, with its
    deciding point."""

    counts: Counter[str] = field(default_factory=Counter)
    shown: dict[str, str] = field(default_factory=dict)

    def note(self, kind: str, case: str, witness: Witness | None = None) -> None:
        self.counts[kind] += 1
        if kind in (OURS, THEIRS, NEITHER):
            point = f" at ({', '.join(witness.point)})" if witness else ""
            self.shown.setdefault(kind, f"{case}{point}")

    def add(self, other: Beside) -> None:
        self.counts += other.counts
        self.shown = {**other.shown, **self.shown}


def least_bits(tried: dict[int, bool]) -> int | None:
    """Returns the fewest bits such that all finer tried precisions agree too; None if the finest
    disagrees."""
    least = None
    for bits in sorted(tried, reverse=True):
        if not tried[bits]:
            break
        least = bits
    return least
