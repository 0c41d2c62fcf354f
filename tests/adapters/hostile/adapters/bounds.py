"""Limits of every hostile adapter, so that it harms nobody: a minute of life, fifty processes,
three gigabytes, files of one gigabyte, and signals to its own run alone."""

from __future__ import annotations

import os
import resource
import signal
import sys
from pathlib import Path

SECONDS = 60
PROCESSES = 50
GIGABYTE = 1 << 30

_forked = 0


def limit(what: int, most: int) -> None:
    """Lowers a limit of this process, and keeps a lower one."""
    hard = resource.getrlimit(what)[1]
    most = most if hard == resource.RLIM_INFINITY else min(most, hard)
    resource.setrlimit(what, (most, most))


def bind() -> None:
    """At the start of every program, and again after each fork: alarms are not inherited."""
    limit(resource.RLIMIT_AS, 3 * GIGABYTE)
    limit(resource.RLIMIT_FSIZE, GIGABYTE)
    limit(resource.RLIMIT_CPU, SECONDS)
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    signal.alarm(SECONDS)


def fork() -> int:
    """As os.fork, at most fifty times in a line of descent."""
    global _forked
    _forked += 1
    if _forked > PROCESSES:
        raise SystemExit("that would be too many processes")
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        bind()
    return child


def is_ours(pid: int, run: str) -> bool:
    """Whether a process's environment or command line names this run."""
    mark = run.encode()
    for name in ("environ", "cmdline"):
        try:
            if mark in Path("/proc", str(pid), name).read_bytes():
                return True
        except OSError:
            continue
    return False


def of_this_run(run: str) -> list[int]:
    """All visible processes of this run except this process and the run's `supervisor.py`."""
    found = []
    for name in os.listdir("/proc"):
        if name.isdigit() and int(name) != os.getpid() and is_ours(int(name), run):
            if b"supervisor.py" not in Path("/proc", name, "cmdline").read_bytes():
                found.append(int(name))
    return found


def send(pid: int, number: signal.Signals, run: str) -> None:
    """A signal to a process of this run, and to no other."""
    if pid > 1 and is_ours(pid, run):
        try:
            os.kill(pid, number)
        except OSError:
            return
