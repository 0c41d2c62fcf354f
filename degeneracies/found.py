"""Cases on which `minkref verify` found libraries wrong, and published cases, with their story
(found.json). Entries hold operands as found; rings are turned as a case demands."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref.degeneracies.family import Subject
from minkref.degeneracies.plane.case_document import Degenerate
from minkref.degeneracies.plane.draft import Facts, sets_in

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
        P, Q = sets_in(self.value, "PQ")
        return Facts(P, Q, Fraction(self.value["scale"]))

    @property
    def case(self) -> Degenerate:
        return Degenerate(self, self.value["source"], self.facts)


FOUND: tuple[Story, ...] = tuple(
    Story(NAME, value["title"], value)
    for value in json.loads(Path(__file__).with_name("found.json").read_text(encoding="utf-8"))
)
