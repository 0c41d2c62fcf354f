"""The paper's program of Section 4, followed literally on monkey and bird, the largest pair of its
Table 1: whether it has the right sum in doubles and MPFR."""

from __future__ import annotations

from minkref.reports.bench.pairs import pairs
from minkref.reports.evidence.framework.part import Findings
from minkref.reports.evidence.paper_program import DEPENDS as DEPENDS
from minkref.reports.evidence.paper_program import HUGE, follow_all, pairs_of_edges

SUBJECT = (
    "The paper's update (Behar & Lien 2012, Section 4) on monkey and bird, 135 million pairs of "
    "edges: all formulas corrected, in doubles and MPFR of 53 to 1,000 bits, after 1, 10 and 100 "
    "re-scalings."
)
MINUTES = (35, None)


def run(findings: Findings, quick: bool) -> None:
    every, notes = pairs(quick)
    largest = [pair for pair in every if pairs_of_edges(pair) > HUGE]
    findings.equal("pairs", 1, len(largest))
    follow_all(largest, notes, findings, quick)
