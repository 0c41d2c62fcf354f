"""Pairs in space on which `minkref verify` found libraries wrong, with their story
(degeneracies/found_in_space.json): every target gets them first, since they are small."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import scale_of
from minkref.fuzz.space.pair import SpacePair
from minkref.fuzz.verdicts.verdict import Witness

FAMILY = "space-found"
FILE = Path(__file__).parents[2] / "degeneracies" / "found_in_space.json"


@dataclass(frozen=True)
class FoundInSpace:
    """`witness` proves the first victim's fault."""

    title: str
    victims: tuple[str, ...]
    story: str
    pair: SpacePair
    witness: Witness

    @staticmethod
    def of(value: dict[str, Any]) -> FoundInSpace:
        P, Q = (Polyhedron.from_document(value[name]) for name in "PQ")
        witness: dict[str, Any] = {
            key: tuple(part) if isinstance(part, list) else part
            for key, part in value["witness"].items()
        }
        return FoundInSpace(
            value["title"],
            tuple(value["victims"]),
            value["story"],
            SpacePair(P, Q, scale_of(value["scale"]), FAMILY),
            Witness(**witness),
        )


@cache
def found_in_space() -> tuple[FoundInSpace, ...]:
    values = json.loads(FILE.read_text(encoding="utf-8"))
    return tuple(FoundInSpace.of(value) for value in values)


def found_pair(index: int) -> SpacePair:
    """NoCase beyond the last."""
    known = found_in_space()
    if index >= len(known):
        raise NoCase(f"there are {len(known)} found cases in space")
    return known[index].pair
