"""What a step of the dynamic sum calls, and what it counts."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

from minkref.reports.evidence.framework.part import REFERENCE, Findings
from minkref.reports.evidence.framework.store import ROOT

SUBJECT = (
    "A step calls nothing that computes from scratch: its sources link alone. Its insertions, "
    "deletions and swaps are the nodes that come, go and pass each other by their exact tracks, "
    "and the triple events crossed."
)
MINUTES = (0.5, 0.1)
DEPENDS = (*REFERENCE, "tests/dynamic/*", "tests/plane/random_cases.hpp")

BUILD = ROOT / "build" / "release" / "tests" / "dynamic"
COUNTS = "DynamicWalk.InsertionsDeletionsAndSwapsAreTheEventsCrossed"
REPEAT, QUICK_REPEAT = 20, 2  # times 80 pairs of operands, 5 counted steps each
SECONDS = 600


def undefined_symbols(library: Path) -> list[str]:
    """Those of the project that a shared library leaves to somebody else."""
    done = subprocess.run(
        ["nm", "--dynamic", "--demangle", "--undefined-only", str(library)],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    return [line.strip() for line in done.stdout.splitlines() if " minkref::" in line]


def run(findings: Findings, quick: bool) -> None:
    library = BUILD / "libminkref_step.so"
    missing = undefined_symbols(library)
    findings.none("undefined symbols of ours in the library of a step", len(missing))
    repeat = QUICK_REPEAT if quick else REPEAT
    done = subprocess.run(
        [str(BUILD / "test_dynamic"), f"--gtest_filter={COUNTS}"],
        capture_output=True, text=True, check=False, timeout=SECONDS,
        env={**os.environ, "MINKREF_REPEAT": str(repeat)},
    )  # fmt: skip
    passed = re.search(r"\[  PASSED  \] 1 test", done.stdout) is not None
    steps = 80 * 5 * repeat
    findings.law(
        "steps whose counts are the events crossed", passed and done.returncode == 0, steps,
        steps if passed else done.stdout[-600:],
    )  # fmt: skip
    findings.figures |= {"undefined": missing, "steps": steps}
