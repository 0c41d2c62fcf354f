"""CGAL's sum of Nef polyhedra in the canonical form of a sum in space, comparable as text."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.libraries.catalogue import absence, command
from minkref.fuzz.targets.adapter_process import AdapterProcess, Failure
from minkref.fuzz.targets.answer import Limits, load_limit
from minkref.oracle.slow import of_faces

NEF = "cgal-nef"
NO_LIMITS = Limits()


@dataclass(frozen=True)
class NefAnswer:
    """`text` is canonical JSON, None without an answer, and then `why` gives the reason. `seconds`
    counts CGAL's minkowski_sum_3 only, from Nef polyhedra to a Nef polyhedron whose exact
    coordinates may still be unevaluated."""

    text: str | None
    seconds: float | None = None
    why: str = ""


class NefJudge:
    """A child process for many sums, restarted after taking too long. Close it, or use `with`."""

    def __init__(self, seconds: float, limits: Limits = NO_LIMITS) -> None:
        self._limits = replace(limits, seconds=seconds)
        line = command(NEF)
        self.absence = absence(NEF)
        self._process = None if line is None else AdapterProcess(NEF, line, self._limits)

    def __enter__(self) -> NefJudge:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        if self._process is not None:
            self._process.close()

    def sum(self, sP: Polyhedron, Q: Polyhedron) -> str | None:
        """Canonical JSON; None without an answer in time. The slow engine's code joins CGAL's exact
        faces plane by plane; InputError if faces overlap."""
        return self.timed_sum(sP, Q).text

    def timed_sum(self, sP: Polyhedron, Q: Polyhedron) -> NefAnswer:
        """The sum with its time, or with the reason for its absence."""
        if self._process is None:
            return NefAnswer(None, why=str(self.absence))
        try:
            self._process.start()
            self._process.ask("load", load_limit(self._limits), dimension=3, Q=Q.document())
            answer = self._process.ask("at", self._limits.seconds, sP=sP.document(), timed=True)
        except Failure as failure:
            self._process.close()
            return NefAnswer(None, why=failure.message)
        if answer["status"] != "result":
            return NefAnswer(None, why=str(answer.get("reason") or answer["status"]))
        return NefAnswer(_text(answer), answer.get("cgal_seconds"))


def _text(answer: dict[str, Any]) -> str:
    points = [tuple(Fraction(number) for number in row) for row in answer["vertices"]]
    corners = [(x, y, z) for x, y, z in points]
    return of_faces([corners[k] for k in face] for face in answer["faces"]).text()
