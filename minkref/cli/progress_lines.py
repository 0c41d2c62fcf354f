"""Progress where there is no terminal: a line on standard error every half minute."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

SECONDS = 30.0  # between two lines


@contextmanager
def progress_lines(text: Callable[[], str]) -> Iterator[None]:
    """Writes `text()` and the time so far, as long as the block runs; nothing in a block that ends
    within SECONDS. A thread writes the lines, also while a single call computes."""
    over = threading.Event()
    began = time.monotonic()

    def write() -> None:
        while not over.wait(SECONDS):
            minutes, seconds = divmod(round(time.monotonic() - began), 60)
            sys.stderr.write(f"minkref: {text()}, {minutes}:{seconds:02} min\n")
            sys.stderr.flush()

    writer = threading.Thread(target=write, name="progress", daemon=True)
    writer.start()
    try:
        yield
    finally:
        over.set()
        writer.join(1.0)
