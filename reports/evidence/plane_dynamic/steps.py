"""Calls and counts for a dynamic sum's step."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT

MINUTES = Minutes(0.05, 0.2, 0.5)

BUILD = ROOT / "build" / "release" / "tests" / "plane" / "dynamic"
COUNTS = "DynamicWalk.InsertionsDeletionsAndSwapsAreTheEventsCrossed"
REPEAT = Counts(1, 6, 20)  # times 80 pairs of operands, 5 counted steps each
SECONDS = 600


def undefined_symbols(library: Path) -> list[str]:
    """Project symbols that a shared library imports."""
    done = subprocess.run(
        ["nm", "--dynamic", "--demangle", "--undefined-only", str(library)],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    return [line.strip() for line in done.stdout.splitlines() if " minkref::" in line]


def run(findings: Findings, size: Size) -> None:
    library = BUILD / "libminkref_step.so"
    missing = undefined_symbols(library)
    findings.none("undefined symbols of ours in the library of a step", len(missing))
    repeat = size.of(REPEAT)
    done = subprocess.run(
        [str(BUILD / "test_plane_dynamic"), f"--gtest_filter={COUNTS}"],
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
