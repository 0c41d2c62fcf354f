"""A part of the evidence: one subject, one script, one function that finds figures."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path
from typing import Any

SCRIPTS = Path(__file__).resolve().parents[1]
NOT_PARTS = ("__init__", "run")

# Globs of code that parts depend on, from the repository root.
REFERENCE = ("reference/**/*.?pp", "trials/*.?pp", "python/*.cpp", "CMakeLists.txt", "cmake/*")
READERS = ("formats/*.?pp",)
COMPARISON = ("fuzz/**/*.py", "python/minkref/*.py")
CGAL = ("oracle/cgal/*.?pp", "oracle/cgal/CMakeLists.txt")
MODELS = ("models/*.poly", "models/index.json")
AGAINST_CGAL = (*REFERENCE, *READERS, *MODELS, *COMPARISON, *CGAL)
CONVEX = (
    "models/*.off", "python/minkref/space/*.py", "commands/space/*.py", "reports/bench/*.py",
)  # fmt: skip
CERTIFY = ("certify/*", "oracle/checker/*", "reports/evidence/certificates/*.py")
DEGENERACIES = (
    "degeneracies/*.py", "degeneracies/plane/*.py", "degeneracies/space/*.py",
    "degeneracies/solids/*.py", "degeneracies/paths/*.py",
)  # fmt: skip


class Status(StrEnum):
    MET = "met"
    MISSED = "missed"  # a target was not reached
    FAILED = "failed"  # a law does not hold, or the script broke down


@dataclass(frozen=True)
class Check:
    """A law must hold, else the part has failed; a target may be missed, and is then recorded."""

    what: str
    wanted: str
    reached: str
    met: bool
    law: bool


@dataclass
class Findings:
    checks: list[Check] = field(default_factory=list)
    figures: dict[str, Any] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)

    def law(self, what: str, met: bool, wanted: object, reached: object) -> None:
        self.checks.append(Check(what, str(wanted), str(reached), bool(met), True))

    def target(self, what: str, met: bool, wanted: object, reached: object) -> None:
        self.checks.append(Check(what, str(wanted), str(reached), bool(met), False))

    def none(self, what: str, found: int | Sequence[object]) -> None:
        """A law that there is none: their number, or themselves, of which the first are shown."""
        shown = found if isinstance(found, int) else "; ".join(map(str, found[:3])) or 0
        self.law(what, not found, 0, shown)

    def equal(self, what: str, wanted: object, reached: object) -> None:
        self.law(what, reached == wanted, wanted, reached)

    def note(self, text: str) -> None:
        if text not in self.notes:
            self.notes.append(text)

    @property
    def status(self) -> Status:
        missed = [check for check in self.checks if not check.met]
        if any(check.law for check in missed) or not self.checks:
            return Status.FAILED
        return Status.MISSED if missed else Status.MET


@dataclass(frozen=True)
class Part:
    """`quick_minutes` is None where a part has no quick form; quick runs then leave it out."""

    name: str
    subject: str
    minutes: float
    quick_minutes: float | None
    depends: tuple[str, ...]
    run: Callable[[bool], Findings]
    alone: bool = False  # nothing runs beside it: it measures time, or looks at all processes


def load(name: str) -> Part:
    """What `name`.py declares: SUBJECT, MINUTES, DEPENDS, run(findings, quick); ALONE where nothing
    may run beside it."""
    module = importlib.import_module(f"minkref.reports.evidence.{name}")

    def run(quick: bool) -> Findings:
        findings = Findings()
        module.run(findings, quick)
        return findings

    full, quick = module.MINUTES
    alone = getattr(module, "ALONE", False)
    return Part(name, module.SUBJECT, full, quick, tuple(module.DEPENDS), run, alone)


def names() -> list[str]:
    return sorted(path.stem for path in SCRIPTS.glob("*.py") if path.stem not in NOT_PARTS)
