"""Pair, parallel and triple events against event scales by computer algebra."""

from __future__ import annotations

import json
import time
from collections import Counter
from typing import Any

from minkref.fuzz.judges.plane import event_comparison, interval_comparison
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.3, 0.6)

SEED = 5
PAIRS, TRIPLES = Counts(200, 2500, 5000), Counts(40, 500, 1000)


def shares(pairs: Counter[str], degenerate: Counter[str]) -> str:
    return ", ".join(f"{kinds} {degenerate[kinds] / pairs[kinds]:.0%}" for kinds in sorted(pairs))


def run(findings: Findings, size: Size) -> None:
    count, triples = size.of(PAIRS), size.of(TRIPLES)
    since = time.perf_counter()
    intervals = interval_comparison.compare_intervals(SEED, count)
    seconds = time.perf_counter() - since
    print("intervals of single pairs are done", flush=True)
    events = event_comparison.compare(SEED, count, triples)
    for name, table in (("intervals", intervals), ("events", events)):
        enough = all(table.pairs[kinds] >= count for kinds in ("SS", "ST", "TT"))
        reached = ", ".join(f"{kinds} {table.pairs[kinds]:,}" for kinds in ("SS", "ST", "TT"))
        findings.none(f"{name}: differences", table.differences)
        findings.law(f"{name}: pairs of each type", enough, f"{count:,}", reached)
        third = all(3 * table.degenerate[k] >= table.pairs[k] for k in table.pairs)
        findings.target(
            f"{name}: degenerate pairs", third, "a third of each type",
            shares(table.pairs, table.degenerate),
        )  # fmt: skip
    findings.law("triples of segments", events.triples >= triples, triples, f"{events.triples:,}")
    findings.none("pairs left out as too long", events.left_out_too_long)
    swaps = events.events["triple swap"]
    findings.target("triple events among them", swaps > 0, "some", f"{swaps:,}")
    a_minute = 60 * sum(intervals.pairs.values()) / seconds
    findings.target("pairs a minute", a_minute >= 2000, "thousands", f"{round(a_minute, -3):,.0f}")
    document: dict[str, Any] = json.loads(json.dumps(events.document()))
    findings.figures |= {
        "events": document,
        "intervals": json.loads(json.dumps(vars(intervals))),
        "seconds of the intervals": round(seconds, 2),
    }
