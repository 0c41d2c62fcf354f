"""Several targets' answers on one case, and the verdicts."""

from __future__ import annotations

from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.judgement import judge
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Outcome
from minkref.reports.evidence.framework.part import Findings


class Bench:
    """Targets kept open over many cases (a server for each method of CGAL)."""

    def __init__(self, targets: list[str], seconds: float = 60.0, gigabytes: int = 4) -> None:
        limits = Limits(seconds=seconds, bytes=gigabytes << 30)
        self._targets = {name: ALL_TARGETS.target(name, limits) for name in targets}

    def verdicts(self, case: Case) -> dict[str, Outcome]:
        """By target. A wrong result carries a witness, checked in plain fractions."""
        answers = {name: target.sum(case) for name, target in self._targets.items()}
        return {outcome.target: outcome for outcome in judge(case, answers, list(answers))}

    def close(self) -> None:
        for target in self._targets.values():
            target.close()

    def __enter__(self) -> Bench:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def available_cgal(findings: Findings, *wanted: str) -> list[str]:
    """The named CGAL targets on this machine; each absent target becomes a missed target."""
    entries = {entry.name: entry for entry in ALL_TARGETS.entries()}
    found = []
    for name in wanted:
        entry = entries.get(name)
        if entry is not None and entry.available:
            found.append(name)
            findings.figures["cgal_version"] = entry.version
        else:
            reason = entry.reason if entry is not None else "no such target"
            findings.target(name, False, "available", reason)
    return found
