"""The sum with a disc of one radius, read off an index of all radii."""

from __future__ import annotations

from functools import cached_property
from typing import Any

from minkref import _core
from minkref.output.documents import Stopwatch


class IndexedSum:
    """A sum as commands ask for it. Read off are the canonical form, components, holes, area and
    length. Pictures, exact measures, and tight passages (at events only) come from the static sum,
    which is made when one of these is asked for."""

    def __init__(self, index: _core.DiscIndex, P: _core.PolygonSet, square: str) -> None:
        self._index, self._set, self._square = index, P, square
        watch = Stopwatch()
        self._canonical = index.canonical_json(square)
        self.components, self.holes = index.counts(square)
        self.area, self.length = index.measures(square)
        self.seconds = index.seconds + watch.seconds()
        self.curves = self._canonical.count('["')
        self.statistics = {
            "radii_of_events": len(index),
            "parts_of_the_diagram": index.parts,
            "exact_signs": index.exact_signs,
        }

    @cached_property
    def static(self) -> _core.Offset:
        return _core.offset(self._set, self._square)

    def canonical_json(self) -> str:
        return self._canonical

    def tight_passages(self, threads: int = 1) -> Any:
        at_event = self._index.at_event(self._square)
        return self.static.tight_passages(threads) if at_event else []

    def exact_measures(self) -> Any:
        return self.static.exact_measures()
