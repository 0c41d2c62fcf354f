"""Runs of an adapter in the sandbox, killed at random moments, and resumed."""

from __future__ import annotations

import random
import signal
import subprocess
import tempfile
import time
import uuid
from pathlib import Path

from minkref.fuzz.isolation.control_group import find_rooms
from minkref.fuzz.isolation.process_tree import descendants
from minkref.fuzz.isolation.sandbox import absence
from minkref.reports.evidence.framework.command import begun
from minkref.reports.evidence.framework.of_tests import losing_a_hole, seeded_adapter
from minkref.reports.evidence.framework.part import COMPARISON, READERS, REFERENCE, Findings
from minkref.reports.evidence.killed_runs import findings_of, results_in

SUBJECT = (
    "A run with an adapter in the sandbox, killed by SIGKILL at 50 random moments and resumed from "
    "its ledger: the findings of an undisturbed run, no result lost, and no process, temporary "
    "file or control group left behind."
)
MINUTES = (15, None)
DEPENDS = (*REFERENCE, *READERS, *COMPARISON, "tests/seeded/*.py")

KILLS = 50
CASES = 150
SEED = 24
MARK = "MINKREF_EVIDENCE_MARK"
PATIENCE = 5.0  # seconds in which what was sent SIGKILL has to be gone


def start(ledger: Path, mark: str) -> subprocess.Popen[str]:
    words = (
        seeded_adapter(losing_a_hole()),
        "--isolation",
        "sandbox",
        "--pairs",
        str(CASES),
        "--seed",
        str(SEED),
    )
    return begun(ledger, *words, **{MARK: mark, "TMPDIR": str(ledger.parent / "temporary")})


def running(mark: str) -> int:
    """Processes of a run, its adapters among them."""
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
    """Control groups that these processes made."""
    rooms = find_rooms()
    found = (room.folder.glob(f"minkref-{owner}-*") for owner in owners for room in rooms)
    return [path for paths in found for path in paths]


def run(findings: Findings, _: bool) -> None:
    why = absence()
    if why is not None:
        findings.target("a sandbox", False, "available", why)
        return
    dice = random.Random(SEED)
    with tempfile.TemporaryDirectory(prefix="killed-runs-") as folder:
        Path(folder, "temporary").mkdir()
        since = time.monotonic()
        expected = findings_of(start(Path(folder, "whole"), "none").communicate()[0])
        seconds = time.monotonic() - since
        findings.figures["cases, findings of the undisturbed run"] = f"{CASES}, {len(expected)}"
        lost = different = killed = processes = groups = 0
        for number in range(KILLS):
            ledger, mark = Path(folder, str(number)), uuid.uuid4().hex
            process = start(ledger, mark)
            try:
                process.communicate(timeout=dice.uniform(0.05, 0.95) * seconds)
            except subprocess.TimeoutExpired:
                killed += 1
            written = results_in(ledger)
            owners = [process.pid, *descendants(process.pid)]
            process.send_signal(signal.SIGKILL)
            process.communicate()
            processes += left(mark)
            resumed = start(ledger, mark)
            different += findings_of(resumed.communicate()[0]) != expected
            lost += len(written - results_in(ledger))
            processes += left(mark)
            groups += len(groups_of([*owners, resumed.pid]))
        files = list(Path(folder, "temporary").iterdir())
    findings.figures["runs killed before their end"] = f"{killed} of {KILLS}"
    findings.law("runs killed before their end", killed > 0, "some", killed)
    findings.none("results that were reported and are lost", lost)
    findings.none("resumed runs with other findings", different)
    findings.none("processes left behind", processes)
    findings.none("control groups left behind", groups)
    findings.none("temporary files left behind", len(files))
