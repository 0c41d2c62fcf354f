"""Small cases verified per second, and the time for each step."""

from __future__ import annotations

import cProfile
import os
import pstats
import statistics
import time
from collections.abc import Callable

from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run import naming
from minkref.fuzz.settings import asking_about
from minkref.fuzz.targets.answer import Limits, Target
from minkref.reports.evidence.framework.command import searched
from minkref.reports.evidence.framework.of_tests import SEEDED, seeded_adapter
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.5, 2)
ALONE = True

FAMILY = "random"
CASES = Counts(60, 400, 1500)
REPETITIONS = 5
AIM = 500.0
STEPS = {
    "the case: drawing a valid pair": "load",
    "the truth and the target's sum": "_ask",
    "comparison": "judge",
}


def run(findings: Findings, size: Size) -> None:
    count = size.of(CASES)
    names = _small(count)
    os.environ |= searched(SEEDED)
    rates = {}
    for title, target in (
        ("a route of the reference in process", "minkref:winding"),
        ("a Python function with a sum of its own", "py:seeded_sums:sound"),
        ("the same as an adapter written by hand", seeded_adapter("sound")),
    ):
        rates[title] = _rates(names, target)
        least, most = min(rates[title]), max(rates[title])
        middle = statistics.median(rates[title])
        findings.figures[f"{title}: cases per second"] = (
            f"{middle:,.0f} ({least:,.0f} to {most:,.0f} in {REPETITIONS} repetitions)"
        )
    middle = statistics.median(rates["a route of the reference in process"])
    findings.target("cases per second and core in process", middle >= AIM, AIM, f"{middle:,.0f}")
    for step, share in _shares(names).items():
        findings.figures[f"share of the time in process: {step}"] = f"{share:.0%}"


def _small(count: int) -> list[CaseName]:
    """Cases whose operands have at most 12 vertices each."""
    found: list[CaseName] = []
    index = 0
    while len(found) < count:
        name = CaseName(f"{FAMILY}:12:{index}", FAMILY)
        case = naming.load(name)
        if isinstance(case, Case) and max(case.P.vertices, case.Q.vertices) <= 12:
            found.append(name)
        index += 1
    return found


def _rates(names: list[CaseName], target: str) -> list[float]:
    return [len(names) / _timed(lambda: _verify(names, target)) for _ in range(REPETITIONS)]


def _verify(names: list[CaseName], name: str) -> None:
    limits = Limits()
    made: dict[str, Target] = {}

    def target(wanted: str) -> Target:
        if wanted not in made:
            made[wanted] = ALL_TARGETS.target(wanted, limits)
        return made[wanted]

    for each in names:
        asking = asking_about(naming.load(each), target, lambda _: None, {}, limits)
        (outcome,) = asking.outcomes([name])
        if outcome.verdict != "pass":
            raise RuntimeError(f"{each.text}: {outcome.verdict} {outcome.message}")
    for each_target in made.values():
        each_target.close()


def _timed(work: Callable[[], None]) -> float:
    since = time.perf_counter()
    work()
    return time.perf_counter() - since


def _shares(names: list[CaseName]) -> dict[str, float]:
    profile = cProfile.Profile()
    profile.enable()
    _verify(names, "minkref:winding")
    profile.disable()
    stats = pstats.Stats(profile).stats  # type: ignore[attr-defined]
    spent = {function[2]: row[3] for function, row in stats.items()}
    whole = spent["_verify"]
    return {title: spent.get(function, 0.0) / whole for title, function in STEPS.items()}
