"""The paper's programs of Sections 3 and 4, as an adapter asks them."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.libraries.paper.program_name import ProgramName

Fields = dict[str, Any]
ELSEWHERE = ("1", "2")  # walks begin at the first other scale


class PlaneProgram:
    """One program, and its state after the last sum."""

    def __init__(self, name: ProgramName) -> None:
        self._name = name
        self._walk: _core.PaperUpdate | None = None

    def at(self, P: str, Q: str, scale: str | list[str]) -> Fields:
        """The static sum; or the sum by the update, walked from another scale. Sections 3 and 4
        know uniform scales: with a factor for each axis P is scaled first, and walked to 1."""
        self._walk = None
        first, second = _core.PolygonSet.from_json(P), _core.PolygonSet.from_json(Q)
        if isinstance(scale, list):
            first, scale = first.scaled(",".join(scale)), "1"
        if self._name.is_static:
            arithmetic = self._name.arithmetic
            return _fields(_core.minkowski_sum(first, second, scale, "paper", arithmetic))
        start = next(each for each in ELSEWHERE if each != scale)
        self._walk = self._begun(first, second, start)
        return self.update(scale)

    def update(self, scale: str) -> Fields:
        """Walks on from the last sum's scale."""
        if self._walk is None:
            raise ValueError("`update` before any sum")
        self._walk.move_to(scale)
        return _fields(self._walk.sum())

    def pair_events(self, P: str, Q: str, start: str, end: str) -> Fields:
        """The scales of its event array within a window."""
        low, high = Fraction(start), Fraction(end)
        first, second = _core.PolygonSet.from_json(P), _core.PolygonSet.from_json(Q)
        events = self._begun(first, second, ELSEWHERE[0]).events()
        scales = {Fraction(scale) for scale, *_ in events}
        return {"scales": [str(scale) for scale in sorted(scales) if low <= scale <= high]}

    def _begun(self, P: _core.PolygonSet, Q: _core.PolygonSet, start: str) -> _core.PaperUpdate:
        return _core.PaperUpdate(P, Q, start, self._name.arithmetic, self._name.readings)


def _fields(found: _core.Sum) -> Fields:
    fields: Fields = json.loads(found.region.canonical_json())
    return fields
