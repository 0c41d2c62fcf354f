"""Sets to unite with a known answer (degeneracies/known_unions.json): degenerate scenes, and cases
on which `minkref verify` found libraries wrong. Small, so a run begins with them."""

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
from minkref.fuzz.unions.asked_union import AskedUnion
from minkref.fuzz.verdicts.verdict import Witness

FAMILY = "union-known"
FILE = Path(__file__).parents[2] / "degeneracies" / "known_unions.json"


@dataclass(frozen=True)
class KnownUnion:
    """`area`, of the union: by hand, or from another program than the digest. `witness`: a point
    where the first victim is wrong; None if it gave no answer."""

    title: str
    story: str
    victims: tuple[str, ...]
    sets: tuple[_core.PolygonSet, ...]
    digest: str
    components: int
    holes: int
    area: Fraction
    witness: Witness | None

    @staticmethod
    def of(value: dict[str, Any]) -> KnownUnion:
        expected, witness = value["expected"], value.get("witness")
        if witness is not None:
            witness = Witness(**{**witness, "point": tuple(witness["point"])})
        return KnownUnion(
            value["title"],
            value["story"],
            tuple(value["victims"]),
            tuple(_core.PolygonSet.from_json(json.dumps(each)) for each in value["sets"]),
            expected["digest"],
            expected["components"],
            expected["holes"],
            Fraction(expected["area"]),
            witness,
        )


@cache
def known_unions() -> tuple[KnownUnion, ...]:
    values = json.loads(FILE.read_text(encoding="utf-8"))
    return tuple(map(KnownUnion.of, values))


def known_union(name: CaseName, index: int) -> AskedUnion:
    """NoCase beyond the last."""
    known = known_unions()
    if index >= len(known):
        raise NoCase(f"there are {len(known)} known unions")
    return AskedUnion(name, known[index].sets, FAMILY, known[index].title)
