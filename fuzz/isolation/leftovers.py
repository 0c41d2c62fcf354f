"""Finds processes that a program left behind, by a mark in their environment, and ends them."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

from minkref.fuzz.isolation.environment import MARK

SECONDS = 5.0  # for programs that keep starting processes


def end_marked(mark: str) -> int:
    """Kills every process with the mark, and processes that they start meanwhile. Returns their
    number. A process that cleared its environment escapes."""
    count, deadline = 0, time.monotonic() + SECONDS
    while time.monotonic() < deadline:
        found = marked(mark)
        for process in found:
            try:
                os.kill(process, signal.SIGKILL)
                count += 1
            except (ProcessLookupError, PermissionError):
                continue
        if not found:
            break
    return count


def marked(mark: str) -> list[int]:
    """Lists processes whose mark begins so."""
    wanted = f"\0{MARK}={mark}".encode()
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdecimal():
            try:
                if wanted in b"\0" + (entry / "environ").read_bytes():
                    found.append(int(entry.name))
            except OSError:  # the process ended, or has another owner
                continue
    return found
