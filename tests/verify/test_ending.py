"""Worker processes end with the command, however it ends."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from processes import program, started
from thoroughness import some

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")


def children(parent: int) -> list[int]:
    found = []
    for folder in Path("/proc").iterdir():
        if folder.name.isdecimal():
            try:
                text = (folder / "stat").read_text(encoding="utf-8", errors="replace")
            except OSError:
                continue
            if int(text.rpartition(")")[2].split()[1]) == parent:
                found.append(int(folder.name))
    return found


def lives(process: int) -> bool:
    try:
        text = Path(f"/proc/{process}/stat").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return False
    return text.rpartition(")")[2].split()[0] != "Z"


@pytest.mark.parametrize(
    ("number", "code"),
    some(
        [
            (signal.SIGHUP, 128 + signal.SIGHUP),
            (signal.SIGINT, 130),
            (signal.SIGTERM, 128 + signal.SIGTERM),
            (signal.SIGKILL, -signal.SIGKILL),
        ],
        few=2,
    ),
)
def test_workers_end_with_the_command(number: int, code: int) -> None:
    words = ("verify", "minkref:paper", "--seconds", "60", "--jobs", "2", "--no-models")
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    with started(program(*words), **quiet) as process:
        deadline = time.monotonic() + 30
        workers: list[int] = []
        while len(workers) < 2 and time.monotonic() < deadline:
            time.sleep(0.1)
            workers = children(process.pid)
        time.sleep(0.2)  # into their work
        workers = children(process.pid)
        assert len(workers) >= 2
        os.kill(process.pid, number)
        assert process.wait(30) == code
    deadline = time.monotonic() + 5
    while any(map(lives, workers)) and time.monotonic() < deadline:
        time.sleep(0.1)
    assert not any(map(lives, workers))
