"""Faults put into the reference, and which judge, law or test catches each.

The preset `faults` builds the reference with faults that the environment variable MINKREF_FAULT
switches on (reference/fault.hpp). Each is put before the laws and tests of the reference, its
own routes against each other, and the judges of `minkref verify minkref`.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from minkref.fuzz.plane.judgement import TRUTHS
from minkref.reports.evidence.framework.part import CGAL, COMPARISON, REFERENCE, SCRIPTS, Findings
from minkref.reports.evidence.framework.store import ROOT

SUBJECT = (
    "At least 25 faults put into the reference, one at a time: each is caught by a judge, a law or "
    "a test; a table says by which."
)
MINUTES = (35, None)
DEPENDS = (
    *REFERENCE, *COMPARISON, *CGAL, "tests/*/*.?pp", "tests/plane/*.py", "tests/dynamic/*.py",
    "oracle/slow/*.py", "oracle/symbolic/*.py",
)  # fmt: skip

BUILD = ROOT / "build" / "faults"
TABLE = SCRIPTS / "planted_faults.md"
SUITES = ("plane", "critical", "dynamic", "index")
PYTEST_FOLDERS = ("tests/plane", "tests/dynamic")
ROUTES = TRUTHS
PAIRS = 60
SUITE_SECONDS, VERIFY_SECONDS, PYTEST_SECONDS = 300, 150, 150
FEWEST = 25
JOBS = 2


@dataclass
class Caught:
    """By whom: names of targets of `verify`, of suites and of tests."""

    judges: list[str] = field(default_factory=list)
    routes: list[str] = field(default_factory=list)
    tests: list[str] = field(default_factory=list)

    def __bool__(self) -> bool:
        return bool(self.judges or self.routes or self.tests)


def listed() -> dict[str, str]:
    """Every fault and what is wrong with it, in the order of reference/fault.hpp."""
    text = (ROOT / "reference" / "fault.hpp").read_text(encoding="utf-8").replace("\\\n", " ")
    return dict(re.findall(r'X\(\s*(\w+),\s*"([^"]+)"\s*\)', text))


def build() -> None:
    for command in (
        ["cmake", "--preset", "faults", f"-DPython_EXECUTABLE={sys.executable}"],
        ["cmake", "--build", str(BUILD), "-j", "2"],
        [sys.executable, "scripts/link_package.py", str(BUILD)],
    ):
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        if done.returncode:
            raise RuntimeError(f"{' '.join(command)}: {(done.stderr or done.stdout)[-2000:]}")


def ended(
    fault: str, seconds: float, *command: str | Path
) -> subprocess.CompletedProcess[str] | None:
    """A command with the fault put in; None where it does not end."""
    variables = {**os.environ, "MINKREF_FAULT": fault, "PYTHONPATH": str(BUILD / "package")}
    try:
        return subprocess.run(
            command, cwd=ROOT, env=variables, capture_output=True, text=True, errors="replace",
            check=False, timeout=seconds,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return None


def laws(fault: str) -> list[str]:
    """The first test of each suite of the reference that fails; a suite that ends by a signal, or
    not at all, has caught it too."""
    failed = []
    for suite in SUITES:
        with tempfile.NamedTemporaryFile(suffix=".json") as report:
            done = ended(
                fault, SUITE_SECONDS, BUILD / "tests" / suite / f"test_{suite}",
                f"--gtest_output=json:{report.name}", "--gtest_fail_fast",
            )  # fmt: skip
            if done is None:
                failed.append(f"{suite}: no end in {SUITE_SECONDS} s")
                continue
            text = Path(report.name).read_text(encoding="utf-8")
        found = [
            f"{test['classname']}.{test['name']}"
            for group in (json.loads(text)["testsuites"] if text else [])
            for test in group["testsuite"]
            if test.get("failures")
        ]
        if done.returncode and not found:
            found = [f"{suite}: exit code {done.returncode}"]
        failed += found
    return failed


def python_tests(fault: str) -> list[str]:
    """The first that fails of tight passages made by hand, and of parents by their definition."""
    words = ("-m", "pytest", "-qx", "-p", "no:cacheprovider", *PYTEST_FOLDERS)
    done = ended(fault, PYTEST_SECONDS, sys.executable, *words)
    if done is None:
        return [f"{' '.join(PYTEST_FOLDERS)}: no end"]
    found = re.findall(r"^(?:FAILED|ERROR) \S+?::(.+?)(?: - |$)", done.stdout, re.MULTILINE)
    return found or ([f"pytest: exit code {done.returncode}"] if done.returncode else [])


def before_judges(fault: str, caught: Caught) -> None:
    """The judges, and our own routes against each other, on the same cases."""
    words = ("-m", "minkref", "verify", "minkref", *ROUTES, "--pairs", str(PAIRS), "--no-models")
    more = ("--json", "--jobs", "1", "--shrink-calls", "0")
    done = ended(fault, VERIFY_SECONDS, sys.executable, *words, *more)
    try:
        matrix = json.loads(done.stdout if done is not None else "")["matrix"]
    except (ValueError, KeyError):
        caught.judges.append("verify: no end")
        return
    bad: Counter[str] = Counter()  # a row is a target on a family
    for row in matrix:
        bad[row["target"]] += sum(
            n for verdict, n in row["verdicts"].items() if verdict not in ("pass", "skipped")
        )
    for target, count in bad.items():
        if count:
            where = caught.routes if target in ROUTES else caught.judges
            where.append(f"{target.removeprefix('minkref@')} ({count})")


def put_in(fault: str) -> Caught:
    caught = Caught(tests=laws(fault) + python_tests(fault))
    before_judges(fault, caught)
    print(f"{fault or 'none'}: {'caught' if caught else 'not caught'}", flush=True)
    return caught


def run(findings: Findings, quick: bool) -> None:
    faults = listed()
    build()
    with ThreadPoolExecutor(JOBS) as pool:
        all_caught = dict(zip(["", *faults], pool.map(put_in, ["", *faults]), strict=True))
    without = all_caught.pop("")
    missed = [name for name, caught in all_caught.items() if not caught]
    by_judge = sum(bool(c.judges) for c in all_caught.values())
    by_test = sum(bool(c.tests) for c in all_caught.values())
    by_routes = sum(bool(c.routes) for c in all_caught.values())
    findings.figures |= {
        "pairs before the judges": PAIRS,
        "faults": {name: vars(caught) for name, caught in all_caught.items()},
        "alarms without a fault": vars(without),
    }
    findings.law("alarms without a fault", not without, "none", "none" if not without else without)
    findings.law("faults", len(faults) >= FEWEST, f"at least {FEWEST}", len(faults))
    findings.law("not caught", not missed, "none", ", ".join(missed) or "none")
    findings.target("caught by a judge", by_judge >= FEWEST, f"at least {FEWEST}", by_judge)
    findings.target("caught by a law or test", by_test >= FEWEST, f"at least {FEWEST}", by_test)
    findings.target("seen by our own routes", by_routes > 0, "some", by_routes)
    TABLE.write_text(table(faults, all_caught), encoding="utf-8")


def table(faults: dict[str, str], all_caught: dict[str, Caught]) -> str:
    lines = [
        "# Faults put into the reference",
        "",
        "Made by `make evidence ONLY=planted_faults`: each fault of `reference/fault.hpp`, put in "
        "alone, and what caught it. *Judges*: of `minkref verify minkref`, with the number of "
        f"the {PAIRS} random pairs, and of cases made from them, on which they saw it; a run ends "
        "where the reference itself gives up. *Routes*: routes of the reference refuted on the "
        "same pairs. *Laws and tests*: the first of each suite that fails.",
        "",
        "| fault | what is wrong | judges | routes | laws and tests |",
        "|---|---|---|---|---|",
    ]
    for name, what in faults.items():
        caught = all_caught[name]
        by = (", ".join(names) for names in (caught.judges, caught.routes, caught.tests))
        cells = [f"`{name}`", what, *by]
        lines.append("| " + " | ".join(cell or "-" for cell in cells) + " |")
    return "\n".join(lines) + "\n"
