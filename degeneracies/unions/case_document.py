"""A member of a family of unions as a case file, `union-case-v1`, and its certificate."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from minkref import _core
from minkref.certify.plane.union_certificate import UnionCertificate
from minkref.degeneracies.case_texts import CaseTexts
from minkref.degeneracies.plane.case_document import set_content
from minkref.degeneracies.unions.draft import UnionFacts
from minkref.exact import digest

SHOWN = 12  # points in a case


@dataclass(frozen=True)
class DegenerateUnion(CaseTexts[UnionFacts]):
    """A case of sets to unite."""

    schema: ClassVar[str] = "union-case-v1"

    @property
    def content(self) -> str:
        return content_of(self.facts.sets)

    @staticmethod
    def scales_in(value: dict[str, Any]) -> list[str]:
        """A union has none."""
        return []

    @property
    def operands(self) -> dict[str, Any]:
        return {"sets": [json.loads(one.to_json()) for one in self.facts.sets]}

    @property
    def findings(self) -> dict[str, Any]:
        region, components, holes = self.facts.union
        told = [self.facts.edges.told(point) for point in self.facts.meetings]
        return {
            "expected": {
                "digest": digest(region.canonical_json()),
                "components": components,
                "holes": holes,
                "area": region.area(),
            },
            "degeneracy": {"points": told[:SHOWN], "why": self.subject.why},
        }

    @property
    def certificate(self) -> UnionCertificate:
        """Proves union, meetings, overlaps, and signs wrong in doubles."""
        made = UnionCertificate(self.facts.sets)
        made.union(self.facts.union[0])
        made.degeneracies()
        made.signs()
        return made


def content_of(sets: Sequence[_core.PolygonSet]) -> str:
    """Text that ignores orders of polygons and rings, and rings' first vertices."""
    return json.dumps(list(map(set_content, sets)))
