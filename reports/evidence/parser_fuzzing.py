"""libFuzzer on every reader, those of polyhedra and of index files too, with the address and
undefined behaviour sanitizers."""

from __future__ import annotations

import re
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework.libfuzzer import build, fuzz
from minkref.reports.evidence.framework.part import READERS, Findings
from minkref.reports.evidence.framework.store import ROOT

SUBJECT = (
    "libFuzzer (clang, address and undefined behaviour sanitizers) on every parser, those of "
    "meshes and of index files too, 5 minutes each: no finding left."
)
MINUTES = (26, 1.5)
DEPENDS = (
    *READERS, "reference/number/*.?pp", "reference/space/*.?pp", "reference/plane/index/*.?pp",
    "reference/error.?pp", "tests/fuzzing/*",
)  # fmt: skip

SECONDS, QUICK_SECONDS = 300, 5
BUILD = ROOT / "build" / "fuzzing"
SEEDS = ROOT / "tests" / "fuzzing" / "corpus"
FLAGS = ("-max_len=4096", "-timeout=20", "-rss_limit_mb=2500")
AT_ONCE = 2


def row_of(target: Path, seconds: int) -> dict[str, Any]:
    subject = target.name.removeprefix("fuzz_")
    done = fuzz(target, seconds, BUILD / "corpus" / subject, SEEDS / subject, *FLAGS)
    executed = re.search(r"stat::number_of_executed_units:\s*(\d+)", done.log)
    return {
        "target": done.target,
        "code": done.code,
        "seconds": round(done.seconds, 1),
        "executions": int(executed[1]) if executed else 0,
        "edges covered": done.edges,
        "findings": done.findings,
        "clean": done.clean,
    }


def run(findings: Findings, quick: bool) -> None:
    targets = build(BUILD, "tests/fuzzing")
    seconds = QUICK_SECONDS if quick else SECONDS
    with ThreadPoolExecutor(AT_ONCE) as pool:
        rows = list(pool.map(lambda target: row_of(target, seconds), targets))
    findings.figures = {"seconds each": seconds, "targets": rows}
    for row in rows:
        reached = ", ".join(row["findings"]) or f"{row['executions']} executions, none"
        findings.law(f"{row['target']}: findings", row["clean"], "none", reached)
        runs = row["executions"]
        findings.law(f"{row['target']}: executions", runs > 100, "more than 100", runs)
