"""A member of a family as a case file with its certificate."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.degeneracies.case_texts import IN_FULL, CaseTexts, is_double
from minkref.degeneracies.plane.draft import Facts
from minkref.degeneracies.plane.flags import flags_of
from minkref.degeneracies.plane.verdict_of_floats import precision
from minkref.exact import digest
from minkref.fuzz.geometry.plane import written_rings
from minkref.plane.rings import from_least

FINE = 60  # bits: a sibling lies this near; neighbouring doubles lie 52 or 53 bits apart

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
class Degenerate(CaseTexts[Facts]):
    """A case in the plane."""

    @property
    def content(self) -> str:
        return content_of(self.facts.P, self.facts.Q)

    @cached_property
    def scales(self) -> list[Fraction]:
        """The scale, and siblings on both sides: the nearest powers of two apart from other
        critical scales, and still nearer siblings."""
        s, gap = self.facts.scale, self.facts.gap
        size = s.denominator.bit_length() - s.numerator.bit_length()  # s is about 2^-size
        steps = sorted({gap, max(gap, FINE + size)})
        near = [Fraction(1, 2**k) for k in steps]
        return [s, *(s - d for d in near), *(s + d for d in near)]

    @cached_property
    def sums(self) -> list[_core.Sum]:
        P, Q = self.facts.P, self.facts.Q
        return [_core.minkowski_sum(P, Q, str(scale)) for scale in self.scales]

    @property
    def operands(self) -> dict[str, Any]:
        return {
            "dimension": 2,
            "P": json.loads(self.facts.P.to_json()),
            "Q": json.loads(self.facts.Q.to_json()),
            "scales": [str(scale) for scale in self.scales],
        }

    @property
    def findings(self) -> dict[str, Any]:
        facts, found = self.facts, list(zip(self.scales, self.sums, strict=True))
        return {
            "flags": flags_of(facts),
            "expected": [self._expected(*each) for each in found],
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
                    precision(facts.P, facts.Q, str(scale), answer) for scale, answer in found
                ],
            },
        }

    @cached_property
    def certificate(self) -> Certificate:
        """Certifies the boundary's event at the scale, or the sum there, with its tight passages;
        the coincidences there; that the sum holds the point which the convolution winds around zero
        times; the expected results at the siblings."""
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
        exact = all(is_double(x) for ring in rings for point in ring for x in point)
        named = ["form"] + ["closed"] * bool(self.facts.passages) + ["rounding"] * (not exact)
        return named


def content_of(P: _core.PolygonSet, Q: _core.PolygonSet) -> str:
    """Both operands as text, the same whatever the order of polygons and rings, and whatever vertex
    a ring starts at."""
    return json.dumps([set_content(P), set_content(Q)])


def set_content(operand: _core.PolygonSet) -> list[Any]:
    """Returns one operand's content."""
    polygons = json.loads(operand.to_json())["polygons"]
    return sorted([from_least(p["outer"]), sorted(map(from_least, p["holes"]))] for p in polygons)


def _event(row: dict[str, Any]) -> dict[str, Any]:
    edges = [dict(zip(("kind", "sign", "edge_ring", "edge", "vertex_ring", "vertex"), edge,
                      strict=True)) for edge in row["edges"]]  # fmt: skip
    return {**row, "edges": edges}
