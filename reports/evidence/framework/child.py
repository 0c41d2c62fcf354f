"""A step's child process with a time limit, so that no step hangs or takes others down.

As a program: `python -m minkref.reports.evidence.framework.child STEP SIZE`.
"""

from __future__ import annotations

import datetime
import json
import os
import platform
import resource
import signal
import subprocess
import sys
import tempfile
import time
import traceback
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from minkref.output.documents import peak_bytes
from minkref.reports.evidence.framework import places, recorded, store
from minkref.reports.evidence.framework.part import Findings, Size, Status
from minkref.reports.evidence.framework.steps import Step, declared, module
from minkref.version import version


def time_limit(step: Step, size: Size) -> float:
    """Seconds until a step is killed: far more than the step should take."""
    return 240 * (step.minutes[size] or 0) + 900


def command(step: Step, size: Size) -> list[str]:
    return [sys.executable, "-m", __name__, step.name, size.name]


def run_in_child(step: Step, size: Size, tick: Callable[[], None]) -> store.Document:
    """Runs the step while calling `tick` some times a second; writes and returns the result. A
    child that crashes or exceeds its time leaves a `failed` result with the reason."""
    store.log_path(step.name).parent.mkdir(parents=True, exist_ok=True)
    store.result_path(step.name, size).unlink(missing_ok=True)
    began, problem = time.monotonic(), ""
    with (
        tempfile.TemporaryDirectory(prefix="minkref-recorded-", ignore_cleanup_errors=True) as name,
        open(store.log_path(step.name), "w", encoding="utf-8") as log,
    ):
        Path(name).chmod(0o777)  # other users' processes may write here
        child = subprocess.Popen(
            command(step, size), stdin=subprocess.DEVNULL, stdout=log, stderr=log,
            start_new_session=True, env=recorded.environment(Path(name)),
        )  # fmt: skip
        try:
            while child.poll() is None:
                tick()
                time.sleep(0.1)
                if time.monotonic() - began > time_limit(step, size):
                    problem = f"ended after {time_limit(step, size) / 60:.0f} minutes"
                    break
        finally:
            _end_session(child)
        found = recorded.files_of(Path(name), places.ROOT) - store.bookkeeping()
    document = store.read(step.name, size)
    if document is None:
        problem = problem or f"the script ended with code {child.returncode} and no result"
        findings = Findings(notes=[problem, see_log(step.name)])
        document = document_of(step, size, findings, time.monotonic() - began, problem)
    files = store.hashes({*found, *document["rests_on"]})
    document |= {"commit": store.commit_of(files), "files": dict(sorted(files.items()))}
    store.write(document)
    return document


def _end_session(child: subprocess.Popen[bytes]) -> None:
    """Kills the child's session, with every process that the child left behind."""
    try:
        os.killpg(child.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    child.wait()


def run_here(name: str, size: Size) -> int:
    """The child's work: runs the step, writes the result, and reports a breakdown through the exit
    code."""
    step = declared(name)
    assert step is not None
    findings, began = Findings(), time.monotonic()
    more: dict[str, Any] = {}
    error = ""
    try:
        own = module(name)
        more = {"seed": getattr(own, "SEED", None), "rests_on": getattr(own, "RESTS_ON", ())}
        own.run(findings, size)
    except Exception as exception:  # noqa: BLE001 whatever it is, it is recorded
        traceback.print_exc()
        error = f"{type(exception).__name__}: {exception}"
        findings = Findings(notes=[see_log(name)])
    store.write(document_of(step, size, findings, time.monotonic() - began, error) | more)
    return 1 if error else 0


def see_log(step: str) -> str:
    return f"see {os.path.relpath(store.log_path(step), places.ROOT)}"


def machine() -> str:
    return f"{os.cpu_count()} cores, {platform.machine()}, Python {platform.python_version()}"


def document_of(
    step: Step, size: Size, findings: Findings, seconds: float, error: str
) -> store.Document:
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    document = {
        "step": step.name,
        "size": str(size),
        "status": str(Status.FAILED if error else findings.status),
        "date": datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "commit": "",
        "seed": None,
        "seconds": round(seconds, 2),
        "processor_seconds": round(sum(each.ru_utime + each.ru_stime for each in used), 1),
        "peak_bytes": peak_bytes(),
        "expected_minutes": step.minutes[size],
        "version": version(),
        "machine": machine(),
        "paper_models": bool(os.environ.get(recorded.MODELS)),
        "error": error or None,
        "checks": [asdict(check) for check in findings.checks],
        "figures": findings.figures,
        "notes": findings.notes,
        "rests_on": [],
        "files": {},
    }
    json.dumps(document)
    return document


if __name__ == "__main__":
    sys.exit(run_here(sys.argv[1], Size[sys.argv[2]]))
