"""Pair, parallel and triple events against event scales by computer algebra."""

from __future__ import annotations

import json
import time
from collections import Counter
from typing import Any

from minkref.fuzz.judges import event_comparison, interval_comparison
from minkref.reports.evidence.framework.part import COMPARISON, REFERENCE, Findings

SUBJECT = (
    "`minkref events` (kinds pair, parallel, triple; the search for pairs and the dynamic sum's) "
    "and intervals of contact against the symbolic oracle: random pairs of moving segments of each "
    "type, a third degenerate at least, and triples."
)
MINUTES = (0.6, 0.1)
DEPENDS = (*REFERENCE, *COMPARISON, "fuzz/judges/*.py", "oracle/symbolic/*")

SEED = 5
PAIRS, QUICK_PAIRS, TRIPLES = 5000, 400, 1000


def shares(pairs: Counter[str], degenerate: Counter[str]) -> str:
    return ", ".join(f"{kinds} {degenerate[kinds] / pairs[kinds]:.0%}" for kinds in sorted(pairs))


def run(findings: Findings, quick: bool) -> None:
    count = QUICK_PAIRS if quick else PAIRS
    since = time.perf_counter()
    intervals = interval_comparison.compare_intervals(SEED, count)
    seconds = time.perf_counter() - since
    print("intervals of single pairs are done", flush=True)
    events = event_comparison.compare(SEED, count, TRIPLES)
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
    findings.law("triples of segments", events.triples >= TRIPLES, TRIPLES, f"{events.triples:,}")
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
