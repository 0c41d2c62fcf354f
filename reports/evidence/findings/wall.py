"""Each program of degeneracies/findings with its library, and a judge that stands alone."""

from __future__ import annotations

import subprocess
import sys

from minkref.reports.evidence.framework.part import Findings, Minutes, Size
from minkref.reports.findings.entry import FOLDER, entries
from minkref.reports.findings.running import ABSENT, MENDED, STILL, ran

RESTS_ON = ("degeneracies/findings/", "fuzz/libraries/")
MINUTES = Minutes(0.1, 0.5, 8)


def run(findings: Findings, size: Size) -> None:
    words = [sys.executable, str(FOLDER / "judge.py"), str(FOLDER / "findings.json")]
    judged = subprocess.run(words, capture_output=True, text=True, check=False)
    lines = judged.stdout.splitlines()
    refuted = [line for line in lines if not line.endswith("confirmed")]
    findings.none(f"of {len(lines)} witnesses in the plane, refuted in fractions", refuted)
    states: dict[str, list[str]] = {STILL: [], MENDED: [], ABSENT: []}
    for entry in entries():
        states[ran(entry, compiling=size is Size.FULL).state].append(entry.id)
    findings.figures["findings"] = len(entries())
    findings.figures["libraries"] = len({entry.library for entry in entries()})
    for state, names in states.items():
        findings.figures[state] = len(names)
    findings.none("mended, so the page has to say so", states[MENDED])
    if states[ABSENT]:
        findings.note(f"not run: {', '.join(states[ABSENT])}")
