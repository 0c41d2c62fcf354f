"""A process between ours and a program that is not ours.

For machines without a sandbox. Whatever the program does to its parent hits the supervisor. A
program that runs as a user of its own cannot signal the supervisor. The supervisor adopts all
processes that the program leaves behind, also in sessions of their own, and ends them with the
program, or when we die; then the supervisor removes the folder of the program's temporary files.
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
MOST_FILES = 1 << 16  # open ones that the supervisor closes
END_SECONDS = 5.0
_SIGNALS = (signal.SIGCHLD, signal.SIGTERM)


def supervise(parent: int, folder: str, begin: Callable[[], None]) -> None:
    """For the child of a fork, which becomes the supervisor: leads a session, forks, and returns in
    the new child only, after `begin`. `parent` is the process that both end with. `folder` is
    removed at the end."""
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
        end_with_parent(supervisor)  # after a change of the user, which forgets it
        return
    try:
        _wait(child, parent, folder)
    finally:
        os._exit(1)


def end(process: subprocess.Popen[bytes]) -> None:
    """Ends a program with all that it started."""
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
    """Ends as the child does, after all that it started."""
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
    """Whose children become ours when they end."""
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
