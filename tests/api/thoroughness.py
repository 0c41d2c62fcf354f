"""How much the tests draw: few, and many where THOROUGH=1 is set, as the nightly run does."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TypeVar

THOROUGH = os.environ.get("THOROUGH", "") not in ("", "0")
Value = TypeVar("Value")


def draws(few: int, many: int) -> int:
    """A number of draws. The few find the faults that the test aims at."""
    return many if THOROUGH else few


def some(values: Iterable[Value], few: int) -> list[Value]:
    """All values if the run is thorough; otherwise `few` values, spread evenly, with both ends."""
    every = list(values)
    if THOROUGH or len(every) <= few:
        return every
    return [every[k * (len(every) - 1) // max(1, few - 1)] for k in range(few)]
