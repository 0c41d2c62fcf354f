"""Sets and lines to grow or erode, with known answers (degeneracies/known_offsets.json): degenerate
ones, and cases on which `minkref verify` found libraries wrong. Small, so a run begins with them.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.offsets.asked_offset import AskedOffset, named_offset
from minkref.fuzz.verdicts.verdict import Witness

FAMILY = "offsets-known"
FILE = Path(__file__).parents[2] / "degeneracies" / "known_offsets.json"


@dataclass(frozen=True)
class KnownOffset:
    """`digest`: of the canonical form (docs/disc.md); None, as the counts, with other joins and
    caps, which leave several answers right. `witness`: a wrong point of the first victim; None if
    it gave no answer."""

    title: str
    story: str
    victims: tuple[str, ...]
    asked: AskedOffset
    digest: str | None
    components: int | None
    holes: int | None
    witness: Witness | None

    @staticmethod
    def of(value: dict[str, Any]) -> KnownOffset:
        expected, witness = value.get("expected", {}), value.get("witness")
        if witness is not None:
            lists = {key: tuple(witness[key]) for key in ("point", "nearest")}
            witness = Witness(**{**witness, **lists})
        return KnownOffset(
            value["title"],
            value["story"],
            tuple(value["victims"]),
            named_offset(CaseName(value["title"], "known"), value, str(FILE)),
            expected.get("digest"),
            expected.get("components"),
            expected.get("holes"),
            witness,
        )


@cache
def known_offsets() -> tuple[KnownOffset, ...]:
    values = json.loads(FILE.read_text(encoding="utf-8"))
    return tuple(map(KnownOffset.of, values))


def known_offset(name: CaseName, index: int) -> AskedOffset:
    """NoCase beyond the last."""
    known = known_offsets()
    if index >= len(known):
        raise NoCase(f"there are {len(known)} known offsets")
    one = known[index]
    return replace(one.asked, name=name, family=FAMILY, position=one.title)
