"""Sizes of the convolutions of the paper's pairs, recounted from the rule; closed signed cycles."""

from __future__ import annotations

import json
from collections import Counter
from fractions import Fraction

from minkref import _core
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import MODELS, READERS, REFERENCE, Findings

SUBJECT = (
    "Reduced and full convolution of monkey and bird, disc1 and neuron: sizes as in the paper, "
    "recounted in plain Python from the half-open rule; each full convolution is a closed cycle."
)
MINUTES = (0.1, 0.1)
DEPENDS = (*REFERENCE, *READERS, *MODELS)

SCALE = Fraction(541, 186)
# S-edges and T-edges of the reduced convolution (or their sum), all edges of the full one.
PAPER: dict[tuple[str, str], dict[str, object]] = {
    ("monkey", "bird"): {"reduced S, T": "10225, 6200", "reduced": 16425, "full": 31371},
    ("disc1", "neuron"): {"reduced": 3195, "full": 5119},
}
Point = tuple[Fraction, Fraction]


def rings_of(region: _core.PolygonSet) -> list[list[Point]]:
    """Rings in the order that convolution edges name them."""
    return [
        [(Fraction(x), Fraction(y)) for x, y in ring]
        for polygon in json.loads(region.to_json())["polygons"]
        for ring in (polygon["outer"], *polygon["holes"])
    ]


def integers(rings: list[list[Point]]) -> list[list[tuple[int, int]]]:
    """The rings times a common denominator: the rule looks at directions only."""
    denominator = 1
    for ring in rings:
        for x, y in ring:
            for value in (x, y):
                if denominator % value.denominator:
                    denominator *= value.denominator
    return [[(int(x * denominator), int(y * denominator)) for x, y in ring] for ring in rings]


def recount(
    edges: list[list[tuple[int, int]]], turns: list[list[tuple[int, int]]], begin: bool
) -> tuple[int, int]:
    """Pairs of an edge of one operand and a vertex of the other whose turn, short of a half one,
    holds the edge's direction; `begin` tells which end of the turn counts in. At strictly convex
    vertices (the reduced convolution), and at the reflex ones."""
    convex = reflex = 0
    directions = [
        (b[0] - a[0], b[1] - a[1])
        for ring in edges
        for a, b in zip(ring, ring[1:] + ring[:1], strict=True)
    ]
    for ring in turns:
        for k in range(len(ring)):
            a, b, c = ring[k - 1], ring[k], ring[(k + 1) % len(ring)]
            first, last = (b[0] - a[0], b[1] - a[1]), (c[0] - b[0], c[1] - b[1])
            sense = first[0] * last[1] - first[1] * last[0]
            if sense == 0:
                continue
            if sense < 0:  # a clockwise turn: the same range of directions, run backwards
                first, last = last, first
            count = 0
            for x, y in directions:
                left = first[0] * y - first[1] * x
                right = x * last[1] - y * last[0]
                if left > 0 and right > 0:
                    count += 1
                elif begin and left == 0 and first[0] * x + first[1] * y > 0:
                    count += 1
                elif not begin and right == 0 and last[0] * x + last[1] * y > 0:
                    count += 1
            if sense > 0:
                convex += count
            else:
                reflex += count
    return convex, reflex


def unbalanced(first: _core.PolygonSet, second: _core.PolygonSet) -> int:
    """Nodes of the full convolution at which signed edges in and out do not cancel; exact."""
    P = [[(SCALE * x, SCALE * y) for x, y in ring] for ring in rings_of(first)]
    Q = rings_of(second)
    balance: Counter[Point] = Counter()
    for kind, sign, ring, index, other_ring, other in _core.full_convolution(first, second):
        edge_of, vertex_of = (P, Q) if kind == "S" else (Q, P)
        start = edge_of[ring][index]
        end = edge_of[ring][(index + 1) % len(edge_of[ring])]
        at = vertex_of[other_ring][other]
        balance[(start[0] + at[0], start[1] + at[1])] -= sign
        balance[(end[0] + at[0], end[1] + at[1])] += sign
    return sum(1 for value in balance.values() if value)


def run(quick: bool) -> Findings:
    findings = Findings()
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
        p, q = integers(rings_of(P.set)), integers(rings_of(Q.set))
        s_edges, t_edges = recount(p, q, begin=True), recount(q, p, begin=False)
        counted = f"{s_edges[0]}, {t_edges[0]}"
        findings.law(
            f"{pair}, reduced S, T by the rule", counted == sizes["reduced S, T"],
            counted, sizes["reduced S, T"],
        )  # fmt: skip
        total = sum(s_edges) + sum(t_edges)
        findings.law(f"{pair}, full by the rule", total == len(full), total, len(full))
        open_nodes = unbalanced(P.set, Q.set)
        findings.law(f"{pair}, unbalanced nodes at {SCALE}", open_nodes == 0, 0, open_nodes)
    findings.note("the paper prints 3196 for its disc and neuron; the phase of its disc is unknown")
    return findings
