"""Campaigns as child processes, and Dask schedulers and workers beside them."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from minkref.fuzz.ledgers.counting import rows_of_ledger
from minkref.reports.evidence.framework.command import COMMAND, Document, searched
from minkref.reports.evidence.framework.of_tests import SEEDED

PATIENCE = 600.0  # seconds for a run
LOOPBACK = "127.0.0.1"


def write_campaign(path: Path, targets: Sequence[str], budget: int, **more: Any) -> Path:
    """Writes a campaign's file."""
    lines = [f"targets = {json.dumps(list(targets))}"]
    lines += [f"{key.replace('_', '-')} = {json.dumps(value)}" for key, value in more.items()]
    path.write_text("\n".join([*lines, "[budget]", f"cases = {budget}\n"]), encoding="utf-8")
    return path


def begin(file: Path, folder: Path, *words: object, **variables: str) -> subprocess.Popen[str]:
    """Starts a campaign."""
    return subprocess.Popen(
        [*COMMAND, "campaign", "run", str(file), "-o", str(folder), *map(str, words), "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, **searched(SEEDED), **variables},
    )


def ended(process: subprocess.Popen[str]) -> Document:
    """Waits for a campaign. Raises RuntimeError without a document."""
    text, said = process.communicate(timeout=PATIENCE)
    try:
        value: Document = json.loads(text)
    except ValueError as error:
        raise RuntimeError(f"exit code {process.returncode}: {said[-2000:]}") from error
    return value


def run_campaign(file: Path, folder: Path, *words: object) -> Document:
    return ended(begin(file, folder, *words))


def found(value: Mapping[str, Any]) -> dict[str, Any]:
    """Returns all that a campaign found, but for times."""
    return {
        "cases": value["cases"],
        "chunks": value["chunks"],
        "behaviours": value["behaviours"],
        "findings": [[kind["count"], kind["first"]] for kind in value["kinds"]],
        "shrunk": [_lasting(small) for kind in value["kinds"] for small in kind["shrunk"]],
        "verdicts": {f"{r['target']}, {r['group']}": r["verdicts"] for r in value["matrix"]},
    }


def differences(one: Mapping[str, Any], other: Mapping[str, Any]) -> list[str]:
    """Names what two campaigns found otherwise, with both texts cut off."""
    mine, theirs = found(one), found(other)
    return [
        f"{name}: {json.dumps(mine[name])[:400]}, {json.dumps(theirs[name])[:400]}"
        for name in mine
        if mine[name] != theirs[name]
    ]


def _lasting(small: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in small.items() if "seconds" not in name}


def rows(folder: Path) -> Any:
    """Returns all rows of a ledger, sorted, without times."""
    return rows_of_ledger(folder)


class Cluster:
    """A Dask scheduler and workers as separate processes, joined over loopback."""

    def __init__(self, folder: Path, workers: int) -> None:
        self.folder, self._count = folder, workers
        with socket.socket() as free:
            free.bind((LOOPBACK, 0))
            self.port: int = free.getsockname()[1]
        self.address = f"tcp://{LOOPBACK}:{self.port}"
        self.scheduler: subprocess.Popen[bytes] | None = None
        self.workers: list[subprocess.Popen[bytes]] = []

    def __enter__(self) -> Self:
        self.start_scheduler()
        for _ in range(self._count):
            self.start_worker()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: object, trace: TracebackType | None
    ) -> None:
        for process in (*self.workers, self.scheduler):
            if process is not None:
                kill(process)

    def start_scheduler(self) -> None:
        words = ["--host", LOOPBACK, "--port", str(self.port), "--no-dashboard"]
        self.scheduler = self._start("distributed.cli.dask_scheduler", *words)

    def start_worker(self) -> None:
        words = [self.address, "--nthreads", "1", "--nworkers", "1", "--no-dashboard"]
        words += ["--host", LOOPBACK, "--memory-limit", "0"]
        words += ["--local-directory", str(self.folder)]
        self.workers.append(self._start("distributed.cli.dask_worker", *words))

    def replace_worker(self, number: int) -> None:
        kill(self.workers.pop(number))
        self.start_worker()

    def replace_scheduler(self) -> None:
        """Kills the scheduler, then replaces all workers."""
        assert self.scheduler is not None
        kill(self.scheduler)
        self.start_scheduler()
        for number in reversed(range(len(self.workers))):
            self.replace_worker(number)

    def _start(self, module: str, *words: str) -> subprocess.Popen[bytes]:
        return subprocess.Popen(
            [sys.executable, "-m", module, *words],
            cwd=self.folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            env={**os.environ, **searched(SEEDED)},
        )


def kill(process: subprocess.Popen[Any]) -> None:
    """Kills a process alone, by signal 9; its children have to notice by themselves."""
    process.kill()
    process.wait()


def wait_for_parts(folder: Path, count: int, process: subprocess.Popen[str]) -> dict[str, bytes]:
    """Waits until a ledger has so many parts, or the campaign has ended. Returns them."""
    parts = folder / "ledger" / "parts"
    while process.poll() is None and len(list(parts.glob("*.parquet"))) < count:
        time.sleep(0.02)
    return {path.name: path.read_bytes() for path in parts.glob("*.parquet")}
