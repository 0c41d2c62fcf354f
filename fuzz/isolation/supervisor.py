"""A process between ours and a foreign program.

For machines without a sandbox. Harm that the program does to its parent hits the supervisor. A
program that runs as a user of its own cannot signal the supervisor. The supervisor adopts all
processes that the program leaves behind, also in sessions of their own, and ends them with the
program, or when we die; then the supervisor removes the program's folder of temporary files.
"""

from __future__ import annotations

import ctypes
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress

from minkref.fuzz.isolation.process_tree import children_of
from minkref.output.signals import PR_SET_PDEATHSIG, end_with_parent, kill_group

PR_SET_CHILD_SUBREAPER = 36
MOST_FILES = 1 << 16  # open files that the supervisor closes
END_SECONDS = 5.0
_SIGNALS = (signal.SIGCHLD, signal.SIGTERM)


def supervise(parent: int, folder: str, begin: Callable[[], None]) -> None:
    """Turns a fork's child into the supervisor: leads a session, forks, and returns in the new
    child only, after `begin`. Both end with the process `parent`. At the end, `folder` is
    removed."""
    os.setsid()
    if sys.platform != "linux":
        begin()
        return
    supervisor = os.getpid()
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, _SIGNALS)
    child = os.fork()
    if child == 0:
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        begin()
        end_with_parent(supervisor)  # after a change of user, which clears this setting
        return
    try:
        _wait(child, parent, folder)
    finally:
        os._exit(1)


def end(process: subprocess.Popen[bytes]) -> None:
    """Ends a program with all its descendants."""
    if process.poll() is None:
        for number in (signal.SIGTERM, signal.SIGCONT):
            process.send_signal(number)
        try:
            process.wait(END_SECONDS)
        except subprocess.TimeoutExpired:
            pass
    kill_group(process.pid)
    process.wait()


def _wait(child: int, parent: int, folder: str) -> None:
    """Ends as the child does, after all its descendants."""
    os.closerange(0, MOST_FILES)
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM, 0, 0, 0)
    status = None
    while status is None and os.getppid() == parent:
        if signal.sigwait(_SIGNALS) == signal.SIGTERM:
            break
        while status is None:
            ended, how = os.waitpid(-1, os.WNOHANG)
            if ended == 0:
                break
            status = how if ended == child else None
    _end_children()
    shutil.rmtree(folder, ignore_errors=True)
    if status is not None and os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        if number not in (signal.SIGKILL, signal.SIGSTOP):
            signal.signal(number, signal.SIG_DFL)
        signal.pthread_sigmask(signal.SIG_SETMASK, ())
        os.kill(os.getpid(), number)
    os._exit(os.WEXITSTATUS(status) if status is not None else 1)


def _end_children() -> None:
    """Kills children until none is left: orphans become our children."""
    while True:
        try:
            ended, _ = os.waitpid(-1, os.WNOHANG)
        except ChildProcessError:
            return
        if ended:
            continue
        for child in children_of(os.getpid()):
            with suppress(ProcessLookupError):
                os.kill(child, signal.SIGKILL)
        os.waitpid(-1, 0)
