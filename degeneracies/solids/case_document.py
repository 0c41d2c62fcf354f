"""A member of a family of polyhedra of any shape as a case file, without a certificate: the case
itself shows the degeneracy, and two routes agree on its sums."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar

from minkref import _core
from minkref.degeneracies.case_texts import CaseTexts
from minkref.degeneracies.solids.draft import Probe, SolidFacts
from minkref.degeneracies.solids.flags import flags_of_solids
from minkref.degeneracies.solids.ties import Tie
from minkref.degeneracies.space.case_document import content_in_space
from minkref.exact import digest
from minkref.fuzz.geometry.space import Point

SHOWN = 12  # ties of many

VARIES = (
    "Faces come in any order and in any pieces, and vertices inside faces and edges may be kept: "
    "compare sets, or canonical forms. The set is regular and closed: points at which sP and x - Q "
    "only touch belong to it where they are next to its interior.",
)


class RoutesDiffer(Exception):
    """Two routes to one sum do not agree: a fault of ours."""


@dataclass(frozen=True)
class DegenerateSolids(CaseTexts[SolidFacts]):
    """A case with two polyhedra of any shape."""

    shown: list[Tie]
    certified: ClassVar[bool] = False

    @property
    def content(self) -> str:
        return content_in_space(self.facts.P.given, self.facts.Q.given)

    @property
    def operands(self) -> dict[str, Any]:
        return {
            "dimension": 3,
            "P": self.facts.P.given.document(),
            "Q": self.facts.Q.given.document(),
            "scales": [_factors(s) for s in self.facts.scales],
        }

    @property
    def findings(self) -> dict[str, Any]:
        facts = self.facts
        return {
            "flags": flags_of_solids(facts),
            "expected": [self._expected(s) for s in facts.scales],
            "degeneracy": {
                "at": _factors(facts.scale),
                "why": self.subject.why,
                "ties": [self._row(tie) for tie in self.shown[:SHOWN]],
                "points": [self._point(probe) for probe in facts.probes],
                "varies": list(VARIES),
            },
        }

    def _expected(self, s: Fraction) -> dict[str, Any]:
        """Refuses what two routes do not agree on."""
        facts = self.facts
        found = facts.sum(s)
        again = _core.definition_sum_in_space(facts.P.surface, facts.Q.surface, (str(s),) * 3)
        if found != again:
            raise RoutesDiffer(f"{self.id} at {s}: edges and definition differ")
        return {
            "scale": _factors(s),
            "digest": digest(found.canonical_json()),
            "planes": found.planes,
            "volume": found.volume(),
        }

    def _row(self, tie: Tie) -> dict[str, Any]:
        """The tie's row, with the predicate's sign at each scale."""
        features = [[list(p), list(q)] for p, q in tie.features]
        return {"what": tie.what, "features": features, "signs": self.facts.signs(tie)}

    def _point(self, probe: Probe) -> dict[str, Any]:
        row: dict[str, Any] = {
            "p": _texts(probe.p),
            "q": _texts(probe.q),
            "contact": self.facts.contacts(probe),
        }
        euler = self.facts.euler(probe)
        return row if euler is None else {**row, "euler": euler}


def _texts(point: Point) -> list[str]:
    return [str(number) for number in point]


def _factors(s: Fraction) -> list[str]:
    return [str(s)] * 3
