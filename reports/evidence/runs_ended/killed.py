"""Kills runs by SIGKILL at random moments and resumes them from their ledgers: runs of a function,
and of a sandboxed adapter."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import tempfile
import time
import uuid
from pathlib import Path
from typing import Any

from minkref.fuzz.isolation.control_group import find_rooms
from minkref.fuzz.isolation.process_tree import descendants
from minkref.fuzz.isolation.sandbox import absence
from minkref.reports.evidence.framework.command import begun
from minkref.reports.evidence.framework.of_tests import SEEDED, losing_a_hole, seeded_adapter
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("tests/adapters/seeded/",)
MINUTES = Minutes(None, 1.2, 23)

SEED = 11
KILLS, CASES = Counts(0, 3, 20), Counts(0, 200, 700)
KILLS_IN_SANDBOX, CASES_IN_SANDBOX = Counts(0, 5, 50), 150
MARK = "MINKREF_EVIDENCE_MARK"
PATIENCE = 5.0  # seconds until a killed process must be gone


def start(ledger: Path, mark: str, words: tuple[str, ...]) -> subprocess.Popen[str]:
    variables = {MARK: mark, "TMPDIR": str(ledger.parent / "temporary")}
    return begun(ledger, *words, "--seed", str(SEED), path=SEEDED, **variables)


def findings_of(text: str) -> list[str]:
    value: dict[str, Any] = json.loads(text)
    return sorted(
        json.dumps([f["target"], f["case"], f["verdict"], f["reasons"], f["witness"]])
        for f in value["findings"]
    )


def results_in(ledger: Path) -> set[str]:
    """A ledger's whole lines without the first line; each of them has been reported."""
    if not ledger.is_file():
        return set()
    whole = ledger.read_text(encoding="utf-8").rpartition("\n")[0]
    return set(whole.split("\n")[1:])


def running(mark: str) -> int:
    """Counts a run's processes, including its adapters."""
    count = 0
    for entry in Path("/proc").iterdir():
        if entry.name.isdecimal():
            try:
                count += f"{MARK}={mark}".encode() in (entry / "environ").read_bytes()
            except OSError:
                continue
    return count


def left(mark: str) -> int:
    deadline = time.monotonic() + PATIENCE
    while (count := running(mark)) and time.monotonic() < deadline:
        time.sleep(0.02)
    return count


def groups_of(owners: list[int]) -> list[Path]:
    """Control groups made by these processes."""
    rooms = find_rooms()
    found = (room.folder.glob(f"minkref-{owner}-*") for owner in owners for room in rooms)
    return [path for paths in found for path in paths]


def run(findings: Findings, size: Size) -> None:
    hole = losing_a_hole()
    words: tuple[str, ...] = (
        f"py:seeded_sums:{hole}",
        "minkref:winding",
        "--pairs",
        str(size.of(CASES)),
    )
    _killed(findings, "a function", words, size.of(KILLS))
    why = absence()
    if why is not None:
        findings.target("a sandbox", False, "available", why)
        return
    words = (seeded_adapter(hole), "--isolation", "sandbox", "--pairs", str(CASES_IN_SANDBOX))
    _killed(findings, "an adapter in the sandbox", words, size.of(KILLS_IN_SANDBOX))


def _killed(findings: Findings, what: str, words: tuple[str, ...], kills: int) -> None:
    dice = random.Random(SEED)
    with tempfile.TemporaryDirectory(prefix="killed-runs-") as folder:
        Path(folder, "temporary").mkdir()
        since = time.monotonic()
        expected = findings_of(start(Path(folder, "whole"), "none", words).communicate()[0])
        seconds = time.monotonic() - since
        findings.figures[f"{what}: findings of the undisturbed run"] = len(expected)
        lost = different = killed = processes = groups = 0
        for number in range(kills):
            ledger, mark = Path(folder, str(number)), uuid.uuid4().hex
            process = start(ledger, mark, words)
            try:
                process.communicate(timeout=dice.uniform(0.05, 0.95) * seconds)
            except subprocess.TimeoutExpired:
                killed += 1
            written = results_in(ledger)
            owners = [process.pid, *descendants(process.pid)]
            if number % 2:
                os.killpg(process.pid, signal.SIGKILL)
            else:
                process.send_signal(signal.SIGKILL)
            process.communicate()
            processes += left(mark)
            resumed = start(ledger, mark, words)
            different += findings_of(resumed.communicate()[0]) != expected
            lost += len(written - results_in(ledger))
            processes += left(mark)
            groups += len(groups_of([*owners, resumed.pid]))
        files = list(Path(folder, "temporary").iterdir())
    findings.law(f"{what}: runs killed before their end", killed > 0, "some", killed)
    findings.none(f"{what}: results that were reported and are lost", lost)
    findings.none(f"{what}: resumed runs with other findings", different)
    findings.none(f"{what}: processes left behind", processes)
    findings.none(f"{what}: control groups left behind", groups)
    findings.none(f"{what}: temporary files left behind", len(files))
