"""Concave features of a set under a growing disc, as a question of `verify`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.verbs import FEATURES as VERB
from minkref.fuzz.cases.verbs import is_features
from minkref.fuzz.features.asked_features import AskedFeatures, named_features
from minkref.fuzz.features.asking import FeaturesAsking
from minkref.fuzz.features.feature_cases import FAMILIES, drawn_features
from minkref.fuzz.offsets.small_offset import SmallOffset, smaller_offsets
from minkref.fuzz.setting import ShrinkableQuestion


class Features(ShrinkableQuestion):
    """Plane sets, asked for bays, corridors, holes by size."""

    cases = AskedFeatures
    asking = FeaturesAsking
    families: ClassVar[dict[str, str]] = FAMILIES

    def drawn(self, name: CaseName, family: str, seed: int, index: int) -> AskedFeatures | None:
        return drawn_features(name, family, seed, index) if family in FAMILIES else None

    def named(self, name: CaseName, value: dict[str, Any], where: str) -> AskedFeatures | None:
        return named_features(name, value, where) if VERB in value else None

    def is_asked(self, literal: str) -> bool:
        return is_features(literal)

    def small_case(self, literal: str) -> SmallOffset:
        return SmallOffset.read(literal, VERB)

    def smaller(self, case: SmallOffset) -> Iterator[SmallOffset]:
        return smaller_offsets(case)


FEATURES = Features()
