"""A set grown or eroded by a disc, as a question of `verify`."""

from __future__ import annotations

import json
from collections.abc import Container, Iterator
from typing import Any, ClassVar

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.verbs import INSET, LINES, OFFSET, SHARP_OFFSET, is_offset
from minkref.fuzz.offsets.asked_offset import AskedOffset, named_offset
from minkref.fuzz.offsets.asking import OffsetAsking
from minkref.fuzz.offsets.join_cases import FAMILIES as OF_JOINS
from minkref.fuzz.offsets.join_cases import drawn_joins
from minkref.fuzz.offsets.known import FAMILY, known_offset
from minkref.fuzz.offsets.line_cases import FAMILIES as OF_LINES
from minkref.fuzz.offsets.line_cases import drawn_lines
from minkref.fuzz.offsets.manner import MANNERS
from minkref.fuzz.offsets.offset_cases import FAMILIES, INWARD, drawn_offset
from minkref.fuzz.offsets.sharp_cases import FAMILIES as OF_SHARP
from minkref.fuzz.offsets.sharp_cases import drawn_sharp
from minkref.fuzz.offsets.small_lines import SmallLines, smaller_lines
from minkref.fuzz.offsets.small_offset import SmallOffset, smaller_offsets
from minkref.fuzz.setting import ShrinkableQuestion


class Offsets(ShrinkableQuestion):
    """Sets in the plane to grow or erode by a disc."""

    cases = AskedOffset
    asking = OffsetAsking
    families: ClassVar[dict[str, str]] = {
        FAMILY: "sets to grow or erode, known answers: degenerate sets, faults of libraries",
        **FAMILIES,
        **INWARD,
        **OF_LINES,
        **OF_JOINS,
        **OF_SHARP,
    }

    def drawn(self, name: CaseName, family: str, seed: int, index: int) -> AskedOffset | None:
        if family == FAMILY:
            return known_offset(name, index)
        if family in OF_LINES:
            return drawn_lines(name, family, seed, index)
        if family in OF_JOINS:
            return drawn_joins(name, family, seed, index)
        if family in OF_SHARP:
            return drawn_sharp(name, family, seed, index)
        known = family in FAMILIES or family in INWARD
        return drawn_offset(name, family, seed, index) if known else None

    def families_for(self, able: Container[str]) -> tuple[str, ...]:
        """Names the generators whose cases ask for capabilities among these."""
        sharp = tuple(OF_SHARP) if SHARP_OFFSET in able else ()
        if OFFSET not in able:
            return sharp
        left_out = {INSET: INWARD, LINES: OF_LINES, SHARP_OFFSET: OF_SHARP}
        out = {name for word, names in left_out.items() if word not in able for name in names}
        others = (word for word in MANNERS if word != SHARP_OFFSET)
        out |= set() if any(word in able for word in others) else set(OF_JOINS)
        return tuple(name for name in self.families if name not in out)

    def named(self, name: CaseName, value: dict[str, Any], where: str) -> AskedOffset | None:
        return named_offset(name, value, where) if "offset" in value else None

    def is_asked(self, literal: str) -> bool:
        return is_offset(literal)

    def small_case(self, literal: str) -> SmallOffset | SmallLines:
        is_line = "lines" in json.loads(literal)[OFFSET]
        return SmallLines.read(literal) if is_line else SmallOffset.read(literal)

    def smaller(self, case: SmallOffset | SmallLines) -> Iterator[SmallOffset | SmallLines]:
        if isinstance(case, SmallLines):
            return smaller_lines(case)
        return smaller_offsets(case)


OFFSETS = Offsets()
