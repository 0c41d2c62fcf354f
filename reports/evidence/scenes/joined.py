"""Unions and sums by other libraries, each through a process."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref import PolygonSet
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cgal.oracle import CgalOracle
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.unions.asked_union import AskedUnion

SECONDS, BYTES = 900.0, 8 << 30


class Joining:
    """A process with a library's union, kept open; `name`: of the target, by default CGAL's."""

    def __init__(self, name: str = "cgal-join") -> None:
        target = ALL_TARGETS.target(name, Limits(SECONDS, BYTES))
        assert isinstance(target, AdapterTarget)
        self._name, self._target = name, target

    def join(self, sets: Sequence[PolygonSet]) -> tuple[PolygonSet, float]:
        """The union, canonical, and the seconds of the call, reading and writing included. Raises
        RuntimeError where the library has no answer."""
        if len(sets) < 2:
            return (sets[0] if sets else PolygonSet.from_json('{"polygons":[]}')), 0.0
        case = AskedUnion(CaseName("scene", "evidence"), tuple(sets))
        answer = self._target.union(case, case.texts)
        if answer.region is None:
            raise RuntimeError(f"{self._name}: {answer.verdict}: {answer.message}")
        return answer.region.set, answer.seconds

    def __enter__(self) -> Joining:
        return self

    def __exit__(self, *_: object) -> None:
        self._target.close()


class CgalSums:
    """Sums by CGAL's reduced convolution, in a process kept open."""

    def __init__(self) -> None:
        self._oracle = CgalOracle("reduced", seconds=SECONDS)

    def sum(
        self, shape: PolygonSet, scale: Fraction, turned: PolygonSet
    ) -> tuple[PolygonSet, float] | None:
        """CGAL's sum, and the seconds for its call; None if CGAL fails."""
        answer = self._oracle.sum(shape.scaled(str(scale)).to_json(), turned.to_json())
        if answer.rings_json is None:
            return None
        return PolygonSet.from_json(answer.rings_json), answer.seconds or 0.0
