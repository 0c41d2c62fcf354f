"""Insets as sums: the outside plus a disc, with features named as in P."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.errors import Refusal


@dataclass(frozen=True)
class ErodedByDisc:
    """The `outside` of P: its sum with a disc leaves the inset as holes."""

    outside: _core.Outside

    @property
    def set(self) -> _core.PolygonSet:
        return self.outside.set

    def in_P(self, row: Any) -> Any:
        """Name an event's edges as P does; vertices keep their coordinates."""
        *rest, features = row
        own = [self.feature(*feature) for feature in features]
        return (*rest, sorted(own, key=lambda one: (one[0], *map(Fraction, one[1:]))))

    def feature(self, kind: str, first: str, second: str) -> tuple[str, str, str]:
        if kind == "vertex":
            return kind, first, second
        ring, index = self.outside.edge_of_P(int(first), int(second))
        return kind, str(ring), str(index)

    def largest(self, threads: int) -> list[Any]:
        """Find the events at the inradius, edges named as in P."""
        index = _core.disc_index(self.set, threads)
        first = last = len(index.kinds())
        radius = index.radii()[-1]
        while first > 0 and index.rows(first - 1, 1)[0][3] == radius:
            first -= 1
        return [self.in_P(row) for row in index.rows(first, last - first)]


def eroded_by_disc(P: _core.PolygonSet, name: str) -> ErodedByDisc:
    """Make P's outside. Refuses points and segments, which leave no disc room."""
    if not P.is_region:
        what = "it has no area, so that no disc has room in it"
        raise Refusal(what, name, "give a set of polygons", "degenerate-operands")
    return ErodedByDisc(_core.Outside(P))
