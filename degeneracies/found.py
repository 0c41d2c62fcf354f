"""Cases on which `minkref verify` found libraries wrong, and published cases, with their story
(found.json). Entries hold operands as found; rings are turned as a case demands."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.degeneracies.plane.draft import Facts, Subject

NAME = "found"


@dataclass(frozen=True)
class Story(Subject):
    """A found case; `value`: the entry from found.json."""

    value: dict[str, Any]

    @property
    def why(self) -> str:
        return f"{self.value['story']} Wrong: {'; '.join(self.value['victims'])}."

    @property
    def facts(self) -> Facts:
        operands = [_core.PolygonSet.from_json(json.dumps(self.value[name])) for name in "PQ"]
        for name, operand in zip("PQ", operands, strict=True):
            operand.validate(name)
        return Facts(operands[0], operands[1], Fraction(self.value["scale"]))


FOUND: tuple[Story, ...] = tuple(
    Story(NAME, value["title"], value)
    for value in json.loads(Path(__file__).with_name("found.json").read_text(encoding="utf-8"))
)
