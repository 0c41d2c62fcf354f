"""All triple events for the paper's pairs; also a hole that dies at a triple event."""

from __future__ import annotations

import time
from fractions import Fraction

from minkref import _core
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(0.05, 0.3, 2)

#: counted in doubles
COUNTED = {("disc1", "neuron"): 25_600, ("monkey", "bird"): 727_000}
SECONDS = 60.0

TRIANGLE = '{"polygons":[{"outer":[["-3","-2"],["4","-1"],["1","3"]],"holes":[]}]}'
SQUARE = (
    '{"polygons":[{"outer":[["-40","-40"],["40","-40"],["40","40"],["-40","40"]],'
    '"holes":[[["0","20"],["17","-11"],["-19","-9"]]]}]}'
)
SCALE = Fraction(541, 186)


def run(findings: Findings, size: Size) -> None:
    _dying_hole(findings)
    for names in list(COUNTED)[: 1 if size is Size.QUICK else 2]:
        P, Q = (operand(name) for name in names)
        title = f"{P.name} + {Q.name}"
        began = time.perf_counter()
        found = _core.ArrangementEvents(P.set, Q.set)
        seconds = time.perf_counter() - began
        triples = len(found.of_kind("triple"))
        findings.figures[title] = {
            "triple events": triples,
            "swaps along edges": found.counts()["node_swaps"],
            "arrangement events": len(found.of_kind("arrangement")),
            "scales": found.ranks(found.of_kind("arrangement"))[-1] + 1,
            "seconds, pair events included": round(seconds, 2),
        }
        findings.target(
            f"{title}: seconds, pair events included", seconds < SECONDS, f"under {SECONDS:g}",
            f"{seconds:.1f}",
        )  # fmt: skip
        if tell_absent(findings, *names):
            counted = COUNTED[names]
            near = abs(triples - counted) < counted // 50
            findings.target(f"{title}: triple events", near, f"some {counted:,}", f"{triples:,}")


def _dying_hole(findings: Findings) -> None:
    P, Q = _core.PolygonSet.from_json(TRIANGLE), _core.PolygonSet.from_json(SQUARE)
    dynamic = _core.DynamicSum(P, Q)
    kinds = dict(dynamic.event_scales()).get(str(SCALE), [])
    findings.law("kinds of events at 541/186", kinds == ["triple"], "triple", ", ".join(kinds))
    events = [row for row in dynamic.topology_events() if row[0] == str(SCALE)]
    told = [(row[1], row[2]) for row in events]
    findings.law("topology event there", told == [("hole", "death")], "a hole dies", told)
    little = Fraction(1, 2**60)
    static = [
        _core.minkowski_sum(P, Q, str(s)).holes for s in (SCALE - little, SCALE, SCALE + little)
    ]
    findings.law("holes just below, at, just above", static == [1, 0, 0], "1, 0, 0", static)
    stepped = []
    for s in (SCALE - little, SCALE, SCALE + little):
        dynamic.move_to(str(s))
        stepped.append(dynamic.sum().holes)
    findings.law("the same by steps", stepped == [1, 0, 0], "1, 0, 0", stepped)
