"""libFuzzer on every reader, with the address and undefined behaviour sanitizers."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework.part import READERS, Findings
from minkref.reports.evidence.framework.store import FOLDER, ROOT

SUBJECT = (
    "libFuzzer (clang, address and undefined behaviour sanitizers) on every parser, 5 minutes "
    "each: no finding left."
)
MINUTES = (18, 2.3)
DEPENDS = (*READERS, "reference/number/*.?pp", "reference/error.?pp", "tests/fuzzing/**/*")

SECONDS, QUICK_SECONDS = 300, 10
BUILD = ROOT / "build" / "fuzzing"
AT_ONCE = 2


def has_fuzzer() -> bool:
    """clang is here, with the libraries of its sanitizers and of libFuzzer."""
    source = 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }'
    flags = ["-fsanitize=fuzzer,address,undefined", "-x", "c++", "-", "-o", "/dev/null"]
    if shutil.which("clang++") is None:
        return False
    return subprocess.run(["clang++", *flags], input=source.encode()).returncode == 0


def build() -> list[Path]:
    """Builds the fuzz targets with clang; gives the executables."""
    if not has_fuzzer():
        packages = ["clang", "libclang-rt-14-dev"]
        subprocess.run(["scripts/require_packages.sh", *packages], cwd=ROOT, check=True)
    options = [
        "-DMINKREF_FUZZ=ON",
        "-DMINKREF_CGAL=OFF",
        "-DMINKREF_PYTHON=OFF",
        "-DMINKREF_TESTS=OFF",
        "-DCMAKE_BUILD_TYPE=RelWithDebInfo",
        "-DCMAKE_CXX_COMPILER=clang++",
    ]
    configure = ["cmake", "-S", str(ROOT), "-B", str(BUILD), "-G", "Ninja", *options]
    subprocess.run(configure, check=True)
    subprocess.run(["cmake", "--build", str(BUILD), "-j", "2"], check=True)
    found = sorted(
        path for path in BUILD.rglob("fuzz_*") if path.is_file() and os.access(path, os.X_OK)
    )
    if not found:
        raise RuntimeError(f"no fuzz target was built in {BUILD}")
    return found


def fuzz(target: Path, seconds: int) -> dict[str, Any]:
    """One target for so many seconds, from its seed corpus and what earlier runs found."""
    subject = target.name.removeprefix("fuzz_")
    corpus, seeds = BUILD / "corpus" / subject, ROOT / "tests" / "fuzzing" / "corpus" / subject
    corpus.mkdir(parents=True, exist_ok=True)
    artifacts = FOLDER / "fuzzing" / target.name
    shutil.rmtree(artifacts, ignore_errors=True)
    artifacts.mkdir(parents=True)
    command = [str(target), str(corpus), *([str(seeds)] if seeds.is_dir() else []),
               f"-max_total_time={seconds}", "-max_len=4096", "-timeout=20", "-rss_limit_mb=2500",
               "-print_final_stats=1", f"-artifact_prefix={artifacts}/"]  # fmt: skip
    began = time.monotonic()
    log = artifacts / "log.txt"
    with open(log, "w", encoding="utf-8") as out:
        code = subprocess.run(
            command, stdout=out, stderr=out, timeout=10 * seconds + 300, cwd=artifacts
        ).returncode
    text = log.read_text(encoding="utf-8", errors="replace")
    executed = re.search(r"stat::number_of_executed_units:\s*(\d+)", text)
    covered = re.findall(r"cov: (\d+)", text)
    kept = [path.name for path in artifacts.iterdir() if path != log]
    return {
        "target": target.name,
        "code": code,
        "seconds": round(time.monotonic() - began, 1),
        "executions": int(executed[1]) if executed else 0,
        "edges covered": int(covered[-1]) if covered else 0,
        "findings": kept,
    }


def run(quick: bool) -> Findings:
    findings = Findings()
    targets = build()
    seconds = QUICK_SECONDS if quick else SECONDS
    with ThreadPoolExecutor(AT_ONCE) as pool:
        rows = list(pool.map(lambda target: fuzz(target, seconds), targets))
    findings.figures = {"seconds each": seconds, "targets": rows}
    for row in rows:
        clean = row["code"] == 0 and not row["findings"]
        reached = ", ".join(row["findings"]) or f"{row['executions']} executions, none"
        findings.law(f"{row['target']}: findings", clean, "none", reached)
        runs = row["executions"]
        findings.law(f"{row['target']}: executions", runs > 100, "more than 100", runs)
    return findings
