"""Reference features: exact bars with places, bridges at a radius."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref import _core
from minkref.fuzz.features.exact_radius import ZERO, ExactRadius

Spot = tuple[float, float]
NearChord = tuple[Spot, Spot]


@dataclass(frozen=True)
class TrueBar:
    """`leaf` and `end`: numbers of tree nodes."""

    birth: ExactRadius
    death: ExactRadius | None
    leaf: int
    end: int

    def is_longer(self, length: Fraction) -> bool:
        return self.death is None or self.death.low - self.birth.high > length

    @property
    def text(self) -> str:
        return f"from {self.birth.text} to {self.death.text if self.death else 'infinity'}"


@dataclass(frozen=True)
class TrueBridge:
    """Doubles next to exact places. `centre`: the touching disc's."""

    ends: NearChord
    centre: Spot


class TrueFeatures:
    """Reference features, found once."""

    def __init__(self, P: _core.PolygonSet) -> None:
        self.found = _core.features(P)
        self._radii = {0: ZERO}
        for which, square, polynomial, (low, high) in self.found.radius_rows():
            exact = None if square is None else Fraction(square)
            factors = tuple(map(Fraction, polynomial))
            self._radii[which] = ExactRadius(Fraction(low), Fraction(high), exact, factors)

    @cached_property
    def bars(self) -> list[TrueBar]:
        return [
            TrueBar(self._radii[birth], None if death is None else self._radii[death], leaf, end)
            for leaf, birth, death, end, _, _ in self.found.bars()
        ]

    @cached_property
    def _nodes(self) -> list[Any]:
        return self.found.nodes()

    def place(self, node: int) -> Spot | None:
        """A node's place, nearly; None for the outside's root."""
        _, _, _, _, groups, end, _ = self._nodes[node]
        if end is not None:
            return float(Fraction(end[0])), float(Fraction(end[1]))
        if not groups:
            return None
        x, y = self.found.event(groups[0][0])[4]
        return float(x), float(y)

    def bridges(self, radius: Fraction) -> list[TrueBridge]:
        return [
            TrueBridge(((a[2], a[3]), (b[2], b[3])), (centre[2], centre[3]))
            for _, _, _, _, rows in self.found.at(str(2 * radius))
            for a, _, b, _, centre in rows
        ]

    def answer(self, radius: Fraction) -> str:
        """Writes everything as answers do (docs/adapter-protocol.md)."""
        shape = self.found.regions(str(radius**2))
        bars = [[_told(bar.birth), _told(bar.death)] for bar in self.bars]
        chords = [
            sorted([str(Fraction(x)) for x in end] for end in bridge.ends)
            for bridge in self.bridges(radius)
        ]
        value: dict[str, Any] = {"bars": sorted(bars, key=str), "bridges": sorted(chords)}
        value |= {"components": shape.components, "holes": shape.holes}
        return json.dumps(value, separators=(",", ":"))


def _told(radius: ExactRadius | None) -> Any:
    if radius is None:
        return None
    if radius.square is None:
        return [str(radius.low), str(radius.high)]
    text = radius.text
    return {"square": str(radius.square)} if text.startswith("sqrt") else text
