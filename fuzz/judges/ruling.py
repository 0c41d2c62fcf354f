"""A judge's ruling on one case."""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from fractions import Fraction

from minkref import _core
from minkref.fuzz.plane.case import Case
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness

SCALES_OF_EVENTS = 2  # per kind and case
HIGHEST = 40
NOTHING = "nothing to compare: no event, or no point"


@dataclass
class Ruling:
    """Comparisons made, and what the judge and the reference disagree about."""

    compared: int = 0
    reasons: list[Reason] = field(default_factory=list)
    messages: list[str] = field(default_factory=list)
    witness: Witness | None = None
    skipped: str | None = None

    def compare(self, what: str, ours: object, theirs: object, *reasons: Reason) -> bool:
        """Notes a disagreement; returns whether both agree."""
        self.compared += 1
        if ours == theirs:
            return True
        self.reasons += [reason for reason in reasons if reason not in self.reasons]
        self.messages.append(
            f"{what}: the reference says {_short(ours)}, the judge {_short(theirs)}"
        )
        return False

    def outcome(self, target: str, seconds: float) -> Outcome:
        if self.skipped is not None:
            return Outcome(target, Verdict.SKIPPED, message=self.skipped, seconds=seconds)
        if not self.compared:
            return Outcome(target, Verdict.SKIPPED, message=NOTHING, seconds=seconds)
        if not self.messages:
            return Outcome(target, Verdict.PASS, seconds=seconds)
        return Outcome(
            target,
            Verdict.WRONG,
            tuple(self.reasons),
            message="; ".join(self.messages[:3]),
            seconds=seconds,
            witness=self.witness,
        )


def _short(value: object) -> str:
    text = str(value)
    return text if len(text) <= 300 else text[:297] + "..."


def dice_of(case: Case) -> random.Random:
    """The same for every judge and every run of a case."""
    return random.Random(f"minkref judges {case.name.text}")


def event_scales(case: Case, dynamic: _core.DynamicSum) -> list[str]:
    """Some scales of boundary events and some of the arrangement's other events."""
    dice = dice_of(case)
    boundary = sorted({row[0] for row in dynamic.boundary_events()}, key=Fraction)
    others = [scale for scale, _ in dynamic.event_scales() if scale not in set(boundary)]
    chosen = {*_some(dice, boundary), *_some(dice, others)}
    return sorted(chosen, key=Fraction)


def _some(dice: random.Random, scales: list[str]) -> list[str]:
    return dice.sample(scales, min(SCALES_OF_EVENTS, len(scales)))


def scales_of(case: Case, dynamic: _core.DynamicSum) -> list[str]:
    """The case's scale, a random scale, and some scales of events."""
    dice = dice_of(case)
    at_random = str(Fraction(dice.randint(1, 6 * HIGHEST), dice.randint(1, HIGHEST)))
    return list(dict.fromkeys([case.scale, at_random, *event_scales(case, dynamic)]))
