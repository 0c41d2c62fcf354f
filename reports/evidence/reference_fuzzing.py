"""libFuzzer on the reference itself, over pairs of operands, with the address and undefined
behaviour sanitizers."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework.part import READERS, REFERENCE, Findings
from minkref.reports.evidence.framework.store import FOLDER, ROOT
from minkref.reports.evidence.parser_fuzzing import has_fuzzer

SUBJECT = (
    "libFuzzer (clang, address and undefined behaviour sanitizers) on the static sum, the dynamic "
    "sum, the pair events and the tight passages, over pairs of operands, 5 minutes each: no "
    "finding left."
)
MINUTES = (22, None)
DEPENDS = (*REFERENCE, *READERS, "tests/fuzzing/**/*")

SECONDS = 300
BUILD = ROOT / "build" / "fuzzing_reference"
SEEDS = ROOT / "tests" / "fuzzing" / "corpus" / "pair"
AT_ONCE = 2
VALID_SHARE = 0.9
COUNTED = re.compile(r"pairs: inputs (\d+) valid (\d+) refused (\d+) too_large (\d+) no_case (\d+)")


def build() -> list[Path]:
    """Builds the targets with clang; gives the executables."""
    if not has_fuzzer():
        packages = ["clang", "libclang-rt-14-dev"]
        subprocess.run(["scripts/require_packages.sh", *packages], cwd=ROOT, check=True)
    options = [
        "-DMINKREF_FUZZ=ON",
        "-DMINKREF_FUZZ_REFERENCE=ON",
        "-DMINKREF_CGAL=OFF",
        "-DMINKREF_PYTHON=OFF",
        "-DMINKREF_TESTS=OFF",
        "-DCMAKE_BUILD_TYPE=RelWithDebInfo",
        "-DCMAKE_CXX_COMPILER=clang++",
    ]
    configure = ["cmake", "-S", str(ROOT), "-B", str(BUILD), "-G", "Ninja", *options]
    subprocess.run(configure, check=True)
    make = ["cmake", "--build", str(BUILD), "-j", "2", "--target", "fuzz_reference_targets"]
    subprocess.run(make, check=True)
    folder = BUILD / "tests" / "fuzzing" / "reference"
    found = sorted(
        path for path in folder.glob("fuzz_*") if path.is_file() and os.access(path, os.X_OK)
    )
    if not found:
        raise RuntimeError(f"no fuzz target was built in {folder}")
    return found


def fuzz(target: Path, seconds: int) -> dict[str, Any]:
    """One target for so many seconds, from the seeds and what earlier runs found."""
    corpus = BUILD / "corpus" / target.name.removeprefix("fuzz_")
    corpus.mkdir(parents=True, exist_ok=True)
    artifacts = FOLDER / "fuzzing" / target.name
    shutil.rmtree(artifacts, ignore_errors=True)
    artifacts.mkdir(parents=True)
    command = [str(target), str(corpus), str(SEEDS), f"-max_total_time={seconds}", "-max_len=8192",
               "-len_control=0", "-entropic=0", "-print_funcs=0", "-detect_leaks=0", "-timeout=60",
               "-rss_limit_mb=3000", "-print_final_stats=1",
               f"-artifact_prefix={artifacts}/"]  # fmt: skip
    began = time.monotonic()
    log = artifacts / "log.txt"
    with open(log, "w", encoding="utf-8") as out:
        code = subprocess.run(
            command, stdout=out, stderr=out, timeout=10 * seconds + 300, cwd=artifacts
        ).returncode
    text = log.read_text(encoding="utf-8", errors="replace")
    spent = time.monotonic() - began
    covered = re.findall(r"cov: (\d+)", text)
    counted = COUNTED.findall(text)
    inputs, valid, refused, too_large, no_case = map(int, counted[-1] if counted else "00000")
    law = re.search(r"^broken law: .*", text, re.MULTILINE)
    return {
        "target": target.name,
        "code": code,
        "seconds": round(spent, 1),
        "executions": inputs,
        "executions a second": round(inputs / spent),
        "valid pairs": valid,
        "refused": refused,
        "too large": too_large,
        "no case": no_case,
        "edges covered": int(covered[-1]) if covered else 0,
        "kept inputs": sum(1 for _ in corpus.iterdir()),
        "findings": [path.name for path in artifacts.iterdir() if path != log],
        "law": law[0] if law else "",
    }


def run(quick: bool) -> Findings:
    findings = Findings()
    targets = build()
    with ThreadPoolExecutor(AT_ONCE) as pool:
        rows = list(pool.map(lambda target: fuzz(target, SECONDS), targets))
    findings.figures = {"seconds each": SECONDS, "targets": rows}
    for row in rows:
        name, runs, valid = row["target"], row["executions"], row["valid pairs"]
        clean = row["code"] == 0 and not row["findings"]
        reached = ", ".join([*row["findings"], row["law"]]) or "stopped"
        if clean:
            reached = f"none on {valid} valid pairs; {row['edges covered']} edges covered"
        findings.law(f"{name}: findings", clean, "none", reached)
        findings.law(f"{name}: executions", runs > 1000, "more than 1000", runs)
        share = valid / runs if runs else 0.0
        findings.target(f"{name}: share of valid pairs", share >= VALID_SHARE,
                        f"at least {VALID_SHARE:.0%}", f"{share:.1%}")  # fmt: skip
    return findings
