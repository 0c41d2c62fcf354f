"""The targets `minkref@...`: one part of the reference before one judge."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec

from minkref.errors import message_of
from minkref.fuzz.case import Case
from minkref.fuzz.cgal_executables import SWEPT_SOLID, OracleNotFoundError, find_executable
from minkref.fuzz.judges.ruling import Ruling
from minkref.fuzz.verdict import Outcome, Verdict

PREFIX = "minkref@"
ALL = "minkref"  # every check
MODULES = {
    "slow-sums": ("slow_sums", "sums by all routes, against the slow engine"),
    "slow-topology": ("slow_topology", "topology at events, against the slow engine"),
    "slow-tight-passages": ("slow_tight_passages", "tight passages, against the slow engine"),
    "slow-points": ("slow_points", "decisions of points, against the slow engine"),
    "symbolic-events": (
        "symbolic_events",
        "pair, parallel and triple events, against the symbolic oracle",
    ),
    "swept-boundary": ("swept_boundary", "boundary events, against the swept solid"),
}
SYMBOLIC_NEEDS = ("sympy", "gmpy2")
# Pairs of vertices, m n, above which a judge skips a case.
SIZE_LIMITS = {"slow-sums": 400, "slow-topology": 400, "slow-tight-passages": 400}


def names() -> list[str]:
    return [PREFIX + name for name in MODULES]


def absence(name: str) -> str | None:
    """Why a judge cannot sit; None if it can."""
    check = name.removeprefix(PREFIX)
    if check == "symbolic-events":
        missing = [package for package in SYMBOLIC_NEEDS if find_spec(package) is None]
        return f"pip install {' '.join(missing)}" if missing else None
    if check == "swept-boundary":
        try:
            find_executable(SWEPT_SOLID)
        except OracleNotFoundError as error:
            return str(error)
    return None


@dataclass
class Check:
    """One of the targets, in one worker."""

    name: str

    def __post_init__(self) -> None:
        self._open = ExitStack()
        module = import_module(f"minkref.fuzz.judges.{MODULES[self._short][0]}")
        self._judge: Callable[..., Ruling] = module.judge
        self._arguments: tuple[object, ...] = ()
        if self._short == "swept-boundary":
            from minkref.fuzz.swept_solid import SweptSolid

            self._arguments = (self._open.enter_context(SweptSolid()),)

    @property
    def _short(self) -> str:
        return self.name.removeprefix(PREFIX)

    def rule(self, case: Case) -> Outcome:
        """The verdict on the reference: wrong where the judge disagrees, and errored where the
        reference or the judge fails."""
        since = time.perf_counter()
        limit = SIZE_LIMITS.get(self._short)
        if limit is not None and case.vertex_pairs > limit:
            message = f"{case.vertex_pairs:,} pairs of vertices, more than {limit:,}"
            return Outcome(self.name, Verdict.SKIPPED, message=message)
        try:
            ruling = self._judge(case, *self._arguments)
        except MemoryError as error:
            return Outcome(self.name, Verdict.OUT_OF_MEMORY, message=message_of(error))
        except Exception as error:  # noqa: BLE001 a fault of either side, whatever it is
            return Outcome(self.name, Verdict.ERRORED, message=message_of(error))
        return ruling.outcome(self.name, time.perf_counter() - since)

    def close(self) -> None:
        self._open.close()
