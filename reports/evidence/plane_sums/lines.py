"""Sums of open lines: part by part by all routes, with a disc by both, with lines by hand."""

from __future__ import annotations

from minkref.fuzz.judges.plane.lines import line_faults
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.05, 0.1, 4)

SEED = 5309
LINES = Counts(12, 60, 3000)


def lines(index: int) -> tuple[int, list[str]]:
    return line_faults(SEED, index)


def run(findings: Findings, size: Size) -> None:
    compared, faults, wanted = 0, [], size.of(LINES)
    for count, found in in_processes(lines, range(wanted), each=100, what="lines"):
        compared += count
        faults += found
    findings.none(f"lines: faults in {wanted:,}", faults)
    findings.law("lines: compared", compared > 0, "some", f"{compared:,}")
    findings.figures |= {"seed": SEED, "compared": compared}
