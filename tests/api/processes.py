"""Processes that a test starts and ends."""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any


def heed_signals() -> None:
    """Restores default signals: background jobs of a shell, or of nohup, start deaf to some."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


@contextmanager
def started(command: Sequence[str | Path], **options: Any) -> Iterator[subprocess.Popen[Any]]:
    """A process that heeds signals. A process still running at the end is killed, whatever the test
    found: Popen alone would wait for it, and all other tests with it."""
    with subprocess.Popen(command, preexec_fn=heed_signals, **options) as process:
        try:
            yield process
        finally:
            process.kill()


def program(*words: str | Path) -> list[str]:
    return [sys.executable, "-m", "minkref", *map(str, words)]
