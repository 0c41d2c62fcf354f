"""A member of a family of paths or traps as a case file, `path-case-v1`, and its certificate."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, ClassVar

from minkref.certify.motion.path_certificate import PathCertificate
from minkref.certify.motion.scale_cells import document as range_document
from minkref.degeneracies.case_texts import CaseTexts
from minkref.degeneracies.motion.draft import CONTACTS, PathFacts, PathFamily
from minkref.degeneracies.plane.case_document import content_of


@dataclass(frozen=True)
class DegeneratePath(CaseTexts[PathFacts]):
    """A case of a part, obstacles and a path, or a place."""

    subject: PathFamily
    schema: ClassVar[str] = "path-case-v1"

    @property
    def content(self) -> str:
        return content_of(self.facts.part, self.facts.obstacles)

    @staticmethod
    def scales_in(value: dict[str, Any]) -> list[str]:
        return [number for place in value["path"] for number in place]

    @property
    def operands(self) -> dict[str, Any]:
        return {
            "R": json.loads(self.facts.part.to_json()),
            "O": json.loads(self.facts.obstacles.to_json()),
            "path": [[str(x), str(y)] for x, y in self.facts.path],
        }

    @property
    def findings(self) -> dict[str, Any]:
        asked = "trapped" if self.subject.is_trap else "valid"
        return {
            "expected": {asked: {contact: self._expected(contact) for contact in CONTACTS}},
            "degeneracy": {"at": str(self.facts.scale), "why": self.subject.why},
        }

    @property
    def certificate(self) -> PathCertificate:
        """Proves the answers, at all scales, or up to the family's last scale."""
        made = PathCertificate(self.facts.part, self.facts.obstacles, self.facts.path)
        until = self.subject.until
        last = None if until is None else until * self.facts.scale
        for contact in CONTACTS:
            (made.trap if self.subject.is_trap else made.valid)(contact, None, last)
        return made

    def _expected(self, contact: str) -> list[dict[str, Any]]:
        return [range_document(one) for one in self.facts.answer(self.subject.is_trap, contact)]
