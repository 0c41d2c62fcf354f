"""A member of a family as a case file with its certificate."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref import _core
from minkref.certify.certificate import Certificate
from minkref.degeneracies.draft import Facts, Family, Subject
from minkref.degeneracies.flags import flags_of
from minkref.degeneracies.generate import member
from minkref.degeneracies.verdict_of_floats import precision
from minkref.exact import digest
from minkref.fuzz.geometry.plane import written_rings

LICENCE = "Apache-2.0"
FINE = 60  # bits: a sibling is this near, where neighbouring doubles are 52 or 53 bits apart
IN_FULL = 60  # results of up to this many vertices are given in full

VARIES = {
    "closed": "The sum is closed. An implementation that computes the closure of its interior has "
    "the same canonical form; one that leaves out the points at which only boundaries touch "
    "(tight passages) differs by these, and should say so.",
    "form": "Rings may start anywhere, holes and components come in any order, and vertices in the "
    "middle of straight edges may be kept: compare sets, or canonical forms.",
    "rounding": "Vertices that are no floating-point numbers can only be rounded; components and "
    "holes can be right all the same.",
}


@dataclass(frozen=True)
class Degenerate:
    """A case, and the texts that it becomes. They depend on these three alone."""

    subject: Subject
    facts: Facts
    source: str

    @classmethod
    def of(cls, family: Family, seed: int, index: int, size: int | None = None) -> Degenerate:
        """The member of this number; of about so many vertices, where a size is given."""
        source = f"minkref generate {family.name} --seed {seed} --index {index}"
        source += f" --size {size}" if size is not None else ""
        return cls(family, member(family, seed, index, size), source)

    @cached_property
    def scales(self) -> list[Fraction]:
        """The scale, and its siblings on both sides: the nearest powers of two apart from other
        critical scales, and still nearer ones."""
        s, gap = self.facts.scale, self.facts.gap
        size = s.denominator.bit_length() - s.numerator.bit_length()  # s is about 2^-size
        steps = sorted({gap, max(gap, FINE + size)})
        near = [Fraction(1, 2**k) for k in steps]
        return [s, *(s - d for d in near), *(s + d for d in near)]

    @cached_property
    def sums(self) -> list[_core.Sum]:
        P, Q = self.facts.P, self.facts.Q
        return [_core.minkowski_sum(P, Q, str(scale)) for scale in self.scales]

    @cached_property
    def id(self) -> str:
        content = content_of(self.facts.P, self.facts.Q)
        return id_of(self.subject.name, content, [str(scale) for scale in self.scales])

    @cached_property
    def document(self) -> dict[str, Any]:
        """case-v1."""
        facts, name = self.facts, self.subject.name
        return {
            "schema": "case-v1",
            "id": self.id,
            "title": self.subject.title,
            "dimension": 2,
            "P": json.loads(facts.P.to_json()),
            "Q": json.loads(facts.Q.to_json()),
            "scales": [str(scale) for scale in self.scales],
            "tags": [name],
            "flags": flags_of(facts),
            "expected": [
                self._expected(*pair) for pair in zip(self.scales, self.sums, strict=True)
            ],
            "degeneracy": {
                "at": facts.text,
                "why": self.subject.why,
                "events": [_event(row) for row in facts.arrangement],
                "topology": facts.topology,
                "tight_passages": facts.passages,
                **self._wound_zero_times(),
                "below_at_above": [list(counts) for counts in facts.counts],
                "varies": [VARIES[name] for name in self._varies()],
                "floats": [
                    precision(facts.P, facts.Q, str(scale), found)
                    for scale, found in zip(self.scales, self.sums, strict=True)
                ],
            },
            "source": self.source,
            "licence": LICENCE,
            "certificate": f"{self.id}.cert.json",
        }

    @cached_property
    def case_text(self) -> str:
        """A member a line: the canonical form of a case file."""
        return canonical_text(self.document)

    @cached_property
    def certificate(self) -> Certificate:
        """The event of the boundary at the scale, or the sum there, with its tight passages; what
        meets there; the point that the convolution winds around zero times is in the sum; what is
        expected at the siblings."""
        facts = self.facts
        made = Certificate(facts.P, facts.Q)
        if facts.boundary:
            before = facts.scale - Fraction(1, 2**facts.gap)
            made.event(facts.scale, before, passages=True)
        else:
            made.sum(facts.scale, passages=True)
        if facts.arrangement:
            made.degeneracy(facts.scale)
        for zero in facts.zeros:
            made.zero(zero, facts.scale)
        if facts.wound_zero_times is not None:
            x, y = facts.wound_zero_times
            made.point(facts.scale, (str(x), str(y)))
        for scale in self.scales[1:]:
            made.sum(scale)
        return made

    @cached_property
    def certificate_text(self) -> str:
        return self.certificate.text(f"{self.id}.json", self.id, "minkref")

    def _expected(self, scale: Fraction, found: _core.Sum) -> dict[str, Any]:
        told: dict[str, Any] = {
            "scale": str(scale),
            "digest": digest(found.region.canonical_json()),
            "components": found.components,
            "holes": found.holes,
            "vertices": found.region.vertices,
            "area": found.region.area(),
        }
        if scale == self.facts.scale and found.region.vertices <= IN_FULL:
            told["result"] = json.loads(found.region.canonical_json())
        return told

    def _wound_zero_times(self) -> dict[str, list[str]]:
        point = self.facts.wound_zero_times
        return {} if point is None else {"wound_zero_times": [str(x) for x in point]}

    def _varies(self) -> list[str]:
        rings = written_rings(self.sums[0].region.canonical_json())
        exact = all(_is_double(x) for ring in rings for point in ring for x in point)
        named = ["form"] + ["closed"] * bool(self.facts.passages) + ["rounding"] * (not exact)
        return named


def content_of(P: _core.PolygonSet, Q: _core.PolygonSet) -> str:
    """Both operands, the same text for the same rings: whatever vertex they start at, in whatever
    order they, or the polygons, are."""
    return json.dumps([_content(P), _content(Q)])


def _content(operand: _core.PolygonSet) -> list[Any]:
    def turned(ring: list[list[str]]) -> list[list[str]]:
        first = ring.index(min(ring))
        return ring[first:] + ring[:first]

    polygons = json.loads(operand.to_json())["polygons"]
    return sorted([turned(p["outer"]), sorted(map(turned, p["holes"]))] for p in polygons)


def id_of(family: str, content: str, scales: list[str]) -> str:
    """The family, and a hash of operands and scales."""
    return f"{family}-{digest(json.dumps([content, *scales]))[:12]}"


def canonical_text(document: dict[str, Any]) -> str:
    parts = [f'"{name}": {json.dumps(document[name])}' for name in document]
    return "{" + ",\n".join(parts) + "}\n"


def _event(row: dict[str, Any]) -> dict[str, Any]:
    edges = [dict(zip(("kind", "sign", "edge_ring", "edge", "vertex_ring", "vertex"), edge,
                      strict=True)) for edge in row["edges"]]  # fmt: skip
    return {**row, "edges": edges}


def _is_double(text: str) -> bool:
    value = Fraction(text)
    try:
        return Fraction(float(value)) == value
    except OverflowError:
        return False
