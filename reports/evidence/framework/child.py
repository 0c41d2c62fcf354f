"""One part in a child process with a time limit, so that no part can hang or take others down."""

from __future__ import annotations

import datetime
import json
import os
import platform
import resource
import signal
import subprocess
import sys
import time
import traceback
from collections.abc import Callable
from dataclasses import asdict
from typing import Any

from minkref.reports.evidence.framework import store
from minkref.reports.evidence.framework.part import Findings, Part, Status, load
from minkref.version import version


def time_limit(part: Part, quick: bool) -> float:
    """Seconds after which a part is ended: far more than it is expected to take."""
    minutes = part.minutes if not quick or part.quick_minutes is None else part.quick_minutes
    return 240 * minutes + (300 if quick else 900)


def see_log(name: str) -> str:
    return f"see {store.log_path(name).relative_to(store.ROOT)}"


def run_in_child(part: Part, quick: bool, tick: Callable[[], None]) -> dict[str, Any]:
    """Runs the part, calling `tick` some times a second meanwhile; its result is written and given.
    A child that crashes or exceeds its time leaves a result `failed` that says so."""
    store.FOLDER.mkdir(parents=True, exist_ok=True)
    store.result_path(part.name, quick).unlink(missing_ok=True)
    command = [sys.executable, str(store.SCRIPTS_FOLDER / "run.py"), "--child", part.name]
    command += ["--quick"] if quick else []
    began = time.monotonic()
    with open(store.log_path(part.name), "w", encoding="utf-8") as log:
        child = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True
        )
        problem = ""
        try:
            while child.poll() is None:
                tick()
                time.sleep(0.1)
                if time.monotonic() - began > time_limit(part, quick):
                    problem = f"ended after {time_limit(part, quick) / 60:.0f} minutes"
                    break
        finally:
            _end_session(child)
    document = store.read(part.name, quick)
    if document is None:
        problem = problem or f"the script ended with code {child.returncode} without a result"
        findings = Findings(notes=[problem, see_log(part.name)])
        document = document_of(part, quick, findings, time.monotonic() - began, problem)
        store.write(document)
    return document


def _end_session(child: subprocess.Popen[bytes]) -> None:
    """Ends what the child started and left behind: all of the session is its own."""
    try:
        os.killpg(child.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    child.wait()


def run_here(name: str, quick: bool) -> int:
    """What the child does: run, write the result, tell by the exit code whether it broke down."""
    part = load(name)
    began = time.monotonic()
    error = ""
    try:
        findings = part.run(quick)
    except Exception as exception:  # noqa: BLE001 whatever it is, it is recorded
        traceback.print_exc()
        error = f"{type(exception).__name__}: {exception}"
        findings = Findings(notes=[see_log(name)])
    document = document_of(part, quick, findings, time.monotonic() - began, error)
    store.write(document)
    return 1 if error else 0


def machine() -> str:
    return f"{os.cpu_count()} cores, {platform.machine()}, Python {platform.python_version()}"


def document_of(
    part: Part, quick: bool, findings: Findings, seconds: float, error: str
) -> dict[str, Any]:
    usage = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    status = Status.FAILED if error else findings.status
    document = {
        "name": part.name,
        "subject": part.subject,
        "status": str(status),
        "quick": quick,
        "date": datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "seconds": round(seconds, 2),
        "peak_bytes": max(resource.getrusage(who).ru_maxrss for who in usage) * 1024,
        "expected_minutes": part.quick_minutes if quick else part.minutes,
        "version": version(),
        "machine": machine(),
        "paper_models": bool(os.environ.get("MINKREF_MODELS")),
        "dependencies": store.dependency_hash(part),
        "error": error or None,
        "checks": [asdict(check) for check in findings.checks],
        "figures": findings.figures,
        "notes": findings.notes,
    }
    json.dumps(document)
    return document
