"""Faults seeded in small implementations of the verb `offset`, and right implementations."""

from __future__ import annotations

import time
from statistics import median

from minkref.fuzz.verdicts.verdict import GOOD, Verdict
from minkref.reports.evidence.framework.command import first_found
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.of_tests import SEEDED_OFFSETS, module, seeded_offset
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.6, 9)

SEED = 11
EVERY = Counts(11, 1, 1)  # one fault of so many
CASES = Counts(4, 12, 300)  # of each family, for a right one
MOST = 200  # of each family, until a fault shows
BY_COMMAND = Counts(0, 1, 66)  # faults searched by the command, too
LONGEST = 60  # seconds, by the command
MEDIAN = 10.0  # seconds
FAMILIES = ("offsets", "insets", "line-offsets", "joins")


def run(findings: Findings, size: Size) -> None:
    faults = module("offset_faults", SEEDED_OFFSETS).FAULTS
    numbers = list(range(1, len(faults)))[:: size.of(EVERY)]
    rows = list(in_processes(search, numbers))
    found = [row for row in rows if row[1] is not None]
    missed = [faults[number].__name__ for number, seconds, _ in rows if seconds is None]
    findings.none(f"of {len(rows)} seeded faults, not found", missed)
    bare = [faults[number].__name__ for number, _, proven in found if not proven]
    findings.none("seeded faults found without a proof in plain fractions", bare)
    seconds = [row[1] for row in found if row[1] is not None]
    middle = median(seconds)
    findings.target("median seconds until one shows", middle < MEDIAN, MEDIAN, f"{middle:.2f}")
    findings.figures["seconds until one shows, at most"] = f"{max(seconds):.1f}"
    names = ["0", *module("right_offsets", SEEDED_OFFSETS).RIGHT]
    tasks = [(name, size.of(CASES)) for name in names]
    for name, judged, alarms in in_processes(right, tasks):
        findings.figures[f"right implementation {name}, answers judged"] = judged
        findings.none(f"right implementation {name}, false alarms", alarms)
    _by_command(findings, [str(number) for number in numbers][: size.of(BY_COMMAND)])


def search(number: int) -> tuple[int, float | None, bool]:
    """The seconds of computing until a fault shows, None if it does not, and whether the witness is
    proven."""
    asked = module("asked_offsets", SEEDED_OFFSETS)
    began = time.process_time()
    for case, said in asked.outcomes(str(number), SEED, MOST):
        if said.verdict is Verdict.WRONG:
            return number, time.process_time() - began, asked.is_proven(case, said)
    return number, None, False


def right(task: tuple[str, int]) -> tuple[str, int, list[str]]:
    """How many answers of a right implementation are judged, and the cases of false alarms."""
    name, count = task
    said = list(module("asked_offsets", SEEDED_OFFSETS).outcomes(name, SEED, count))
    judged = sum(one.verdict in GOOD for _, one in said)
    well = {*GOOD, Verdict.SKIPPED}
    return name, judged, [case.name.text for case, one in said if one.verdict not in well]


def _by_command(findings: Findings, numbers: list[str]) -> None:
    words = [word for family in FAMILIES for word in ("--family", f"{family}-grid")]
    missed = [n for n in numbers if not first_found(seeded_offset(n), LONGEST, *words)[0]]
    if numbers:
        findings.none(f"of {len(numbers)}, not found by the command in {LONGEST} s", missed)
