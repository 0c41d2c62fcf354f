"""Sizes of the convolutions of the paper's pairs, recounted from the rule; closed signed cycles."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.plane import Vector, fraction_rings, plus
from minkref.reports.convolution_count import turns_of, whole_rings
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import MODELS, READERS, REFERENCE, Findings

SUBJECT = (
    "Reduced and full convolution of monkey and bird, disc1 and neuron: sizes as in the paper, "
    "recounted in plain Python from the half-open rule; each full convolution is a closed cycle."
)
MINUTES = (0.1, 0.1)
DEPENDS = (*REFERENCE, *READERS, *MODELS, "fuzz/geometry/*.py", "reports/*.py")

SCALE = Fraction(541, 186)
# S-edges and T-edges of the reduced convolution (or their sum), all edges of the full one.
PAPER: dict[tuple[str, str], dict[str, object]] = {
    ("monkey", "bird"): {"reduced S, T": "10225, 6200", "reduced": 16425, "full": 31371},
    ("disc1", "neuron"): {"reduced": 3195, "full": 5119},
}
Point = Vector[Fraction]


def unbalanced(first: _core.PolygonSet, second: _core.PolygonSet) -> int:
    """Nodes of the full convolution at which signed edges in and out do not cancel; exact."""
    # In the order in which convolution edges name them.
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


def run(findings: Findings, quick: bool) -> None:
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
