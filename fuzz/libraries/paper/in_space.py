"""The paper's repair of convex sums (Section 6), as an adapter asks it."""

from __future__ import annotations

import json
from typing import Any

from minkref import _core
from minkref.errors import Refusal
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.libraries.paper.program_name import ProgramName
from minkref.fuzz.space.convex_sum import body_of

Fields = dict[str, Any]
Scaling = tuple[str, str, str]
ELSEWHERE: tuple[Scaling, ...] = (("1", "1", "1"), ("2", "1", "1/3"))  # as in the plane


class SpaceProgram:
    """The repair, and its state after the last sum."""

    def __init__(self, name: ProgramName) -> None:
        self._name = name
        self._repair: _core.PaperRepair | None = None
        self._bodies: tuple[_core.ConvexPolyhedron, ...] = ()  # the repair looks at them

    def at(self, P: Fields, Q: Fields, scale: str | list[str]) -> Fields:
        """The exact pairs at another scaling, repaired at this one."""
        first, second = _body(P), _body(Q)
        to = _scaling(scale)
        start = next(each for each in ELSEWHERE if each != to)
        self._bodies = first, second
        self._repair = _core.PaperRepair(
            first, second, start, self._name.arithmetic, self._name.repair
        )
        return self.update(scale)

    def update(self, scale: str | list[str]) -> Fields:
        """Repairs on from the last sum's scaling; returns each claimed facet by itself."""
        if self._repair is None:
            raise ValueError("`update` before any sum")
        self._repair.update(_scaling(scale))
        claims = self._repair.facets()
        pairs = sorted({pair for _, ring in claims for pair in ring})
        number = {pair: k for k, pair in enumerate(pairs)}
        points = self._repair.coordinates(pairs)
        faces = [[number[pair] for pair in ring] for _, ring in claims]
        return {"vertices": [list(point) for point in points], "faces": faces}


def _body(value: Fields) -> _core.ConvexPolyhedron:
    """Raises BadInput with one reason for all operands that are not convex, or have no volume."""
    try:
        return body_of(Polyhedron.from_json(json.dumps(value)))
    except _core.BadInput as error:
        raise Refusal(
            "Section 6 is about convex polyhedra", "an operand", "", "not-convex"
        ) from error


def _scaling(scale: str | list[str]) -> Scaling:
    x, y, z = scale if isinstance(scale, list) else [scale] * 3
    return (x, y, z)
