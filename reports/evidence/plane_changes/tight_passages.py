"""Hand-made cases with tight passages, random laws, and costs."""

from __future__ import annotations

import re
import statistics
import time

from minkref import _core
from minkref.reports.evidence.framework.command import tests_pass
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(0.05, 0.2, 0.5)

TESTS = "tests/plane/test_tight_passages.py"
LEAST = 20
REPEATS = 9


def run(findings: Findings, size: Size) -> None:
    what = "hand-made cases and their checks: pytest"
    found = re.search(r"(\d+) passed", tests_pass(findings, what, TESTS))
    passed = int(found[1]) if found else 0
    findings.target("of them", passed >= LEAST, f"at least {LEAST}", passed)
    P, Q = operand("monkey"), operand("bird")
    shares = []
    for _ in range(REPEATS):
        seconds = []
        for with_passages in (False, True):
            began = time.perf_counter()
            _core.minkowski_sum(P.set, Q.set, "1", "paper", "rational", with_passages)
            seconds.append(time.perf_counter() - began)
        shares.append(seconds[1] / seconds[0])
    low, median, high = statistics.quantiles(shares, n=4)
    findings.figures["with passages to without"] = [round(x, 3) for x in (low, median, high)]
    findings.target(f"{P.name} + {Q.name}: seconds with passages to without", median < 1.5,
                    "under 1.5", f"{median:.2f} ({low:.2f} to {high:.2f})")  # fmt: skip
    tell_absent(findings, "monkey", "bird")
