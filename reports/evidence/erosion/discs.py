"""Erosions by a disc before exact distances: corners, polygon sets inside and around, points."""

from __future__ import annotations

from minkref.fuzz.judges.disc.insets import inset_faults
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.05, 0.2, 6)

SEED = 3320
INSETS = Counts(20, 100, 1000)


def insets(index: int) -> tuple[int, list[str]]:
    return inset_faults(SEED, index)


def run(findings: Findings, size: Size) -> None:
    compared, faults, wanted = 0, [], size.of(INSETS)
    for count, found in in_processes(insets, range(wanted), each=100, what="insets"):
        compared += count
        faults += found
    findings.none(f"insets: faults in {wanted:,}", faults)
    findings.law("insets: compared", compared > 0, "some", f"{compared:,}")
    findings.figures |= {"seed": SEED, "compared": compared}
