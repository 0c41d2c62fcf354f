"""What holds for all tests."""

from __future__ import annotations

import signal


def pytest_configure() -> None:
    """A process that a shell began in the background ignores interrupts, and so would all that it
    starts: tests of Ctrl-C would wait for the end of works that have none."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
