"""Runs the C++ tests under the sanitizers: memory and undefined behaviour in all tests, races in
the tests of the index and its threads."""

from __future__ import annotations

import os
import re
import subprocess
import time
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path

from minkref.reports.evidence.framework.part import EVERYTHING, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import FOLDER, ROOT

RESTS_ON = EVERYTHING
MINUTES = Minutes(None, None, 60)

PRESETS = {"asan": "address and undefined behaviour", "tsan": "threads"}
LEAST_TESTS = {"asan": 500, "tsan": 25}
REPORT = re.compile(r"ERROR: (?:Address|Leak)Sanitizer|WARNING: ThreadSanitizer|runtime error:")
JOBS = "2"
ENVIRONMENT = {
    "UBSAN_OPTIONS": "print_stacktrace=1",
    "TSAN_OPTIONS": "halt_on_error=0:second_deadlock_stack=1",
}


@dataclass(frozen=True)
class Tests:
    """A preset's test results. `reports` are the first lines of the sanitizers' reports."""

    ran: int
    failed: list[str]
    skipped: list[str]
    reports: list[str]
    seconds: float


def build(preset: str) -> float:
    began = time.monotonic()
    if not (ROOT / "build" / preset / "build.ninja").is_file():
        subprocess.run(["cmake", "--preset", preset], cwd=ROOT, check=True)
    subprocess.run(["cmake", "--build", "--preset", preset, "-j", JOBS], cwd=ROOT, check=True)
    return time.monotonic() - began


def run_tests(preset: str) -> Tests:
    results = FOLDER / "sanitizers" / f"{preset}.xml"
    results.parent.mkdir(parents=True, exist_ok=True)
    results.unlink(missing_ok=True)
    began = time.monotonic()
    subprocess.run(
        ["ctest", "--preset", preset, "-j", JOBS, "--timeout", "900", "--output-junit", results],
        cwd=ROOT,
        env={**os.environ, **ENVIRONMENT},
        stdout=subprocess.DEVNULL,
        check=False,
    )
    return read(results, time.monotonic() - began)


def read(results: Path, seconds: float) -> Tests:
    """Reads ctest's JUnit file, which holds each test's output."""
    cases = ElementTree.parse(results).getroot().findall("testcase")
    by_status: dict[str, list[str]] = {}
    reports = []
    for case in cases:
        by_status.setdefault(case.get("status", ""), []).append(case.get("name", ""))
        said = case.findtext("system-out") or ""
        reports += [
            f"{case.get('name')}: {line.strip()}"
            for line in said.splitlines()
            if REPORT.search(line)
        ]
    failed = by_status.pop("fail", [])
    ran = len(failed) + len(by_status.pop("run", []))
    skipped = [name for names in by_status.values() for name in names]
    return Tests(ran, failed, skipped, reports, seconds)


def run(findings: Findings, size: Size) -> None:
    for preset, subject in PRESETS.items():
        built = build(preset)
        tests = run_tests(preset)
        findings.figures[subject] = {
            "tests": tests.ran,
            "failed": tests.failed,
            "skipped": tests.skipped,
            "reports": tests.reports,
            "seconds of the build": round(built),
            "seconds of the tests": round(tests.seconds),
        }
        least = LEAST_TESTS[preset]
        findings.law(f"{subject}: tests", tests.ran >= least, f"at least {least}", tests.ran)
        shown = "; ".join(tests.reports[:5]) or f"none in {tests.ran} tests"
        findings.law(f"{subject}: reports", not tests.reports, "none", shown)
        shown = ", ".join(tests.failed[:5]) or "none"
        findings.law(f"{subject}: tests that fail", not tests.failed, "none", shown)
        if tests.skipped:
            findings.note(f"{subject}: skipped: {', '.join(tests.skipped)}.")
