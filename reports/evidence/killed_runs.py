"""Runs killed at random moments, and resumed."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework.command import begun
from minkref.reports.evidence.framework.of_tests import SEEDED, losing_a_hole
from minkref.reports.evidence.framework.part import COMPARISON, READERS, REFERENCE, Findings

SUBJECT = (
    "A run killed by SIGKILL at 20 random moments and resumed from its ledger: nothing reported is "
    "lost, and the findings are those of an undisturbed run of the same seed."
)
MINUTES = (8, None)
DEPENDS = (*REFERENCE, *READERS, *COMPARISON, "tests/seeded/*.py")

KILLS = 20
CASES = 700
SEED = 11


def start(ledger: Path, target: str) -> subprocess.Popen[str]:
    words = (target, "minkref:winding", "--pairs", str(CASES), "--seed", str(SEED))
    return begun(ledger, *words, PYTHONPATH=str(SEEDED))


def findings_of(text: str) -> list[str]:
    value: dict[str, Any] = json.loads(text)
    return sorted(
        json.dumps([f["target"], f["case"], f["verdict"], f["reasons"], f["witness"]])
        for f in value["findings"]
    )


def results_in(ledger: Path) -> set[str]:
    """The whole lines of a ledger but its first, each of which has been reported."""
    if not ledger.is_file():
        return set()
    whole = ledger.read_text(encoding="utf-8").rpartition("\n")[0]
    return set(whole.split("\n")[1:])


def run(findings: Findings, _: bool) -> None:
    dice = random.Random(SEED)
    target = f"py:seeded_sums:{losing_a_hole()}"
    with tempfile.TemporaryDirectory(prefix="minkref-ledger-") as folder:
        since = time.monotonic()
        whole = start(Path(folder, "whole"), target)
        expected = findings_of(whole.communicate()[0])
        seconds = time.monotonic() - since
        findings.figures["cases, findings of the undisturbed run"] = f"{CASES}, {len(expected)}"
        lost = different = killed = 0
        for number in range(KILLS):
            ledger = Path(folder, f"ledger-{number}")
            before: set[str] = set()
            process = start(ledger, target)
            try:
                process.communicate(timeout=dice.uniform(0.05, 0.95) * seconds)
            except subprocess.TimeoutExpired:
                killed += 1
            before = results_in(ledger)
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            resumed = start(ledger, target)
            text = resumed.communicate()[0]
            after = results_in(ledger)
            lost += len(before - after)
            different += findings_of(text) != expected
        findings.law("runs killed before their end", killed > 0, "some", killed)
        findings.none("results that were reported and are lost", lost)
        findings.none("resumed runs with other findings", different)
