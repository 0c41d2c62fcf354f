"""A step's size, and the findings that the step fills."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import IntEnum, StrEnum
from typing import Any, Generic, NamedTuple, TypeVar

Count = TypeVar("Count")
EVERYTHING = ("./",)  # for RESTS_ON, when no process can report its reads


class Counts(NamedTuple, Generic[Count]):
    """Counts of anything, per size."""

    quick: Count
    whole: Count
    full: Count


class Minutes(NamedTuple):
    """Expected minutes on two cores; None if the step has no form of that size."""

    quick: float | None
    whole: float | None
    full: float


class Size(IntEnum):
    """QUICK: all steps in minutes; WHOLE: `make evidence`; FULL: the claims' counts."""

    QUICK = 0
    WHOLE = 1
    FULL = 2

    def of(self, counts: Counts[Count]) -> Count:
        return counts[self]

    def __str__(self) -> str:
        return self.name.lower()


class Status(StrEnum):
    MET = "met"
    MISSED = "missed"  # a target was not reached
    FAILED = "failed"  # a law does not hold, or the script broke down


@dataclass(frozen=True)
class Check:
    """A law must hold, else the step has failed; a target may be missed, and is then recorded."""

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
        """A law that nothing was found: shows the number, or the first finds."""
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
