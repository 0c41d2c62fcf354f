"""A CGAL method in the plane, each call in a child process of the oracle's server."""

from __future__ import annotations

from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.cgal.executables import executable_of_target, method_of_target
from minkref.fuzz.cgal.oracle import CgalOracle
from minkref.fuzz.plane.case import Case
from minkref.fuzz.targets.answer import Answer, Limits, answered, skipped
from minkref.fuzz.verdicts.verdict import Verdict

SLOW_LIMIT = 10_000
FAST = ("reduced",)


class CgalMethod:
    def __init__(self, name: str, limits: Limits) -> None:
        self.name = name
        method, raw = method_of_target(name)
        self._oracle = CgalOracle(
            method, executable_of_target(name), raw=raw, seconds=limits.seconds, bytes=limits.bytes
        )

    @property
    def most_pairs(self) -> int | None:
        return None if method_of_target(self.name)[0] in FAST else SLOW_LIMIT

    def sum(self, case: AnyCase) -> Answer:
        if not isinstance(case, Case):
            return skipped("does not declare space, rejects-invalid, or path")
        answer = self._oracle.sum(case.scaled_P_json, case.Q_json)
        if answer.status != "result":
            return Answer(
                verdict=Verdict(answer.status),
                message=answer.reason or "",
                signal=answer.signal,
                seconds=answer.seconds or 0.0,
            )
        return answered(answer.rings_json or "", answer.seconds or 0.0)

    def close(self) -> None:
        self._oracle.close()
