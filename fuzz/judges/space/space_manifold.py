"""A sum's volume as Manifold computes it, in doubles."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.libraries.catalogue import absence, command
from minkref.fuzz.targets.adapter_process import AdapterProcess, Failure
from minkref.fuzz.targets.answer import Limits, load_limit

MANIFOLD = "manifold3d"
NEAREST = 1e-9  # relative difference of volumes that doubles explain
NO_LIMITS = Limits()


@dataclass(frozen=True)
class VolumeAnswer:
    """`volume` is None without an answer, and then `why` gives the reason. `seconds` counts
    Manifold's minkowski_sum only."""

    volume: float | None
    seconds: float | None = None
    why: str = ""

    def difference(self, exact: Fraction) -> float | None:
        """Relative, from the exact volume; None without an answer."""
        if self.volume is None:
            return None
        return float(abs(Fraction(self.volume) - exact) / exact)


class ManifoldJudge:
    """A child process for many sums, restarted after taking too long. Close it, or use `with`. Its
    sums are wrong if the origin lies outside Q."""

    def __init__(self, seconds: float, limits: Limits = NO_LIMITS) -> None:
        self._limits = replace(limits, seconds=seconds)
        line = command(MANIFOLD)
        self.absence = absence(MANIFOLD)
        self._process = None if line is None else AdapterProcess(MANIFOLD, line, self._limits)

    def __enter__(self) -> ManifoldJudge:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        if self._process is not None:
            self._process.close()

    def volume(self, sP: Polyhedron, Q: Polyhedron) -> VolumeAnswer:
        """The sum's volume, for solids with coordinates that doubles hold."""
        if self._process is None:
            return VolumeAnswer(None, why=str(self.absence))
        try:
            self._process.start()
            self._process.ask("load", load_limit(self._limits), dimension=3, Q=_in_doubles(Q))
            answer = self._process.ask("at", self._limits.seconds, sP=_in_doubles(sP))
        except Failure as failure:
            self._process.close()
            return VolumeAnswer(None, why=failure.message)
        if answer["status"] != "result":
            return VolumeAnswer(None, why=str(answer.get("reason") or answer["status"]))
        return VolumeAnswer(answer["library_volume"], answer["library_seconds"])


def _in_doubles(solid: Polyhedron) -> dict[str, Any]:
    vertices = [[float(number) for number in vertex] for vertex in solid.vertices]
    return {"vertices": vertices, "faces": [list(face) for face in solid.faces]}
