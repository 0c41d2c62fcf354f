"""`minkref` and pytest as children, as their users run them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework.part import Findings
from minkref.reports.evidence.framework.places import ROOT

COMMAND = (sys.executable, "-m", "minkref")
GRACE = 900.0  # seconds beyond a run's limit
Document = dict[str, Any]
# A child's largest size begins at that of the process that starts it: a small one starts it.
METER = """
import os, sys
_, status, used = os.wait4(os.spawnvp(os.P_NOWAIT, sys.argv[2], sys.argv[2:]), 0)
with open(sys.argv[1], "w") as told:
    print(used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, file=told)
sys.exit(os.waitstatus_to_exitcode(status) & 255)
"""


@dataclass(frozen=True)
class Cost:
    seconds: float  # of the processor, user and system
    mib: float  # at most resident


def cost(command: Sequence[str], cwd: Path | None = None) -> Cost:
    """What the command takes; its output is discarded. Raises RuntimeError where it ends badly."""
    with tempfile.NamedTemporaryFile("r") as told, tempfile.TemporaryFile("w+") as said:
        metered = [sys.executable, "-I", "-S", "-c", METER, told.name, *command]
        code = subprocess.call(metered, cwd=cwd, stdout=subprocess.DEVNULL, stderr=said)
        if code:
            said.seek(0)
            raise RuntimeError(f"{' '.join(command)}: exit code {code}: {said.read()[-500:]}")
        return Cost(*map(float, told.read().split()))


def minkref(*words: object, seconds: float | None = None, **variables: str) -> tuple[int, Document]:
    """Exit code and document, with these extra environment variables. Raises RuntimeError without a
    document, subprocess.TimeoutExpired after `seconds`."""
    ran = subprocess.run(
        [*COMMAND, *map(str, words), "--json"], capture_output=True, text=True, timeout=seconds,
        env={**os.environ, **variables},
    )  # fmt: skip
    try:
        value: Document = json.loads(ran.stdout)
    except ValueError as error:
        raise RuntimeError(f"exit code {ran.returncode}: {ran.stderr[-2000:]}") from error
    return ran.returncode, value


def verify(*words: object, seconds: float, path: Path | None = None) -> tuple[int, Document]:
    """Runs `minkref verify` for so many seconds. `path` precedes PYTHONPATH."""
    return minkref("verify", *words, seconds=seconds + GRACE, **searched(path))


def first_found(
    target: str, seconds: int, *words: object, path: Path | None = None
) -> tuple[bool, Document]:
    """Whether a one-core search, which ends at the first finding, finds anything."""
    more = ("--first", "--seconds", seconds, "--jobs", 1, "--no-models", *words)
    code, value = verify(target, *more, seconds=seconds, path=path)
    return code in (1, 3), value


def searched(path: Path | None) -> dict[str, str]:
    """Variables with `path` before PYTHONPATH."""
    before = os.environ.get("PYTHONPATH", "")
    return {} if path is None else {"PYTHONPATH": f"{path}{os.pathsep}{before}"}


def begun(
    ledger: Path, *arguments: str, path: Path | None = None, **variables: str
) -> subprocess.Popen[str]:
    """A run on a ledger, in its own session, whose document goes to a pipe."""
    words = [*COMMAND, "verify", *arguments, "--no-models", "--jobs", "2", "--shrink-calls", "0"]
    return subprocess.Popen(
        [*words, "--json", "--ledger", str(ledger)],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        start_new_session=True,
        env={**os.environ, **searched(path), **variables},
    )


def counts_of(value: Document, target: str) -> dict[str, int]:
    """Verdicts of a target over all groups."""
    counts: dict[str, int] = {}
    for row in value["matrix"]:
        if row["target"] == target:
            for verdict, count in row["verdicts"].items():
                counts[verdict] = counts.get(verdict, 0) + count
    return counts


def told(counts: dict[str, int]) -> str:
    return ", ".join(f"{count:,} {verdict}" for verdict, count in counts.items())


def tests_pass(findings: Findings, what: str, path: str) -> str:
    """The law that pytest passes these tests; returns pytest's last line."""
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:xdist", path]
    ran = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    tail = ran.stdout.strip().splitlines()[-1] if ran.stdout.strip() else ran.stderr[-200:]
    findings.law(what, ran.returncode == 0, "all pass", tail)
    return tail
