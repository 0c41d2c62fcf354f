"""Cases on which `minkref verify` has found libraries wrong, and published ones, with their story
(found.json). Operands are given as they were found; they are turned as a case demands."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.degeneracies.draft import Draft, Facts, Family

NAME = "found"


@dataclass(frozen=True)
class Story(Family):
    """A family of one."""

    story: str
    value: dict[str, Any]

    @property
    def why(self) -> str:
        return self.story

    @property
    def facts(self) -> Facts:
        operands = [_core.PolygonSet.from_json(json.dumps(self.value[name])) for name in "PQ"]
        for name, operand in zip("PQ", operands, strict=True):
            operand.validate(name)
        return Facts(operands[0], operands[1], Fraction(self.value["scale"]))


def _story(value: dict[str, Any]) -> Story:
    def draw(*_: object) -> Draft:
        raise NotImplementedError("a case that was found is not drawn")

    story = f"{value['story']} Wrong: {'; '.join(value['victims'])}."
    flags = tuple(value["flags"])
    return Story(NAME, value["title"], flags, draw, lambda facts: True, story, value)


FOUND: tuple[Story, ...] = tuple(
    _story(value)
    for value in json.loads(Path(__file__).with_name("found.json").read_text(encoding="utf-8"))
)
