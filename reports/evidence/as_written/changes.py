"""Faulty commands: a change alters their output on its way to the judge, who has to notice."""

from __future__ import annotations

import math
import os
import re

from minkref.reports.evidence.as_written.answers import Change
from minkref.reports.evidence.as_written.settings import SETTINGS, judged

DECIMAL = re.compile(r"(?<![\w./\"])-?\d+\.\d+(?:e[-+]?\d+)?(?![\w./])")
LONG = 15  # digits, from which on a number stands for a double
MOST = 40  # cases of each setting until a change has to be found


def _each(change: Change) -> Change:
    """Applies a change to every number that stands for a double."""

    def one(found: re.Match[str]) -> str:
        digits = re.sub(r"e.*|\D", "", found[0]).lstrip("0")
        return change(found[0]) if len(digits) >= LONG else found[0]

    return lambda text: DECIMAL.sub(one, text)


def _steps(toward: float, count: int) -> Change:
    def moved(text: str) -> str:
        value = float(text)
        for _ in range(count):
            value = math.nextafter(value, math.copysign(toward, value) if toward else 0.0)
        return repr(value)

    return moved


CHANGES: dict[str, Change] = {
    "doubles one unit nearer to zero": _each(_steps(0.0, 1)),
    "doubles two units nearer to zero": _each(_steps(0.0, 2)),
    "doubles two units farther from zero": _each(_steps(math.inf, 2)),
    "fourteen digits": _each(lambda text: f"{float(text):.14g}"),
    "no number": _each(lambda text: "nan"),
    "the lower end of a wide interval": lambda text: re.sub(
        r"(?m)^((?:area|volume|length).*?  )(\d+\.?\d*)",
        lambda m: f"{m[1]}{float(m[2]) * 0.999:.10g}",
        text,
    ),
}


def found_after(setting: str, name: str) -> tuple[float, str]:
    """Processor seconds until the judge finds more faults than without the change, and the first
    such fault."""
    began = spent()
    for index in range(MOST):
        before = judged(setting, range(index, index + 1))
        after = judged(setting, range(index, index + 1), CHANGES[name])
        for (writer, fault), count in after.wrong.items():
            if count > before.wrong[writer, fault]:
                return spent() - began, f"{writer}: {fault}"
    return math.inf, ""


def spent() -> float:
    """Processor seconds for this process and its children."""
    return sum(os.times()[:4])


def tasks() -> list[tuple[str, str]]:
    return [(setting, name) for setting in SETTINGS for name in CHANGES]
