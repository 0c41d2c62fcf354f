"""The paper's program from Section 4, followed literally on monkey and bird, the largest pair of
its Table 1: does it get the right sum in doubles and MPFR?"""

from __future__ import annotations

from minkref.reports.bench.pairs import pairs
from minkref.reports.evidence.framework.part import Findings, Minutes, Size
from minkref.reports.evidence.paper_program.pairs import HUGE, follow_all, pairs_of_edges

MINUTES = Minutes(None, None, 35)


def run(findings: Findings, size: Size) -> None:
    every, notes = pairs(False)
    largest = [pair for pair in every if pairs_of_edges(pair) > HUGE]
    findings.equal("pairs", 1, len(largest))
    follow_all(largest, notes, findings, size)
