"""Openings and closings by a disc before polygons inside and around, and their own rings."""

from __future__ import annotations

from minkref.fuzz.judges.disc.closings import closing_faults
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.05, 0.2, 4)

SEED = 6124
SETS = Counts(10, 60, 1000)


def closings(index: int) -> tuple[int, list[str]]:
    return closing_faults(SEED, index)


def run(findings: Findings, size: Size) -> None:
    compared, faults, wanted = 0, [], size.of(SETS)
    for count, found in in_processes(closings, range(wanted), each=100, what="sets"):
        compared += count
        faults += found
    findings.none(f"openings and closings: faults in {wanted:,} sets", faults)
    findings.law("openings and closings: compared", compared > 0, "some", f"{compared:,}")
    findings.figures |= {"seed": SEED, "compared": compared}
