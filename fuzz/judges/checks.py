"""The targets `minkref@...`: one part of the reference before one judge."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec

from minkref import _core, proved_program
from minkref.errors import message_of
from minkref.fuzz.cgal.executables import SWEPT_SOLID, OracleNotFoundError, find_executable
from minkref.fuzz.judges.ruling import Ruling
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run.offer import Judge, Offer
from minkref.fuzz.targets.answer import JUDGED, Limits
from minkref.fuzz.verdicts.verdict import Outcome, Verdict

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
    "sampled-events": (
        "sampled_events",
        "boundary events and what they do to holes and components, against sums around every scale",
    ),
    "proved-sums": (
        "proved_sums",
        "sums and decisions of points, against the program extracted from proofs in Coq",
    ),
}
# These judge a factor for each axis; the others get `S P` as P.
BY_AXES = ("slow-sums", "slow-tight-passages", "slow-points")
LONG_NUMBER = re.compile(r"[0-9/-]{4001}")
SYMBOLIC_NEEDS = ("sympy", "gmpy2")
# Pairs of vertices, m n, above which a judge skips a case.
SIZE_LIMITS = {
    "slow-sums": 400,
    "slow-topology": 400,
    "slow-tight-passages": 400,
    "sampled-events": 600,
    "proved-sums": 200,
}


def absence(name: str) -> str | None:
    """Why a judge cannot sit; None if it can."""
    check = name.removeprefix(JUDGED)
    if check == "symbolic-events":
        missing = [package for package in SYMBOLIC_NEEDS if find_spec(package) is None]
        return f"pip install {' '.join(missing)}" if missing else None
    if check == "swept-boundary":
        try:
            find_executable(SWEPT_SOLID)
        except OracleNotFoundError as error:
            return str(error)
    if check == "sampled-events":
        from minkref.fuzz.judges.plane.sampled_events import find_executable as find_sampled

        try:
            find_sampled()
        except OracleNotFoundError as error:
            return str(error)
    if check == "proved-sums" and proved_program.found() is None:
        return f"{proved_program.PROGRAM} is not built: {proved_program.BUILT_BY}"
    return None


def _is_thin(operand: _core.PolygonSet) -> bool:
    return not operand.is_region and not operand.is_empty


@dataclass
class Check:
    """One target `minkref@...` within a worker."""

    name: str
    size: int | None = None  # vertex pairs, instead of SIZE_LIMITS

    def __post_init__(self) -> None:
        self._open = ExitStack()
        module = import_module(f"minkref.fuzz.judges.plane.{MODULES[self._short][0]}")
        self._judge: Callable[..., Ruling] = module.judge
        self._arguments: tuple[object, ...] = ()
        if self._short == "swept-boundary":
            from minkref.fuzz.cgal.swept_solid import SweptSolid

            self._arguments = (self._open.enter_context(SweptSolid()),)
        if self._short == "sampled-events":
            from minkref.fuzz.judges.plane.sampled_events import SampledEvents

            self._arguments = (self._open.enter_context(SampledEvents()),)

    @property
    def _short(self) -> str:
        return self.name.removeprefix(JUDGED)

    def rule(self, case: Case) -> Outcome:
        """The verdict on the reference: wrong where the judge disagrees, and errored where the
        reference or the judge fails."""
        since = time.perf_counter()
        limit = SIZE_LIMITS.get(self._short)
        if limit is not None:
            limit = self.size if self.size is not None else limit
            if case.vertex_pairs > limit:
                pairs = f"{case.vertex_pairs:,} pairs of vertices"
                message = f"{pairs}, more than {limit:,} (--size-limit)"
                return Outcome(self.name, Verdict.SKIPPED, message=message)
        if _is_thin(case.P) and _is_thin(case.Q):
            message = "both operands are points or segments, which have no sum"
            return Outcome(self.name, Verdict.SKIPPED, message=message)
        if self._short.startswith("slow-") and any(
            LONG_NUMBER.search(text) for text in (case.P_json, case.Q_json)
        ):
            message = "numbers of more digits than the slow engine reads"
            return Outcome(self.name, Verdict.SKIPPED, message=message)
        if not case.is_uniform and self._short not in BY_AXES:
            case = case.taken_by(frozenset())
        try:
            return self._judge(case, *self._arguments).outcome(
                self.name, time.perf_counter() - since
            )
        except MemoryError as error:
            verdict, message = Verdict.OUT_OF_MEMORY, message_of(error)
        except Exception as error:  # noqa: BLE001 a fault on either side, of any type
            verdict, message = Verdict.ERRORED, message_of(error)
        seconds = time.perf_counter() - since
        return Outcome(self.name, verdict, message=message, seconds=seconds)

    def close(self) -> None:
        self._open.close()


def _judge(name: str, limits: Limits) -> Judge:
    return Check(name, limits.size)


OFFER = Offer({JUDGED + name: about for name, (_, about) in MODULES.items()}, absence, _judge)
