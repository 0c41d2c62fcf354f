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
EVERY_SHARP = Counts(4, 1, 1)
CASES = Counts(4, 12, 300)  # of each family, for a right one
MOST = 200  # of each family, until a fault shows
BY_COMMAND = Counts(0, 1, 66)  # faults searched by the command, too
LONGEST = 60  # seconds, by the command
MEDIAN = 10.0  # seconds
FAMILIES = ("offsets", "insets", "line-offsets", "joins")
SHARP = ("sharp-joins",)


def run(findings: Findings, size: Size) -> None:
    faults = module("offset_faults", SEEDED_OFFSETS).FAULTS
    plain = [fault.__name__ for fault in faults[1 :: size.of(EVERY)]]
    _searched(findings, "seeded faults", plain)
    sharp = list(module("sharp_faults", SEEDED_OFFSETS).SHARP_FAULTS)[:: size.of(EVERY_SHARP)]
    _searched(findings, "seeded faults of sharp joins", sharp)
    names = ["0", *module("right_offsets", SEEDED_OFFSETS).RIGHT]
    tasks = [(name, size.of(CASES)) for name in names]
    for name, judged, alarms in in_processes(right, tasks):
        findings.figures[f"right implementation {name}, answers judged"] = judged
        findings.none(f"right implementation {name}, false alarms", alarms)
    _by_command(findings, "", plain[: size.of(BY_COMMAND)], FAMILIES)
    _by_command(findings, " of sharp joins", sharp[: size.of(BY_COMMAND)], SHARP)


def _searched(findings: Findings, what: str, names: list[str]) -> None:
    """Each fault is found, with a proof, in a few seconds."""
    rows = list(in_processes(search, names))
    missed = [name for name, seconds, _ in rows if seconds is None]
    findings.none(f"of {len(rows)} {what}, not found", missed)
    bare = [name for name, seconds, proven in rows if seconds is not None and not proven]
    findings.none(f"{what} found without a proof in plain fractions", bare)
    seconds = [row[1] for row in rows if row[1] is not None]
    middle = median(seconds)
    findings.target(
        f"{what}: median seconds until one shows", middle < MEDIAN, MEDIAN, f"{middle:.2f}"
    )
    findings.figures[f"{what}: seconds until one shows, at most"] = f"{max(seconds):.1f}"


def search(name: str) -> tuple[str, float | None, bool]:
    """The seconds of computing until a fault shows, None if it does not, and whether the witness is
    proven."""
    asked = module("asked_offsets", SEEDED_OFFSETS)
    began = time.process_time()
    for case, said in asked.outcomes(name, SEED, MOST):
        if said.verdict is Verdict.WRONG:
            return name, time.process_time() - began, asked.is_proven(case, said)
    return name, None, False


def right(task: tuple[str, int]) -> tuple[str, int, list[str]]:
    """How many answers of a right implementation are judged, and the cases of false alarms."""
    name, count = task
    said = list(module("asked_offsets", SEEDED_OFFSETS).outcomes(name, SEED, count))
    judged = sum(one.verdict in GOOD for _, one in said)
    well = {*GOOD, Verdict.SKIPPED}
    return name, judged, [case.name.text for case, one in said if one.verdict not in well]


def _by_command(findings: Findings, what: str, names: list[str], families: tuple[str, ...]) -> None:
    words = [word for family in families for word in ("--family", f"{family}-grid")]
    missed = [name for name in names if not first_found(seeded_offset(name), LONGEST, *words)[0]]
    if names:
        findings.none(f"of {len(names)}{what}, not found by the command in {LONGEST} s", missed)
