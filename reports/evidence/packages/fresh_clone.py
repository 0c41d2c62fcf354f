"""A fresh clone in a clean environment: the commands of the README, with their times."""

from __future__ import annotations

import tempfile
from pathlib import Path

from minkref.reports.evidence.framework.clone import Clone, git
from minkref.reports.evidence.framework.part import EVERYTHING, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT
from minkref.reports.evidence.framework.steps import steps

MINUTES = Minutes(None, None, 45)
ALONE = True
RESTS_ON = EVERYTHING

RUN_LIMIT = 300.0  # seconds for `make run` after the build


def call(findings: Findings, clone: Clone, title: str, *command: str) -> float:
    taken = clone.call(title, *command)
    findings.figures[title] = {"seconds": round(taken.clock, 1), "code": taken.code}
    reached = f"exit code {taken.code}, {taken.clock:.0f} s"
    findings.law(title, taken.code == 0, "exit code 0", reached)
    return taken.clock


def run(findings: Findings, size: Size) -> None:
    with tempfile.TemporaryDirectory(prefix="minkref-clone-", ignore_cleanup_errors=True) as name:
        clone = Clone(Path(name, "minkref"))
        if git(ROOT, "status", "--porcelain"):
            findings.note(
                "the checkout has changes that are not committed; the clone is without them"
            )
        findings.figures["commit"] = git(clone.root, "rev-parse", "HEAD")
        call(findings, clone, "make setup", "make", "setup")
        first = call(findings, clone, "make run", "make", "run")
        findings.target("seconds of make run, built", first <= RUN_LIMIT, RUN_LIMIT, f"{first:.0f}")
        again = call(findings, clone, "make run again", "make", "run")
        findings.target(
            "seconds of the second make run", again <= RUN_LIMIT, RUN_LIMIT, f"{again:.0f}"
        )
        call(findings, clone, "make test", "make", "test")
        others = [step.name for step in steps() if step.minutes.quick is not None]
        only = f"ONLY={' '.join(others)}"
        call(findings, clone, "make evidence QUICK=1", "make", "evidence", "QUICK=1", only)
        clean = git(clone.root, "status", "--porcelain")
        findings.law("files left in the way of git", clean == "", "none", clean[:200] or "none")
