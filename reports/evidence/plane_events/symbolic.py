"""Pair, parallel and triple events against event scales by computer algebra."""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import time
from collections import Counter
from typing import Any

from minkref.fuzz.judges.plane import event_comparison, interval_comparison
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.2, 0.6, 1)

SEED = 5
PAIRS, TRIPLES = Counts(200, 2500, 5000), Counts(40, 500, 1000)
TIMED, TIMED_TRIPLES, REPEATS = 200, 40, Counts(1, 3, 5)


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
    _rationals(findings, size.of(REPEATS))


def _rationals(findings: Findings, repeats: int) -> None:
    """Times the same comparisons with the rationals of gmpy2 and with Python's own, in turn."""
    module = "minkref.reports.evidence.plane_events.timed_algebra"
    rows: dict[str, list[dict[str, float]]] = {"gmpy2": [], "fractions": []}
    for _ in range(repeats):
        for name, found in rows.items():
            command = [sys.executable, "-m", module, name, str(TIMED), str(TIMED_TRIPLES)]
            done = subprocess.run(command, capture_output=True, text=True, check=True)
            found.append(json.loads(done.stdout))
    told = [one["differences"] for found in rows.values() for one in found]
    findings.equal("differences with either kind of rationals", 0, sum(told))
    for what in ("intervals", "events"):
        ratios = [
            slow[what] / quick[what]
            for quick, slow in zip(rows["gmpy2"], rows["fractions"], strict=True)
        ]
        findings.note(
            f"computer algebra, {what}: with Python's own rationals "
            f"{statistics.median(ratios):.1f} times the processor time of gmpy2's "
            f"({min(ratios):.1f} to {max(ratios):.1f} in {repeats} runs in turn)"
        )
    findings.figures["with gmpy2 and without"] = rows
