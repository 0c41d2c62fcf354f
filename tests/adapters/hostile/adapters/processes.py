"""Processes that shall outlive the run, or end it."""

from __future__ import annotations

import ctypes
import os
import signal
import sys
import time
from typing import NoReturn

from bounds import PROCESSES, SECONDS, bind, fork, of_this_run, send
from honest import Adapter, Request

LIBC = ctypes.CDLL(None, use_errno=True)
SET_NAME, SET_SUBREAPER, NEW_USER, NEW_PID = 15, 36, 0x10000000, 0x20000000


def linger(*, deaf: bool = True) -> NoReturn:
    """Waits for its alarm, as a left process would."""
    if deaf:
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            signal.signal(number, signal.SIG_IGN)
    time.sleep(SECONDS)
    os._exit(0)


def without_pipes() -> None:
    for number in (0, 1, 2):
        os.dup2(os.open(os.devnull, os.O_RDWR), number)


def daemon() -> bool:
    """Forks twice into a new session; true in the grandchild."""
    child = fork()
    if child:
        os.waitpid(child, 0)
        return False
    os.setsid()
    if fork():
        os._exit(0)
    without_pipes()
    return True


class ForksFifty(Adapter):
    """Fifty children that hear no signal but SIGKILL."""

    def mischief(self, request: Request) -> None:
        for _ in range(PROCESSES):
            if fork() == 0:
                without_pipes()
                linger()


class Daemon(Adapter):
    """A grandchild in a separate session."""

    def mischief(self, request: Request) -> None:
        if daemon():
            linger()


class DaemonWithoutEnvironment(Adapter):
    """The same, that then becomes a program with no environment and another name."""

    def mischief(self, request: Request) -> None:
        if daemon():
            os.execve("/bin/sleep", ["quiet-worker", str(SECONDS)], {})


class KillsItsSupervisor(Adapter):
    """A dozen daemons that each kill the adapter's parent."""

    def mischief(self, request: Request) -> None:
        supervisor = os.getppid()
        for _ in range(12):
            if daemon():
                send(supervisor, signal.SIGKILL, self.run)
                linger()


class KillsItsGroup(Adapter):
    """SIGKILL to its process group, as far as the processes belong to this run."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        if daemon():
            linger()
        send(os.getpgrp(), signal.SIGKILL, self.run)
        for pid in of_this_run(self.run):
            if os.getpgid(pid) == os.getpgrp():
                send(pid, signal.SIGKILL, self.run)
        os._exit(9)


class KillsAllInSight(Adapter):
    """SIGKILL to all visible processes of this run."""

    def mischief(self, request: Request) -> None:
        for pid in of_this_run(self.run):
            send(pid, signal.SIGKILL, self.run)


class TerminatesAllInSight(Adapter):
    """SIGTERM to all visible processes of this run."""

    def mischief(self, request: Request) -> None:
        for pid in of_this_run(self.run):
            send(pid, signal.SIGTERM, self.run)


class StopsAllInSight(Adapter):
    """SIGSTOP to all visible processes of this run; a daemon continues them after ten seconds."""

    def mischief(self, request: Request) -> None:
        seen = of_this_run(self.run)
        if daemon():
            time.sleep(10)
            for pid in seen:
                send(pid, signal.SIGCONT, self.run)
            os._exit(0)
        for pid in seen:
            send(pid, signal.SIGSTOP, self.run)


class StopsItself(Adapter):
    """Stops itself by SIGSTOP instead of an answer. A child ends it after a minute."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        parent = os.getpid()
        if fork() == 0:
            without_pipes()
            time.sleep(SECONDS - 1)
            os.kill(parent, signal.SIGKILL)
            os._exit(0)
        os.kill(parent, signal.SIGSTOP)


class StoppedChild(Adapter):
    """A child that is stopped, with the pipes open, when the adapter ends."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        child = fork()
        if child == 0:
            os.kill(os.getpid(), signal.SIGSTOP)
            linger()
        os.waitpid(child, os.WUNTRACED)
        os._exit(0)


class HearsNothing(Adapter):
    """Hangs, and ignores all signals that can be ignored."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        linger()


class HoldsThePipes(Adapter):
    """Ends, while a daemon keeps its standard output open."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        if fork() == 0:
            os.setsid()
            linger()
        os._exit(0)


class Relay(Adapter):
    """A daemon that lives for a moment only and passes on to its child, again and again."""

    def mischief(self, request: Request) -> None:
        if not daemon():
            return
        for _ in range(PROCESSES - 5):
            time.sleep(0.1)
            if fork():
                os._exit(0)
            os.setsid()
        linger()


class ForksWhenTerminated(Adapter):
    """Takes SIGTERM as the order to put a daemon in its place."""

    def mischief(self, request: Request) -> None:
        def multiply(number: int, frame: object) -> None:
            if daemon():
                linger()

        signal.signal(signal.SIGTERM, multiply)


class OwnSubreaper(Adapter):
    """A child under another name and in a separate session takes over all orphans."""

    def mischief(self, request: Request) -> None:
        if daemon():
            LIBC.prctl(SET_SUBREAPER, 1, 0, 0, 0)
            LIBC.prctl(SET_NAME, b"kworker/0:7", 0, 0, 0)
            for _ in range(5):
                if daemon():
                    linger()
            linger()


class OwnNamespace(Adapter):
    """Takes a separate process namespace, if the system allows, and lingers there."""

    def mischief(self, request: Request) -> str:
        if daemon():
            if LIBC.unshare(NEW_USER | NEW_PID) != 0:
                LIBC.unshare(NEW_PID)
            fork()
            linger()
        return "1"


class ManyThreads(Adapter):
    """Two hundred threads that never end."""

    def mischief(self, request: Request) -> None:
        import threading

        threading.stack_size(1 << 16)
        for _ in range(200):
            threading.Thread(target=time.sleep, args=(SECONDS,), daemon=True).start()


class DiesWhileItsChildrenAnswer(Adapter):
    """Ends at once; a daemon goes on answering for it."""

    def serve(self) -> None:
        if fork():
            os._exit(0)
        os.setsid()
        bind()
        super().serve()
        sys.exit(0)
