"""The sum of monkey and bird at scale 1: its size, its holes, its area."""

from __future__ import annotations

import json
from fractions import Fraction

from minkref import _core
from minkref.exact import approximate, digest
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import MODELS, READERS, REFERENCE, Findings

SUBJECT = "monkey + bird at scale 1: 770 vertices in all rings, 2 holes, area 11958.2536..."
MINUTES = (0.1, 0.1)
DEPENDS = (*REFERENCE, *READERS, *MODELS)


def run(quick: bool) -> Findings:
    findings = Findings()
    real = tell_absent(findings, "monkey", "bird")
    P, Q = operand("monkey"), operand("bird")
    answer = _core.minkowski_sum(P.set, Q.set, "1")
    canonical = answer.region.canonical_json()
    rings = [
        [(Fraction(x), Fraction(y)) for x, y in ring]
        for polygon in json.loads(canonical)["polygons"]
        for ring in (polygon["outer"], *polygon["holes"])
    ]
    straight, doubled, vertices = 0, Fraction(0), sum(map(len, rings))
    for ring in rings:
        for k in range(len(ring)):
            (ax, ay), (bx, by), (cx, cy) = ring[k - 2], ring[k - 1], ring[k]
            straight += (bx - ax) * (cy - by) == (by - ay) * (cx - bx)
            doubled += bx * cy - by * cx
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
    findings.law("collinear vertices left", straight == 0, 0, straight)
    same = Fraction(area) == doubled / 2
    findings.law("area and area by plain fractions", same, "equal", "equal" if same else "unequal")
    findings.law("rings less outer ones are the holes", len(rings) - answer.components
                 == answer.holes, len(rings) - answer.components, answer.holes)  # fmt: skip
    if real:
        findings.target("vertices", vertices == 770, 770, vertices)
        findings.target("holes", answer.holes == 2, 2, answer.holes)
        scaled = Fraction(area) * 10**4
        digits = scaled.numerator // scaled.denominator
        findings.target("area", digits == 119582536, "11958.2536...", approximate(area))
    return findings
