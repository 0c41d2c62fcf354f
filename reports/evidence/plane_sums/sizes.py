"""Sizes of the convolutions of the paper's pairs, recounted from the rule; closed signed cycles;
the sum of monkey and bird at scale 1: 770 vertices, 2 holes, area 11958.2536..."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction

from minkref import _core
from minkref.exact import approximate, digest
from minkref.fuzz.geometry.plane import Vector, doubled_area, fraction_rings, plus, turn
from minkref.reports.convolution_count import turns_of, whole_rings
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(0.05, 0.1, 0.1)

SCALE = Fraction(541, 186)
# S-edges and T-edges of the reduced convolution (or their total), and all full convolution edges.
PAPER: dict[tuple[str, str], dict[str, object]] = {
    ("monkey", "bird"): {"reduced S, T": "10225, 6200", "reduced": 16425, "full": 31371},
    ("disc1", "neuron"): {"reduced": 3195, "full": 5119},
}
Point = Vector[Fraction]


def unbalanced(first: _core.PolygonSet, second: _core.PolygonSet) -> int:
    """Counts nodes of the full convolution where signed incoming and outgoing edges do not cancel;
    exact."""
    # Rings have the order that convolution edges use.
    P, Q = fraction_rings(first.to_json(), SCALE), fraction_rings(second.to_json())
    balance: Counter[Point] = Counter()
    for kind, sign, ring, index, other_ring, other in _core.full_convolution(first, second):
        edge_of, vertex_of = (P, Q) if kind == "S" else (Q, P)
        start = edge_of[ring][index]
        end = edge_of[ring][(index + 1) % len(edge_of[ring])]
        at = vertex_of[other_ring][other]
        balance[plus(start, at)] -= sign
        balance[plus(end, at)] += sign
    return sum(1 for value in balance.values() if value)


def run(findings: Findings, size: Size) -> None:
    for (first, second), paper in PAPER.items():
        real = tell_absent(findings, *(n for n in (first, second) if n != "disc1"))
        P, Q = operand(first), operand(second)
        pair = f"{P.name} * {Q.name}"
        reduced = _core.reduced_convolution(P.set, Q.set)
        kinds = Counter(row[0] for row in reduced)
        full = _core.full_convolution(P.set, Q.set)
        sizes: dict[str, object] = {
            "reduced S, T": f"{kinds['S']}, {kinds['T']}",
            "reduced": len(reduced),
            "full": len(full),
        }
        findings.figures[pair] = sizes
        for what, wanted in paper.items():
            if real:
                findings.target(f"{pair}, {what}", sizes[what] == wanted, wanted, sizes[what])
        p, q = whole_rings(P.set), whole_rings(Q.set)
        (convex_s, reflex_s, _), (convex_t, reflex_t, _) = turns_of(p, q), turns_of(q, p)
        s_edges = convex_s.inside + convex_s.begin
        t_edges = convex_t.inside + convex_t.end
        counted = f"{s_edges}, {t_edges}"
        findings.equal(f"{pair}, reduced S, T by the rule", counted, sizes["reduced S, T"])
        total = (
            s_edges + t_edges + reflex_s.inside + reflex_s.begin + reflex_t.inside + reflex_t.end
        )
        findings.equal(f"{pair}, full by the rule", total, len(full))
        open_nodes = unbalanced(P.set, Q.set)
        findings.none(f"{pair}, unbalanced nodes at {SCALE}", open_nodes)
    findings.note("the paper prints 3196 for its disc and neuron; the phase of its disc is unknown")
    _monkey_and_bird(findings)


def _monkey_and_bird(findings: Findings) -> None:
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
    findings.figures[f"{P.name} + {Q.name}"] = {
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
