"""libFuzzer on the reference itself, over pairs of operands in the plane and of convex bodies, with
the address and undefined behaviour sanitizers."""

from __future__ import annotations

import re
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework.libfuzzer import build, fuzz
from minkref.reports.evidence.framework.part import Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT

RESTS_ON = ("formats/", "reference/", "tests/fuzzing/")
MINUTES = Minutes(None, None, 28)

SECONDS = 300
BUILD = ROOT / "build" / "fuzzing_reference"
SEEDS = ROOT / "tests" / "fuzzing" / "corpus"
OF_BODIES = "fuzz_convex"
FLAGS = (
    "-len_control=0",
    "-entropic=0",
    "-print_funcs=0",
    "-detect_leaks=0",
    "-timeout=60",
    "-rss_limit_mb=3000",
)
# Most input bytes: for a case file; for the targets on convex bodies.
MOST_BYTES, MOST_BYTES_OF_BODIES = 8192, 256
AT_ONCE = 2
VALID_SHARE = 0.9
COUNTED = re.compile(r"pairs: inputs (\d+) valid (\d+) refused (\d+) too_large (\d+) no_case (\d+)")


def row_of(target: Path, seconds: int) -> dict[str, Any]:
    corpus = BUILD / "corpus" / target.name.removeprefix("fuzz_")
    bodies = target.name.startswith(OF_BODIES)
    most = MOST_BYTES_OF_BODIES if bodies else MOST_BYTES
    seeds = SEEDS / ("bodies" if bodies else "pair")
    done = fuzz(target, seconds, corpus, seeds, f"-max_len={most}", *FLAGS)
    counted = COUNTED.findall(done.log)
    inputs, valid, refused, too_large, no_case = map(int, counted[-1] if counted else "00000")
    law = re.search(r"^broken law: .*", done.log, re.MULTILINE)
    return {
        "target": done.target,
        "code": done.code,
        "seconds": round(done.seconds, 1),
        "executions": inputs,
        "executions a second": round(inputs / done.seconds),
        "valid pairs": valid,
        "refused": refused,
        "too large": too_large,
        "no case": no_case,
        "edges covered": done.edges,
        "kept inputs": sum(1 for _ in corpus.iterdir()),
        "findings": done.findings,
        "clean": done.clean,
        "law": law[0] if law else "",
    }


def run(findings: Findings, size: Size) -> None:
    targets = build(
        BUILD,
        "tests/fuzzing/reference",
        "-DMINKREF_FUZZ_REFERENCE=ON",
        target="fuzz_reference_targets",
    )
    with ThreadPoolExecutor(AT_ONCE) as pool:
        rows = list(pool.map(lambda target: row_of(target, SECONDS), targets))
    findings.figures = {"seconds each": SECONDS, "targets": rows}
    for row in rows:
        name, runs, valid = row["target"], row["executions"], row["valid pairs"]
        reached = ", ".join([*row["findings"], row["law"]]) or "stopped"
        if row["clean"]:
            reached = f"none on {valid} valid pairs; {row['edges covered']} edges covered"
        findings.law(f"{name}: findings", row["clean"], "none", reached)
        findings.law(f"{name}: executions", runs > 1000, "more than 1000", runs)
        share = valid / runs if runs else 0.0
        wanted = f"at least {VALID_SHARE:.0%}"
        findings.target(
            f"{name}: share of valid pairs", share >= VALID_SHARE, wanted, f"{share:.1%}"
        )
