"""Runs libFuzzer on every reader, also for polyhedra and index files, with the address and
undefined behaviour sanitizers."""

from __future__ import annotations

import re
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework.libfuzzer import Fuzzed, build, fuzz
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT

RESTS_ON = ("formats/", "reference/number/", "reference/space/", "tests/fuzzing/")
MINUTES = Minutes(None, 2.5, 26)  # it builds

SECONDS = Counts(0, 8, 300)
FOLDER = ROOT / "build" / "fuzzing"
BUILT = ROOT / "build" / "release" / "reference" / "libminkref_reference.a"
SEEDS = ROOT / "tests" / "fuzzing" / "corpus"
FLAGS = ("-max_len=4096", "-timeout=20", "-rss_limit_mb=2500")
AT_ONCE = 2
LEAST = 100  # executions


def executions(done: Fuzzed) -> int:
    executed = re.search(r"stat::number_of_executed_units:\s*(\d+)", done.log)
    return int(executed[1]) if executed else 0


def row_of(target: Path, seconds: int) -> dict[str, Any]:
    """On a busy machine a short time may be too short: it then goes on to the least number."""
    subject = target.name.removeprefix("fuzz_")
    corpus, seeds = FOLDER / "corpus" / subject, SEEDS / subject
    done = fuzz(target, seconds, corpus, seeds, *FLAGS)
    if done.clean and executions(done) <= LEAST and seconds < SECONDS.full:
        done = fuzz(target, SECONDS.full, corpus, seeds, *FLAGS, f"-runs={LEAST + 1}")
    return {
        "target": done.target,
        "code": done.code,
        "seconds": round(done.seconds, 1),
        "executions": executions(done),
        "edges covered": done.edges,
        "findings": done.findings,
        "clean": done.clean,
    }


def run(findings: Findings, size: Size) -> None:
    if (
        size is not Size.FULL
    ):  # only the readers: the whole reference would take a core half an hour
        targets = build(FOLDER / "readers", "tests/fuzzing", f"-DMINKREF_REFERENCE_ARCHIVE={BUILT}")
        findings.note("Of the code, the readers are instrumented, and the reference is not.")
    else:
        targets = build(FOLDER, "tests/fuzzing")
    seconds = size.of(SECONDS)
    with ThreadPoolExecutor(AT_ONCE) as pool:
        rows = list(pool.map(lambda target: row_of(target, seconds), targets))
    findings.figures = {"seconds each": seconds, "targets": rows}
    for row in rows:
        reached = ", ".join(row["findings"]) or f"{row['executions']} executions, none"
        findings.law(f"{row['target']}: findings", row["clean"], "none", reached)
        runs = row["executions"]
        findings.law(f"{row['target']}: executions", runs > LEAST, f"more than {LEAST}", runs)
