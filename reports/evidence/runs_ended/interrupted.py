"""Ends runs by Ctrl-C at random moments, and checks their output."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework.command import COMMAND, searched
from minkref.reports.evidence.framework.of_tests import SEEDED, losing_a_hole
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 0.5, 3)

MOMENTS = Counts(0, 4, 20)
LONGEST = 6.0  # seconds until Ctrl-C, after the first result
SEED = 31


def interrupted(folder: Path, target: str, seconds: float) -> tuple[int, dict[str, Any]]:
    words = [*COMMAND, "verify", target, "minkref:winding", "--seconds", "300", "--no-models"]
    words += ["--jobs", "2", "--shrink-calls", "20", "--ledger", "run.jsonl", "--json"]
    process = subprocess.Popen(
        [*words, "--report", "report", "--junit", "junit.xml"],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        env={**os.environ, **searched(SEEDED)},
    )
    while not results(folder) and process.poll() is None:
        time.sleep(0.02)
    time.sleep(seconds)
    process.send_signal(signal.SIGINT)
    text, _ = process.communicate()
    value: dict[str, Any] = json.loads(text)
    return process.returncode, value


def results(folder: Path) -> list[dict[str, Any]]:
    path = folder / "run.jsonl"
    if not path.is_file():
        return []
    rows = [json.loads(line) for line in path.read_text().split("\n")[1:-1]]
    return [row for row in rows if "absent" not in row and "untaken" not in row]


def complete(folder: Path, value: dict[str, Any]) -> bool:
    judged: Counter[tuple[str, str]] = Counter()
    wrong = set()
    for row in results(folder):
        for outcome in row["outcomes"]:
            judged[outcome["target"], outcome["verdict"]] += 1
            if outcome["verdict"] == "wrong":
                wrong.add((outcome["target"], row["name"]["text"]))
    shown: Counter[tuple[str, str]] = Counter()
    for cell in value["matrix"]:
        shown.update({(cell["target"], v): n for v, n in cell["verdicts"].items()})
    found = {(f["target"], f["case"]) for f in value["findings"]}
    written = (folder / "junit.xml").is_file() and (folder / "report" / "index.html").is_file()
    return shown == judged and found == wrong and written


def run(findings: Findings, size: Size) -> None:
    dice = random.Random(SEED)
    target = f"py:seeded_sums:{losing_a_hole()}"
    incomplete = unusual = 0
    cases: list[int] = []
    with tempfile.TemporaryDirectory(prefix="minkref-interrupted-") as parent:
        for number in range(size.of(MOMENTS)):
            folder = Path(parent, str(number))
            folder.mkdir()
            code, value = interrupted(folder, target, dice.uniform(0, LONGEST))
            unusual += code != 128 + signal.SIGINT or value["ended_by"] != "SIGINT"
            incomplete += not complete(folder, value)
            cases.append(sum(group["cases"] for group in value["groups"]))
    findings.figures["cases judged before the end"] = f"{min(cases):,} to {max(cases):,}"
    findings.none("runs that ended otherwise", unusual)
    findings.none("runs whose report is not what was judged", incomplete)
