"""Cases of verb `features`: a plane set, plus a disc radius for bridges."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.verbs import FEATURES
from minkref.fuzz.features.exchange import IN_BARS
from minkref.fuzz.features.feature_comparison import alive_faults, bar_faults
from minkref.fuzz.features.true_features import TrueFeatures
from minkref.fuzz.offsets.event_window import event_within
from minkref.fuzz.offsets.set_and_radius import SetAndRadius, read_set_and_radius
from minkref.oracle.features import Judge

MOST_JUDGED = 60  # vertices of a set that the second judge takes


@dataclass(frozen=True)
class AskedFeatures(SetAndRadius):
    family: str = FEATURES

    verb = FEATURES
    exchange = IN_BARS

    @cached_property
    def truth(self) -> TrueFeatures:
        return TrueFeatures(self.set)

    @cached_property
    def expected(self) -> str:
        return self.truth.answer(self.radius)

    @property
    def has_second_opinion(self) -> bool:
        return self.set.vertices <= MOST_JUDGED

    @cached_property
    def second_opinion(self) -> str | None:
        """The first difference between reference and triples judge; None without difference, or
        without region."""
        if not self.set.is_region:
            return None
        judge = Judge(self.shape)
        faults = bar_faults(judge, self.truth.found)
        if not faults:
            faults = alive_faults(judge, self.truth.found, 2 * self.radius, Counter())
        if not faults and not event_within(self.set, self.radius, self.radius):
            shape = self.truth.found.regions(str(self.radius**2))
            counts = judge.shape_counts(self.radius**2)
            if counts != (shape.components, shape.holes):
                faults = [f"components and holes: {counts}, {shape.components, shape.holes}"]
        return faults[0] if faults else None


def named_features(name: CaseName, value: dict[str, Any], where: str) -> AskedFeatures:
    """Reads a case from JSON. Refuses other values."""
    return AskedFeatures(name, *read_set_and_radius(value, FEATURES, where))
