"""Progress where there is no terminal: a line on standard error every half minute."""

from __future__ import annotations

import _thread
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

SECONDS = 30.0  # between two lines


@contextmanager
def progress_lines(text: Callable[[], str]) -> Iterator[None]:
    """Writes `text()` and the time so far, as long as the block runs; nothing in a block that ends
    within SECONDS. A thread writes the lines, also while a single call computes. Under a limit on
    memory no thread may start: `Thread.start` would then wait for ever, and here no line comes."""
    over, writing = threading.Event(), threading.Lock()
    began = time.monotonic()

    def write() -> None:
        with suppress(MemoryError, OSError, ValueError):
            while not over.wait(SECONDS):
                minutes, seconds = divmod(round(time.monotonic() - began), 60)
                with writing:
                    if not over.is_set():
                        sys.stderr.write(f"minkref: {text()}, {minutes}:{seconds:02} min\n")
                        sys.stderr.flush()

    with suppress(RuntimeError, MemoryError):
        _thread.start_new_thread(write, ())
    try:
        yield
    finally:
        with writing:
            over.set()
