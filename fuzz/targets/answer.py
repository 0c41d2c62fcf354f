"""A target's answer to one case, and the time limits for it."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Protocol

from minkref.errors import message_of
from minkref.exact import digest
from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.region import Region, plain_polygons, region_of_polygons
from minkref.fuzz.isolation.isolation import Isolation
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import Verdict

JUDGING_BYTES = 2 << 30
PROCESSES = 512  # per program
LOAD_SECONDS = 60.0  # at least, for the import of a module or the start of a program
REGIONS = Declaration("minkref")
REFERENCE = "minkref:"  # and a route of our own
JUDGED = "minkref@"  # and a judge of it


@dataclass(frozen=True)
class Limits:
    """Limits for a target's call. `output`: bytes for an answer, and for its log. `processes`: for
    a foreign program, including threads. `tries`: how often an unresponsive target is asked before
    the verdict says so. `judging_bytes`: a worker's additional memory for making and judging a
    case."""

    seconds: float = 30.0
    bytes: int = 4 << 30
    size: int | None = None
    output: int = 64 << 20
    processes: int = PROCESSES
    tries: int = 2
    judging_bytes: int = JUDGING_BYTES
    isolation: Isolation | None = None  # for foreign programs; None: the best available

    def document(self) -> dict[str, Any]:
        """Returns the limits that distinguish runs."""
        walls = self.isolation and {"kind": self.isolation.kind, "passed": self.isolation.passed}
        return {**vars(self), "isolation": walls}


@dataclass
class Answer:
    """A target's answer: a region, in space a polyhedron, of a grown set perhaps `curves`, bars and
    bridges as `features`, or a verdict that explains its absence. WRONG without an answer: the
    target called the operands invalid."""

    region: Region | None = None
    verdict: Verdict | None = None
    message: str = ""
    signal: str | None = None
    seconds: float = 0.0
    declaration: Declaration = REGIONS
    solid: Polyhedron | None = None
    log: str = ""
    curves: str | None = None
    features: str | None = None

    @property
    def text(self) -> str | None:
        """The answer in the plane as canonical JSON."""
        return self._other if self.region is None else self.region.json

    @property
    def digest(self) -> str | None:
        """For the answer in the plane."""
        if self.region is not None:
            return self.region.digest
        return None if self._other is None else digest(self._other)

    @property
    def _other(self) -> str | None:
        """The answer that is no polygon set."""
        return self.features if self.curves is None else self.curves


class Target(Protocol):
    """`most_pairs`: m n above which a slow target skips a case (the option --size-limit replaces
    it); None for targets that take any size."""

    name: str

    @property
    def most_pairs(self) -> int | None: ...

    def sum(self, case: AnyCase) -> Answer: ...

    def close(self) -> None: ...


def load_limit(limits: Limits) -> float:
    """Seconds for importing a `py:` target's module, or starting an adapter, before any call."""
    return max(LOAD_SECONDS, limits.seconds)


def skipped(message: str, declaration: Declaration = REGIONS) -> Answer:
    return Answer(verdict=Verdict.SKIPPED, message=message, declaration=declaration)


def lacking(declaration: Declaration, case: AnyCase, *more: str) -> str | None:
    """Says what keeps a case from a target; None if nothing does. `more`: other needs."""
    lacks = declaration.lacks(case.needs | set(more))
    if lacks:
        return f"does not declare {', '.join(lacks)}"
    return declaration.rounds(lambda: case.sent) if case.is_valid else None


def answered(rings: Any, seconds: float, turned: bool = False) -> Answer:
    """The answer of somebody else, put into canonical form. `turned`: its rings may run either way
    and are turned as their role demands."""
    try:
        plain = plain_polygons(json.loads(rings) if isinstance(rings, str) else rings)
    except MemoryError as error:
        return Answer(verdict=Verdict.OUT_OF_MEMORY, message=message_of(error), seconds=seconds)
    except Exception as error:  # noqa: BLE001 the objects of somebody else may do anything
        return no_set(error, seconds)
    try:
        return Answer(region_of_polygons(plain, turned), seconds=seconds)
    except ValueError as error:
        return no_set(error, seconds)


def no_set(error: Exception, seconds: float) -> Answer:
    message = f"the answer is not a polygon set: {message_of(error)}"
    return Answer(verdict=Verdict.ERRORED, message=message, seconds=seconds)
