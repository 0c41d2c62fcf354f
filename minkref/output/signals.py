"""Signals: how the command and its worker processes end when told to."""

from __future__ import annotations

import ctypes
import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any, NoReturn

PR_SET_PDEATHSIG = 1
OUT_OF_TIME = signal.SIGVTALRM  # by a time limit; judges use SIGALRM


class Ended(BaseException):
    """The signal `number` told the process to end."""

    def __init__(self, number: int) -> None:
        super().__init__(signal.Signals(number).name)
        self.number = number


class Stoppable:
    """Within this context SIGINT, SIGTERM, SIGHUP and a time limit raise Ended, but `held` work
    first completes."""

    def __init__(self) -> None:
        self._holds = 0
        self._number: int | None = None
        self._before: dict[int, Any] = {}

    def __enter__(self) -> Stoppable:
        numbers = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, OUT_OF_TIME)
        for number in (n for n in numbers if _may_handle(n)):
            self._before[number] = signal.signal(number, self._handle)
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)

    @contextmanager
    def held(self) -> Iterator[None]:
        """Delay signals to the end of the block."""
        self._holds += 1
        try:
            yield
        finally:
            self._holds -= 1
        if self._number is not None and not self._holds:
            raise Ended(self._number)

    def _handle(self, number: int, _: FrameType | None) -> None:
        self._number = number
        if not self._holds:
            raise Ended(number)


@contextmanager
def ending_in_order() -> Iterator[None]:
    """Make SIGTERM, SIGHUP and a time limit raise Ended, so that worker processes and temporary
    files are removed."""
    numbers = [n for n in (signal.SIGTERM, signal.SIGHUP, OUT_OF_TIME) if _may_handle(n)]
    before = {number: signal.signal(number, _raise_ended) for number in numbers}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


@contextmanager
def time_limit(seconds: float | None) -> Iterator[None]:
    """Send OUT_OF_TIME to the main thread once `seconds` have passed within the block; use inside
    `ending_in_order`. None: no limit."""
    if seconds is None:
        yield
        return
    main = threading.main_thread().ident or 0
    timer = threading.Timer(seconds, signal.pthread_kill, (main, OUT_OF_TIME))
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        try:
            timer.join()
        except Ended as ended:  # as the block was ending
            if ended.number != OUT_OF_TIME:
                raise


def end_with_parent(parent: int) -> None:
    """Have this process killed when `parent`, the process that started it, dies (Linux)."""
    if sys.platform == "linux":
        ctypes.CDLL(None, use_errno=True).prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
        if os.getppid() != parent:  # the parent died before the watch began
            os._exit(1)


def kill_group(leader: int) -> None:
    """Kill a process that leads a session, with all processes that it started."""
    try:
        os.killpg(leader, signal.SIGKILL)
    except (ProcessLookupError, PermissionError):
        pass


def _raise_ended(number: int, _: FrameType | None) -> NoReturn:
    raise Ended(number)


def _may_handle(number: int) -> bool:
    here = threading.current_thread() is threading.main_thread()
    return here and signal.getsignal(number) not in (signal.SIG_IGN, None)
