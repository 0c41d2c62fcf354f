"""Hooks and settings for all tests."""

from __future__ import annotations

import gc
import linecache
import os
import re
import signal
import sys
from collections import Counter
from pathlib import Path
from types import FunctionType

import pytest
from thoroughness import THOROUGH

# The package that checks IRIs for jsonschema takes two seconds to import; our schemas have no IRIs.
sys.modules.setdefault("rfc3987_syntax", None)  # type: ignore[arg-type]

os.environ.pop("GITHUB_ACTIONS", None)  # there `verify` writes annotations

#: Rooms whose tests take two to ten times as long as they compute.
WAITING = {"verify", "view", "page_alone", "hostile"}
README = Path(__file__).parent / "README.md"
COSTS = README.parents[1] / "build" / "release" / "Testing" / "Temporary" / "CTestCostData.txt"
ROW = re.compile(r"^(\| ([\w/]+) \| [^|]* \| ).*\|$", re.M)  # of the table of rooms


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--keep-seconds", action="store_true", help="write them into the table of tests/README.md"
    )


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Omits tests marked thorough: each of them has a smaller sibling that stays. Puts tests that
    wait for processes and clocks first: other tests fill the time beside them."""
    items.sort(key=lambda item: item.path.parent.name not in WAITING)
    if THOROUGH:
        return
    left_out = [item for item in items if item.get_closest_marker("thorough")]
    config.hook.pytest_deselected(items=left_out)
    items[:] = [item for item in items if not item.get_closest_marker("thorough")]


def pytest_collection_finish() -> None:
    """Thousands of tests live to the end: spares them from further garbage collections."""
    gc.collect()
    gc.freeze()


def pytest_report_header() -> str:
    return "draws: many (THOROUGH=1)" if THOROUGH else "draws: few; THOROUGH=1 takes many"


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Prints the seconds of each room, all processes together, and stores them on request."""
    reports = [r for kind in terminalreporter.stats.values() for r in kind]
    seconds: Counter[str] = Counter()
    for report in reports:
        if isinstance(report, pytest.TestReport):
            room = Path(report.nodeid.partition("::")[0]).parts[1:-1]
            seconds["/".join(room)] += report.duration
    if sum(seconds.values()) > 60:
        line = ", ".join(f"{room} {value:.0f}" for room, value in seconds.most_common())
        terminalreporter.write_line(f"seconds by room: {line}; {sum(seconds.values()):.0f} in all")
    if terminalreporter.config.getoption("--keep-seconds"):
        README.write_text(_with_seconds(README.read_text(encoding="utf-8"), seconds, _of_ctest()))


def _of_ctest() -> Counter[str]:
    """Seconds of the C++ tests by room, according to ctest."""
    seconds: Counter[str] = Counter()
    for line in COSTS.read_text(encoding="utf-8").splitlines():
        name, _, cost = line.rpartition(" ")
        room = name.partition(".")[0]
        if cost and name:
            seconds["consumer" if room.startswith("Consumer") else room] += float(cost)
    return seconds


def _with_seconds(text: str, python: Counter[str], cpp: Counter[str]) -> str:
    def renewed(row: re.Match[str]) -> str:
        if row[2] == "Room":
            return row[0]
        return (
            row[1]
            + " | ".join(
                f"{costs[row[2]]:.0f}" if row[2] in costs else "" for costs in (cpp, python)
            )
            + " |"
        )

    return ROW.sub(renewed, text)


def pytest_configure() -> None:
    """Restores interrupts: background processes of a shell ignore them, and so would all their
    children, so that tests of Ctrl-C would wait for endless work."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_make_parametrize_id(val: object) -> str | None:
    """The name of a parameter without a given name: a lambda's text, or the `repr` of a
    `minkref._core` value."""
    if isinstance(val, FunctionType) and val.__name__ == "<lambda>":
        return _text_of(val)
    if type(val).__module__ == "minkref._core":
        return repr(val)[:60]
    return None


def _text_of(function: FunctionType) -> str | None:
    """A lambda's body as written, and its captured values, cut short."""
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
