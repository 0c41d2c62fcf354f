"""How long a search may go on."""

from __future__ import annotations

import time


class OutOfTime(Exception):
    """A search did not end in time."""


class SearchTime:
    """Seconds of the processor, from now on: another program beside it changes nothing."""

    def __init__(self, seconds: float) -> None:
        self._end = time.process_time() + seconds

    def spend(self) -> None:
        """Looks at the time. Raises OutOfTime."""
        if time.process_time() > self._end:
            raise OutOfTime
