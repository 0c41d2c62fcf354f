"""A member of a family of paths or traps as a case file, `path-case-v1`, and its certificate."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from minkref.certify.motion.path_certificate import PathCertificate
from minkref.certify.motion.scale_cells import document as range_document
from minkref.degeneracies.motion.draft import CONTACTS, PathFacts, PathFamily
from minkref.degeneracies.motion.generate import drawn_path
from minkref.degeneracies.plane.case_document import set_content
from minkref.degeneracies.plane.case_texts import LICENCE, CaseTexts, id_of, source_of

SCHEMA = "path-case-v1"


@dataclass(frozen=True)
class DegeneratePath(CaseTexts):
    """A case of a part, obstacles and a path, or a place."""

    family: PathFamily
    facts: PathFacts

    @classmethod
    def of(cls, family: PathFamily, seed: int, index: int) -> DegeneratePath:
        """Makes member number `index`."""
        source = source_of(family.name, seed, index, None)
        return cls(family, source, family, drawn_path(family, seed, index))

    @cached_property
    def id(self) -> str:
        return path_case_id(self.subject.name, self.facts.part, self.facts.obstacles, self.path)

    @property
    def path(self) -> list[list[str]]:
        return [[str(x), str(y)] for x, y in self.facts.path]

    @cached_property
    def document(self) -> dict[str, Any]:
        asked = "trapped" if self.family.is_trap else "valid"
        return {
            "schema": SCHEMA,
            "id": self.id,
            "title": self.subject.title,
            "R": json.loads(self.facts.part.to_json()),
            "O": json.loads(self.facts.obstacles.to_json()),
            "path": self.path,
            "tags": [self.subject.name],
            "expected": {asked: {contact: self._expected(contact) for contact in CONTACTS}},
            "degeneracy": {"at": str(self.facts.scale), "why": self.subject.why},
            "source": self.source,
            "licence": LICENCE,
            "certificate": f"{self.id}.cert.json",
        }

    @property
    def certificate(self) -> PathCertificate:
        """Proves the answers, at all scales, or up to the family's last scale."""
        made = PathCertificate(self.facts.part, self.facts.obstacles, self.facts.path)
        until = self.family.until
        last = None if until is None else until * self.facts.scale
        for contact in CONTACTS:
            (made.trap if self.family.is_trap else made.valid)(contact, None, last)
        return made

    def _expected(self, contact: str) -> list[dict[str, Any]]:
        return [range_document(one) for one in self.facts.answer(self.family.is_trap, contact)]


def path_case_id(family: str, part: Any, obstacles: Any, path: list[list[str]]) -> str:
    """The id from family, part, obstacles and path."""
    content = json.dumps([set_content(part), set_content(obstacles)])
    return id_of(family, content, [number for place in path for number in place])
