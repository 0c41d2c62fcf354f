"""Right and faulty adapters that answer the verb `path`."""

from __future__ import annotations

import time
from collections import Counter

from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.run.case_list import CaseList
from minkref.fuzz.run.runner import Run
from minkref.fuzz.run.runner import run as run_cases
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.fuzz.verdicts.verdict import GOOD, Verdict
from minkref.reports.evidence.framework.of_tests import path_adapter
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 0.8, 3)

SEED = 3170
CASES, FAULTY_CASES = Counts(0, 60, 500), 120
JOBS = 2
MOST_SECONDS = 60.0
RIGHT = {
    "right": ("path", "path-ranges"),
    "rounded": ("path", "path-ranges"),
    "doubles": ("path-grid", "path-ranges-grid"),
    "trapezoids": ("path",),
}
FAULTS = {
    "coarse": "path", "touching": "path", "careless": "path", "one-interval": "path-ranges",
    "inner": "path", "first-segment": "path", "turned": "path", "hull": "path", "no-holes": "path",
    "not-alone": "path-ranges", "closed": "path-ranges", "never": "path", "always": "path-ranges",
    "rejects": "path",
}  # fmt: skip


def run(findings: Findings, size: Size) -> None:
    tally: Counter[str] = Counter()
    amiss: list[str] = []
    for way, families in RIGHT.items():
        for family in families:
            done = asked(way, family, size.of(CASES))
            tally += verdicts(done)
            amiss += [f"{way}: {found.case.name.text}" for found in done.findings]
    findings.none("right adapters: findings", amiss)
    judged = sum(tally[str(verdict)] for verdict in GOOD)
    skipped = tally[str(Verdict.SKIPPED)]
    asked_for = size.of(CASES) * sum(map(len, RIGHT.values()))
    findings.equal("right adapters: answers that pass", asked_for - skipped, judged)
    findings.law("right adapters: cases skipped", skipped <= asked_for / 50, "2 %", skipped)
    missed, bare = [], []
    for way, family in FAULTS.items():
        began = time.perf_counter()
        done = asked(way, family, FAULTY_CASES)
        wrong = [found for found in done.findings if found.outcome.verdict is Verdict.WRONG]
        if not wrong:
            missed.append(way)
        bare += [f"{way}: {found.case.name.text}" for found in wrong if not found.outcome.witness]
        kinds = Counter(str(reason) for found in wrong for reason in found.outcome.reasons)
        findings.figures[way] = {
            "cases": len(wrong), "reasons": dict(kinds), "seconds": time.perf_counter() - began,
        }  # fmt: skip
    findings.none("faults that are not found", missed)
    alone = findings.figures["not-alone"]["seconds"]
    findings.law(
        "the adapter without scales that are valid alone is found in time",
        alone < MOST_SECONDS, f"within {MOST_SECONDS:g} s", f"{alone:.0f} s",
    )  # fmt: skip
    findings.none("findings without a witness", bare)
    findings.note(
        f"{judged:,} answers of right adapters (seed {SEED}): {dict(tally)}; "
        f"{len(FAULTS)} faulty ones, each on {FAULTY_CASES} cases"
    )


def asked(way: str, family: str, count: int) -> Run:
    names = tuple(f"{family}:{SEED}:{k}" for k in range(count))
    cases = CaseList(SEED, named=names, models=False)
    limits = Limits(seconds=60)
    return run_cases(cases, [path_adapter(way)], ALL_TARGETS, {}, Baseline(), limits, JOBS)


def verdicts(done: Run) -> Counter[str]:
    found: Counter[str] = Counter()
    for cell in done.matrix.values():
        found.update(cell.verdicts)
    return found
