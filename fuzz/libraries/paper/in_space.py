"""The paper's programs in space, as an adapter asks them: the repair of convex sums (Section 6),
and the update of all others (Section 5)."""

from __future__ import annotations

import json
from typing import Any

from minkref import _core
from minkref.errors import Refusal
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.libraries.paper.program_name import ProgramName
from minkref.fuzz.space.convex_sum import body_of
from minkref.fuzz.space.exact_sum import core_polyhedron, polyhedron_of_planes
from minkref.oracle.slow.space.exposed import exposed_from_json

Fields = dict[str, Any]
Scaling = tuple[str, str, str]
ELSEWHERE: tuple[Scaling, ...] = (("1", "1", "1"), ("2", "1", "1/3"))  # as in the plane
ANOTHER = ("1", "2")  # uniform scales, likewise


class SpaceProgram:
    """The program for a pair, and its state after the last sum."""

    def __init__(self, name: ProgramName) -> None:
        self._name = name
        self._walk: _Repair | _Update | None = None

    def at(self, P: Fields, Q: Fields, scale: str | list[str]) -> Fields:
        first, second = (Polyhedron.from_json(json.dumps(value)) for value in (P, Q))
        to = _scaling(scale)
        try:
            self._walk = _Repair(self._name, body_of(first), body_of(second), to)
        except _core.BadInput:
            self._walk = _Update(self._name, first, second, to)
        return self._walk.move_to(to)

    def update(self, scale: str | list[str]) -> Fields:
        """Goes on from the last sum's scaling."""
        if self._walk is None:
            raise ValueError("`update` before any sum")
        return self._walk.move_to(_scaling(scale))


class _Repair:
    """The exact pairs at another scaling, repaired from scaling to scaling; each claimed facet by
    itself."""

    def __init__(
        self, name: ProgramName, P: _core.ConvexPolyhedron, Q: _core.ConvexPolyhedron, to: Scaling
    ) -> None:
        start = next(each for each in ELSEWHERE if each != to)
        self._bodies = P, Q  # the repair looks at them
        self._repair = _core.PaperRepair(P, Q, start, name.arithmetic, name.repair)

    def move_to(self, to: Scaling) -> Fields:
        self._repair.update(to)
        claims = self._repair.facets()
        pairs = sorted({pair for _, ring in claims for pair in ring})
        number = {pair: k for k, pair in enumerate(pairs)}
        points = self._repair.coordinates(pairs)
        faces = [[number[pair] for pair in ring] for _, ring in claims]
        return {"vertices": [list(point) for point in points], "faces": faces}


class _Update:
    """The walk along the events from another uniform scale, in rational numbers. Section 5 knows
    uniform scales: with a factor for each axis P is scaled first, and walked to 1."""

    def __init__(self, name: ProgramName, P: Polyhedron, Q: Polyhedron, to: Scaling) -> None:
        first, second = core_polyhedron(P), core_polyhedron(Q)
        self._is_scaled = len(set(to)) > 1
        if self._is_scaled:
            first = first.scaled(to)
        self._to = to
        start = next(each for each in ANOTHER if each != self._uniform(to))
        self._walk = _core.PaperSpaceUpdate(first, second, start, name.arithmetic, name.facets)

    def _uniform(self, to: Scaling) -> str:
        if to == self._to and self._is_scaled:
            return "1"
        if self._is_scaled or len(set(to)) > 1:
            what = "Section 5 is about uniform scales"
            raise Refusal(what, "an update", "", "scale-not-uniform")
        return to[0]

    def move_to(self, to: Scaling) -> Fields:
        self._walk.move_to(self._uniform(to))
        found = self._walk.sum()
        exact = found.set()
        if exact is None:
            what = "facets in a rounding arithmetic need not bound a set"
            raise Refusal(what, "a sum", "", "no-surface")
        text = json.loads(exact.canonical_json())
        faces: Fields = json.loads(polyhedron_of_planes(exposed_from_json(text)).to_json())
        return faces


def _scaling(scale: str | list[str]) -> Scaling:
    x, y, z = scale if isinstance(scale, list) else [scale] * 3
    return (x, y, z)
