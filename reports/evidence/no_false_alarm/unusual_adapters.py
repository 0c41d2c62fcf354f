"""Right but unusual adapters, written from the page of the protocol alone: no alarm."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from minkref.reports.evidence.framework.command import counts_of, told, verify
from minkref.reports.evidence.framework.of_tests import PAGE_ALONE, page_adapter, page_adapters
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("tests/adapters/page_alone/",)
MINUTES = Minutes(None, 8, 60)

CASES = Counts(0, 10, 500)
PAIRS = Counts(0, 20, 300)  # of one run
RUNS = 12
WORKERS = 2  # adapters judged at a time
# Two adapters that only take convex polygons meet more of them here.
CONVEX = ("--family", "convex", "--family", "collinear", "--family", "offset")
GOOD = ("pass", "pass-within", "skipped")


def programs(folder: Path) -> dict[str, str]:
    """The adapters in other languages, as far as this machine runs them."""
    found = {}
    if shutil.which("node"):
        found["convex.js"] = f"cmd:node {PAGE_ALONE / 'convex.js'}"
    if compiler := shutil.which("c++"):
        program = folder / "convex"
        words = [compiler, "-std=c++17", "-O2", str(PAGE_ALONE / "convex.cpp"), "-o", str(program)]
        subprocess.run(words, check=True)
        found["convex.cpp"] = str(program)
    return found


def judged(
    target: str, cases: int, pairs: int, more: tuple[str, ...]
) -> tuple[Counter[str], list[str]]:
    """Verdicts on at least so many unskipped cases, and lines that reproduce the other verdicts."""
    counts: Counter[str] = Counter()
    shown: list[str] = []
    for seed in range(1, RUNS + 1):
        words = (target, *more, "--pairs", pairs, "--seed", seed, "--jobs", 1)
        words += ("--call-seconds", 300, "--no-models", "--shrink-calls", 0)
        _, value = verify(*words, seconds=1800)
        counts.update(counts_of(value, value["targets"][0]["name"]))
        shown += [finding["reproduce"] for finding in value["findings"]]
        if sum(counts[verdict] for verdict in counts if verdict != "skipped") >= cases:
            break
    return counts, shown


def run(findings: Findings, size: Size) -> None:
    cases = size.of(CASES)
    targets = {name: page_adapter(name) for name in page_adapters("UNUSUAL")}
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(WORKERS) as pool:
        others = programs(Path(folder))

        def row_of(name: str, target: str) -> tuple[Counter[str], list[str]]:
            began = time.monotonic()
            row = judged(target, cases, size.of(PAIRS), CONVEX if name in others else ())
            print(f"{name}: {time.monotonic() - began:.0f} s, {dict(row[0])}", flush=True)
            return row

        targets |= others
        rows = dict(zip(targets, pool.map(row_of, targets, targets.values()), strict=True))
    alarms, open_cases, few = 0, 0, 0
    for name, (counts, shown) in rows.items():
        findings.figures[name] = told(counts)
        open_cases += counts["undecided"]
        alarms += sum(n for verdict, n in counts.items() if verdict not in (*GOOD, "undecided"))
        few += sum(n for verdict, n in counts.items() if verdict != "skipped") < cases
        for line in shown[:3]:
            findings.note(f"{name}: {line}")
    findings.figures["kinds"] = len(rows)
    findings.none("alarms", alarms)
    findings.none("cases undecided", open_cases)
    findings.none(f"kinds with fewer than {cases} cases", few)
