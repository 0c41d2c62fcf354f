"""A set grown or eroded by a disc, as a question of `verify`."""

from __future__ import annotations

from collections.abc import Container, Iterator
from typing import Any, ClassVar

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.verbs import INSET, OFFSET, is_offset
from minkref.fuzz.offsets.asked_offset import AskedOffset, named_offset
from minkref.fuzz.offsets.asking import OffsetAsking
from minkref.fuzz.offsets.known import FAMILY, known_offset
from minkref.fuzz.offsets.offset_cases import FAMILIES, INWARD, drawn_offset
from minkref.fuzz.offsets.small_offset import SmallOffset, smaller_offsets
from minkref.fuzz.setting import ShrinkableQuestion


class Offsets(ShrinkableQuestion):
    """Sets in the plane to grow or erode by a disc."""

    cases = AskedOffset
    asking = OffsetAsking
    families: ClassVar[dict[str, str]] = {
        FAMILY: "sets to grow with known answers: degenerate sets, faults of libraries",
        **FAMILIES,
        **INWARD,
    }

    def drawn(self, name: CaseName, family: str, seed: int, index: int) -> AskedOffset | None:
        if family == FAMILY:
            return known_offset(name, index)
        known = family in FAMILIES or family in INWARD
        return drawn_offset(name, family, seed, index) if known else None

    def families_for(self, able: Container[str]) -> tuple[str, ...]:
        """Names the generators whose cases ask for capabilities among these."""
        if OFFSET not in able:
            return ()
        return tuple(name for name in self.families if name not in INWARD or INSET in able)

    def named(self, name: CaseName, value: dict[str, Any], where: str) -> AskedOffset | None:
        return named_offset(name, value, where) if "offset" in value else None

    def is_asked(self, literal: str) -> bool:
        return is_offset(literal)

    def small_case(self, literal: str) -> SmallOffset:
        return SmallOffset.read(literal)

    def smaller(self, case: SmallOffset) -> Iterator[SmallOffset]:
        return smaller_offsets(case)


OFFSETS = Offsets()
