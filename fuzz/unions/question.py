"""The union of sets, as a question of `verify`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.verbs import is_union
from minkref.fuzz.setting import ShrinkableQuestion
from minkref.fuzz.unions.asked_union import AskedUnion, named_union
from minkref.fuzz.unions.asking import UnionAsking
from minkref.fuzz.unions.known import FAMILY, known_union
from minkref.fuzz.unions.small_union import SmallUnion, smaller_unions
from minkref.fuzz.unions.union_cases import FAMILIES, drawn_union


class Unions(ShrinkableQuestion):
    """Sets in the plane to unite."""

    cases = AskedUnion
    asking = UnionAsking
    families: ClassVar[dict[str, str]] = {
        FAMILY: "sets to unite with known answers: degenerate scenes, faults of libraries",
        **FAMILIES,
    }

    def drawn(self, name: CaseName, family: str, seed: int, index: int) -> AskedUnion | None:
        if family == FAMILY:
            return known_union(name, index)
        return drawn_union(name, family, seed, index) if family in FAMILIES else None

    def named(self, name: CaseName, value: dict[str, Any], where: str) -> AskedUnion | None:
        return named_union(name, value, where) if "sets" in value else None

    def is_asked(self, literal: str) -> bool:
        return is_union(literal)

    def small_case(self, literal: str) -> SmallUnion:
        return SmallUnion.read(literal)

    def smaller(self, case: SmallUnion) -> Iterator[SmallUnion]:
        return smaller_unions(case)


UNIONS = Unions()
