"""What holds for all tests."""

from __future__ import annotations

import linecache
import re
import signal
from types import FunctionType


def pytest_configure() -> None:
    """A process that a shell began in the background ignores interrupts, and so would all that it
    starts: tests of Ctrl-C would wait for the end of works that have none."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_make_parametrize_id(val: object) -> str | None:
    """What a parameter without a name of its own is called: the text of a lambda, what a value
    shows of itself."""
    if isinstance(val, FunctionType) and val.__name__ == "<lambda>":
        return _text_of(val)
    if type(val).__module__ == "minkref._core":
        return repr(val)[:60]
    return None


def _text_of(function: FunctionType) -> str | None:
    """The body of a lambda as it is written, and what it was made with, cut short."""
    code = function.__code__
    places = [(a, b, c, d) for a, b, c, d in code.co_positions() if a and b and c and d]
    if not places:
        return None
    first, last = min(place[0] for place in places), max(place[1] for place in places)
    end = max(place[3] for place in places if place[1] == last)
    lines = [linecache.getline(code.co_filename, number) for number in range(first, last + 1)]
    lines[-1] = lines[-1].encode()[:end].decode(errors="replace")  # columns count bytes
    text = re.sub(r"^.*?\blambda\b[^:]*: ?", "", " ".join(" ".join(lines).split()))[:60]
    cells = zip(code.co_freevars, function.__closure__ or (), strict=True)
    made_with = [f"{name}={_shown(cell.cell_contents)}" for name, cell in cells]
    return ", ".join([text, *made_with])[:100]


def _shown(value: object) -> str:
    """Without addresses, which differ from process to process."""
    text = str(value)
    return type(value).__name__ if " at 0x" in text else text[:20]
