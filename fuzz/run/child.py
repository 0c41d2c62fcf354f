"""A worker process's first steps, and its end."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
from multiprocessing.context import SpawnProcess

from minkref.output.signals import end_with_parent, kill_group


def begin() -> None:
    """Makes this process the leader of a session that ends with its parent. Output goes to standard
    error: standard output belongs to the command's document."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, (signal.SIGINT,))
    os.setsid()
    parent = multiprocessing.parent_process()
    if parent is not None and parent.pid is not None:
        end_with_parent(parent.pid)
    os.dup2(2, 1)
    sys.set_int_max_str_digits(0)


def end(process: SpawnProcess) -> None:
    """Kills the process with all its descendants, and waits."""
    if process.pid is not None:
        kill_group(process.pid)
    if process.is_alive():  # not yet a session leader
        process.kill()
    process.join()
