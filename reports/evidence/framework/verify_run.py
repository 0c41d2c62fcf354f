"""`minkref verify` as a child, as its users run it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

COMMAND = (sys.executable, "-m", "minkref")
GRACE = 900.0  # seconds beyond what a run is given


def verify(
    *arguments: str | Path, seconds: float, path: Path | None = None
) -> tuple[int, dict[str, Any]]:
    """Exit code and document. `path` is put before PYTHONPATH. RuntimeError where there is no
    document."""
    words = [*COMMAND, "verify", *(str(argument) for argument in arguments), "--json"]
    environment = dict(os.environ)
    if path is not None:
        environment["PYTHONPATH"] = f"{path}{os.pathsep}{environment.get('PYTHONPATH', '')}"
    ran = subprocess.run(
        words, capture_output=True, text=True, timeout=seconds + GRACE, env=environment
    )
    try:
        value: dict[str, Any] = json.loads(ran.stdout)
    except ValueError as error:
        raise RuntimeError(f"exit code {ran.returncode}: {ran.stderr[-2000:]}") from error
    return ran.returncode, value


def begun(ledger: Path, *arguments: str, **variables: str) -> subprocess.Popen[str]:
    """A run on a ledger, in a session of its own, whose document goes to a pipe."""
    words = [*COMMAND, "verify", *arguments, "--no-models", "--jobs", "2", "--shrink-calls", "0"]
    return subprocess.Popen(
        [*words, "--json", "--ledger", str(ledger)],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        start_new_session=True,
        env={**os.environ, **variables},
    )


def counts_of(value: dict[str, Any], target: str) -> dict[str, int]:
    """Verdicts of a target over all groups."""
    counts: dict[str, int] = {}
    for row in value["matrix"]:
        if row["target"] == target:
            for verdict, count in row["verdicts"].items():
                counts[verdict] = counts.get(verdict, 0) + count
    return counts
