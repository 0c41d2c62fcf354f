"""A member of a family in space as a case file with its certificate."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from minkref.certify.space.convex_certificate import ConvexCertificate
from minkref.degeneracies.case_texts import IN_FULL, CaseTexts, is_double
from minkref.degeneracies.space.body import Body, Corners
from minkref.degeneracies.space.draft import Coincidence, SpaceFacts
from minkref.degeneracies.space.flags import flags_in_space
from minkref.exact import digest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point

SHOWN = 12  # coincidences of many

VARIES = {
    "form": "Vertices and facets come in any order; facets in one plane may stay apart, in "
    "triangles, say, and vertices inside facets and edges may be kept: compare sets, or canonical "
    "forms.",
    "rounding": "Vertices that are no floating-point numbers can only be rounded; facets of many "
    "corners are then no longer planar.",
}


@dataclass(frozen=True)
class DegenerateInSpace(CaseTexts[SpaceFacts]):
    """A case in space."""

    shown: list[Coincidence]

    @property
    def content(self) -> str:
        return content_in_space(self.facts.P.given, self.facts.Q.given)

    @property
    def operands(self) -> dict[str, Any]:
        return {
            "dimension": 3,
            "P": self.facts.P.given.document(),
            "Q": self.facts.Q.given.document(),
            "scales": [_texts(at) for at in self.facts.scalings],
        }

    @property
    def findings(self) -> dict[str, Any]:
        facts = self.facts
        return {
            "flags": flags_in_space(facts),
            "expected": [self._expected(at) for at in facts.scalings],
            "degeneracy": {
                "at": _texts(facts.scaling),
                "why": self.subject.why,
                "coincidences": [self._row(each) for each in self.shown[:SHOWN]],
                "facets": [{"scale": _texts(at), **facts.sum(at).counts} for at in facts.scalings],
                "varies": [VARIES[name] for name in self._varies()],
                "floats": [self._floats(at) for at in facts.scalings],
            },
        }

    @property
    def certificate(self) -> ConvexCertificate:
        """The certificate of the sum at each scaling."""
        return self.facts.certificate

    def _expected(self, at: Point) -> dict[str, Any]:
        surface = self.facts.sum(at).found.surface
        told: dict[str, Any] = {
            "scale": _texts(at),
            "digest": digest(surface.canonical_json()),
            "vertices": surface.vertices,
            "facets": surface.faces,
            "volume": str(surface.sextuple_volume() / 6),
        }
        if at == self.facts.scaling and surface.vertices <= IN_FULL:
            told["result"] = json.loads(surface.canonical_json())
        return told

    def _row(self, shown: Coincidence) -> dict[str, Any]:
        """The coincidence's row, with the predicate's value at each scaling."""
        facts = self.facts
        return {
            "what": shown.what,
            "P": _given(facts.P, shown.P),
            "Q": _given(facts.Q, shown.Q),
            "signs": [facts.value(shown, at) for at in facts.scalings],
        }

    def _floats(self, at: Point) -> dict[str, Any]:
        return {
            "scale": _texts(at),
            "signs": len(self.facts.signs(at)),
            "wrong_in_doubles": self.facts.wrong_in_doubles(at),
        }

    def _varies(self) -> list[str]:
        points = self.facts.sum().found.surface.written_points()
        exact = all(is_double(c) for point in points for c in point)
        return ["form"] + ["rounding"] * (not exact)


def content_in_space(P: Polyhedron, Q: Polyhedron) -> str:
    """Both bodies, the same text for the same faces: however vertices are numbered, whatever vertex
    a face starts at, in whatever order faces are."""
    return json.dumps([_content(P), _content(Q)])


def _content(body: Polyhedron) -> list[Any]:
    order = sorted(range(len(body.vertices)), key=lambda k: body.vertices[k])
    rank = {k: place for place, k in enumerate(order)}
    rings = [[rank[k] for k in face] for face in body.faces]
    first = [ring.index(min(ring)) for ring in rings]
    turned = sorted(ring[k:] + ring[:k] for ring, k in zip(rings, first, strict=True))
    return [[[str(c) for c in body.vertices[k]] for k in order], turned]


def _texts(at: Point) -> list[str]:
    return [str(factor) for factor in at]


def _given(body: Body, face: Corners) -> list[int]:
    """Vertex numbers as in the file."""
    return sorted(body.numbers[k] for k in face)
