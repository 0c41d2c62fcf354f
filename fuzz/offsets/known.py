"""Sets to grow or erode with a known answer (degeneracies/known_offsets.json): degenerate sets, and
cases on which `minkref verify` found libraries wrong. Small, so a run begins with them."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.verdicts.verdict import Witness

FAMILY = "offsets-known"
FILE = Path(__file__).parents[2] / "degeneracies" / "known_offsets.json"


@dataclass(frozen=True)
class KnownOffset:
    """`radius`: below 0 to erode. `digest`: of the canonical form (docs/disc.md). `witness`: a
    point where the first victim is wrong; None if it gave no answer."""

    title: str
    story: str
    victims: tuple[str, ...]
    set: _core.PolygonSet
    radius: Fraction
    digest: str
    components: int
    holes: int
    witness: Witness | None

    @staticmethod
    def of(value: dict[str, Any]) -> KnownOffset:
        expected, witness = value["expected"], value.get("witness")
        if witness is not None:
            lists = {key: tuple(witness[key]) for key in ("point", "nearest")}
            witness = Witness(**{**witness, **lists})
        return KnownOffset(
            value["title"],
            value["story"],
            tuple(value["victims"]),
            _core.PolygonSet.from_json(json.dumps(value["offset"])),
            Fraction(value["radius"]),
            expected["digest"],
            expected["components"],
            expected["holes"],
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
    return AskedOffset(name, one.set, one.radius, FAMILY, one.title)
