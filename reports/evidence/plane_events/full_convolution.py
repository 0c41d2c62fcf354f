"""Events of the full convolution beside those of the reduced one, for the paper's pairs: what
updates by winding numbers cost."""

from __future__ import annotations

import time
from typing import Any

from minkref import _core
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(0.1, 1, 2)

#: births and deaths of pairs that are not parallel, of the reduced convolution
COUNTED = {("disc1", "neuron"): 145_453, ("monkey", "bird"): 3_026_701}


def run(findings: Findings, size: Size) -> None:
    for names in list(COUNTED)[: 1 if size is Size.QUICK else 2]:
        P, Q = (operand(name) for name in names)
        title = f"{P.name} + {Q.name}"
        full, reduced = (_counted(P.set, Q.set, route) for route in ("winding", "dynamic"))
        ratio = full["births and deaths"] / max(1, reduced["births and deaths"])
        findings.figures[title] = {
            "full": full,
            "reduced": reduced,
            "times as many births and deaths": round(ratio, 2),
        }
        more = full["births and deaths"] >= reduced["births and deaths"]
        findings.law(f"{title}: the full convolution has all events", more, "more", f"{ratio:.2f}")
        if tell_absent(findings, *names):
            what = f"{title}: births and deaths, of the reduced convolution"
            findings.equal(what, COUNTED[names], reduced["births and deaths"])


def _counted(P: _core.PolygonSet, Q: _core.PolygonSet, route: str) -> dict[str, Any]:
    began = time.perf_counter()
    found = _core.pair_events(P, Q, kind="pair", route=route)
    seconds = time.perf_counter() - began
    counts = dict(found.counts())
    return {
        "edges": counts["s_edges"] + counts["t_edges"],
        "pairs of edges": counts["pairs"],
        "meeting": counts["intersecting_pairs"],
        "births and deaths": len(found) - counts["touching_pairs"],
        "seconds": round(seconds, 2),
    }
