"""Sums with a ball, and erosions by a ball, lie between their two sets, which are as near as
promised, at points that the definition decides."""

from __future__ import annotations

from minkref.fuzz.judges.space.ball_sums import BallTrial, ball_trial
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, None, 5)

SEED = 2012
SUMS = Counts(8, 28, 140)  # every other one an erosion
POINTS = Counts(20, 40, 60)


def judge(task: tuple[int, int]) -> BallTrial:
    index, points = task
    return ball_trial(SEED, index, points)


def run(findings: Findings, size: Size) -> None:
    count, points = size.of(SUMS), size.of(POINTS)
    places, faults = [0, 0, 0], []
    tasks = [(index, points) for index in range(count)]
    for trial in in_processes(judge, tasks, each=max(1, count // 20), what="sums"):
        places = [a + b for a, b in zip(places, trial.places, strict=True)]
        faults += trial.faults
    findings.none("points where a set breaks its promise", faults)
    for name, number in zip(("inside", "between", "outside"), places, strict=True):
        findings.law(f"points {name}", number > 0, "some", f"{number:,}")
