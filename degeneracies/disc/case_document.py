"""A member of a family of sums with a disc as a case file, `disc-case-v1`. Two routes agree on each
sum, and the definition gives the points nearest to the places."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar

from minkref import _core
from minkref.certify.case_text import set_digest
from minkref.certify.disc.disc_sum_certificate import DiscSumCertificate
from minkref.certify.plane.certificate import NoProof
from minkref.degeneracies.case_texts import CaseTexts
from minkref.degeneracies.disc.draft import DiscFacts
from minkref.degeneracies.plane.case_document import set_content
from minkref.disc.disc import Disc
from minkref.exact import digest

NEAR = Fraction(1, 64)  # share of the squared radius up to which events are told
SHOWN = 12  # most events told

VARIES = (
    "Rings may start anywhere, holes and components come in any order, and arcs may be cut into "
    "parts: compare sets, or canonical forms.",
    "Corners of the sum are no rational numbers, and can only be rounded; components and holes can "
    "be right all the same.",
)


class DiscRoutesDiffer(Exception):
    """Two routes to one sum do not agree: a fault of ours."""


@dataclass(frozen=True)
class DegenerateWithDisc(CaseTexts[DiscFacts]):
    """A case of a polygon set and a disc."""

    schema: ClassVar[str] = "disc-case-v1"

    @property
    def content(self) -> str:
        return json.dumps(set_content(self.facts.P))

    @staticmethod
    def scales_in(value: dict[str, Any]) -> list[str]:
        return list(value["squared_radii"])

    @property
    def operands(self) -> dict[str, Any]:
        return {
            "P": json.loads(self.facts.P.to_json()),
            "Q": f"disc:{Disc('', self.facts.squared_radius).radius}",
            "squared_radii": [str(square) for square in self.facts.squares],
        }

    @property
    def findings(self) -> dict[str, Any]:
        facts = self.facts
        return {
            "expected": [self._expected(square) for square in facts.squares],
            "degeneracy": {
                "at": str(facts.squared_radius),
                "why": self.subject.why,
                "nearest": [
                    {
                        "place": _texts(place),
                        "squared_distance": str(near.squared_distance),
                        "points": [_texts(point) for point in near.points],
                        "joints": [_texts(point) for point in near.joints],
                    }
                    for place, near in zip(facts.places, facts.near, strict=True)
                ],
                "events": facts.events,
                "events_near": facts.events_within(NEAR)[:SHOWN],
                "tight_passages": facts.passages,
                "below_at_above": [list(counts) for counts in facts.counts],
                "varies": list(VARIES),
            },
        }

    def _expected(self, square: Fraction) -> dict[str, Any]:
        """Refuses what two routes do not agree on."""
        found, again = (self.facts.sum(square, route) for route in ("definition", "paper"))
        if found != again or _counts(found) != _counts(again):
            raise DiscRoutesDiffer(f"{self.id} at {square}: definition and paper differ")
        return {
            "squared_radius": str(square),
            "digest": digest(found.canonical_json()),
            "components": found.components,
            "holes": found.holes,
            "curves": found.curves,
        }

    @property
    def certificate(self) -> DiscSumCertificate:
        """Proves the sum at the disc's radius, and how far the places are. Its case is the case
        file: raises NoProof for a set whose rings touch inside an edge, since a certificate's case
        has a vertex in both there."""
        facts = self.facts
        made = DiscSumCertificate(facts.P, facts.squared_radius)
        if set_digest(made.P) != set_digest(facts.P):
            raise NoProof("a vertex of one ring lies inside an edge of another")
        found = facts.sum(facts.squared_radius)
        made.sum((found.holes, found.canonical_json()))
        for x, y in dict.fromkeys(facts.places):
            made.point((str(x), str(y)))
        return made


def _counts(found: _core.Offset) -> tuple[int, int]:
    return found.components, found.holes


def _texts(place: tuple[Fraction, Fraction]) -> list[str]:
    return [str(c) for c in place]
