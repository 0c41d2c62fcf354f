"""The sum of monkey and bird at scale 1: its size, its holes, its area."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.exact import approximate, digest
from minkref.fuzz.geometry.plane import doubled_area, fraction_rings, turn
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import MODELS, READERS, REFERENCE, Findings

SUBJECT = "monkey + bird at scale 1: 770 vertices in all rings, 2 holes, area 11958.2536..."
MINUTES = (0.1, 0.1)
DEPENDS = (*REFERENCE, *READERS, *MODELS, "fuzz/geometry/plane.py")


def run(findings: Findings, quick: bool) -> None:
    real = tell_absent(findings, "monkey", "bird")
    P, Q = operand("monkey"), operand("bird")
    answer = _core.minkowski_sum(P.set, Q.set, "1")
    canonical = answer.region.canonical_json()
    rings = fraction_rings(canonical)
    vertices = sum(map(len, rings))
    straight = sum(
        turn(ring[k - 2], ring[k - 1], ring[k]) == 0 for ring in rings for k in range(len(ring))
    )
    area = answer.region.area()
    findings.figures = {
        "pair": f"{P.name} + {Q.name}",
        "vertices": vertices,
        "holes": answer.holes,
        "components": answer.components,
        "area": approximate(area),
        "digits of the exact area": len(area),
        "digest": digest(canonical),
        "seconds": answer.seconds,
        "statistics": answer.statistics,
    }
    findings.none("collinear vertices left", straight)
    same = Fraction(area) == Fraction(sum(map(doubled_area, rings))) / 2
    findings.law("area and area by plain fractions", same, "equal", "equal" if same else "unequal")
    findings.equal(
        "rings less outer ones are the holes", len(rings) - answer.components, answer.holes
    )
    if real:
        findings.target("vertices", vertices == 770, 770, vertices)
        findings.target("holes", answer.holes == 2, 2, answer.holes)
        scaled = Fraction(area) * 10**4
        digits = scaled.numerator // scaled.denominator
        findings.target("area", digits == 119582536, "11958.2536...", approximate(area))
