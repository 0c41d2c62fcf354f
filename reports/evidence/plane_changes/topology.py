"""Topology events for the paper's pairs, each confirmed by neighbouring static sums."""

from __future__ import annotations

import bisect
import time
from collections import Counter
from fractions import Fraction

from minkref import _core
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.6, 3)

WINDOWS: dict[tuple[str, str], tuple[str | None, str | None]] = {
    ("disc1", "neuron"): (None, None),
    ("monkey", "bird"): ("1/2", "2"),
}

LOOKED: Counts[int | None] = Counts(2, 60, None)  # checked scales per pair; None for all


def run(findings: Findings, size: Size) -> None:
    for names, window in WINDOWS.items():
        if names == ("disc1", "neuron") or size is not Size.QUICK:
            _pair(findings, names, window, size.of(LOOKED))


def _pair(
    findings: Findings,
    names: tuple[str, str],
    window: tuple[str | None, str | None],
    most: int | None,
) -> None:
    P, Q = (operand(name) for name in names)
    title = f"{P.name} + {Q.name}"
    began = time.perf_counter()
    dynamic = _core.DynamicSum(P.set, Q.set, *window)
    events = dynamic.topology_events()
    seconds = time.perf_counter() - began
    scales = [Fraction(scale) for scale, _ in dynamic.event_scales()]
    states = dynamic.state_counts()
    begins = [Fraction(begin) if begin is not None else Fraction(0) for begin, _ in states]
    at_events = sorted({Fraction(row[0]) for row in events})
    looked = at_events if most is None else at_events[:: max(1, len(at_events) // most)]
    wrong = []
    for scale in looked:
        k = bisect.bisect_left(scales, scale)
        low = scales[k - 1] if k else scale / 2
        high = scales[k + 1] if k + 1 < len(scales) else 2 * scale
        s = bisect.bisect_left(begins, scale)
        before, (holes, components, _, holes_at, components_at) = states[s - 1][1], states[s][1]
        expected = [(before[0], before[1]), (holes_at, components_at), (holes, components)]
        static = []
        for at in ((low + scale) / 2, scale, (scale + high) / 2):
            answer = _core.minkowski_sum(P.set, Q.set, str(at))
            static.append((answer.holes, answer.components))
        if static != expected:
            wrong.append({"scale": str(scale), "expected": expected, "static": static})
    findings.figures[title] = {
        "window": window,
        "seconds": round(seconds, 2),
        "arrangement events at": len(scales),
        "boundary events": len(dynamic.boundary_events()),
        "topology events": len(events),
        "of": dict(Counter(f"{row[1]} {row[2]}" for row in events)),
        "holes that ever live": len(dynamic.lives("hole")),
        "confirmed": len(looked) - len(wrong),
        "wrong": wrong[:5],
    }
    findings.none(f"{title}: events that a static sum refutes", len(wrong))
    findings.target(f"{title}: topology events looked at", bool(looked), "some",
                    f"{len(looked)} of {len(at_events)} scales")  # fmt: skip
    tell_absent(findings, *names)
