"""Drafts from a generator, and facts about them."""

from __future__ import annotations

import json
from bisect import bisect_left
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref import _core
from minkref.certify.case_text import places
from minkref.certify.plane.predicate import Predicate, Vertices
from minkref.degeneracies import family
from minkref.degeneracies.plane.convolution_at import ConvolutionAt
from minkref.fuzz.geometry.plane import Shape
from minkref.fuzz.plane.families.drawing import shape_text

Place = tuple[str, str]
LARGEST_GAP = 2000  # 2^-k beside a scale is looked at down to this k


def valid_sets(texts: dict[str, str]) -> list[_core.PolygonSet]:
    """The sets by their names. Raises _core.BadInput if one is invalid."""
    found = []
    for name, text in texts.items():
        found.append(_core.PolygonSet.from_json(text))
        found[-1].validate(name)
    return found


def sets_in(value: dict[str, Any], names: str) -> list[_core.PolygonSet]:
    """The valid sets of a document. Raises _core.BadInput if one is invalid."""
    return valid_sets({name: json.dumps(value[name]) for name in names})


@dataclass(frozen=True)
class Draft:
    """Two operands and the degenerate scale. `zeros`: predicates that vanish there, or at all
    scales, in addition to the events' predicates. Vertices are numbered in the order of the shapes;
    shapes are drawn counter-clockwise, holes clockwise."""

    P: Shape
    Q: Shape
    scale: Fraction
    zeros: tuple[Predicate, ...] = ()


@dataclass(frozen=True)
class Facts:
    """A draft as the reference sees it. All exact, computed when asked for."""

    P: _core.PolygonSet
    Q: _core.PolygonSet
    scale: Fraction
    zeros: tuple[Predicate, ...] = ()

    @classmethod
    def of(cls, draft: Draft) -> Facts:
        """Raises _core.BadInput if an operand is invalid."""
        P, Q = valid_sets({"P": shape_text(draft.P), "Q": shape_text(draft.Q)})
        return cls(P, Q, draft.scale, draft.zeros)

    @classmethod
    def of_valid(cls, draft: Draft) -> Facts | None:
        """Returns None if an operand is invalid."""
        try:
            return cls.of(draft)
        except _core.BadInput:
            return None

    @cached_property
    def text(self) -> str:
        return str(self.scale)

    @cached_property
    def vertices(self) -> Vertices:
        return Vertices(places(self.P), places(self.Q))

    @cached_property
    def coordinates(self) -> list[Fraction]:
        """All vertex coordinates of both operands."""
        return [c for place in (*self.vertices.P, *self.vertices.Q) for c in place]

    @cached_property
    def arrangement(self) -> list[dict[str, Any]]:
        """The pair, parallel and triple events at the scale."""
        events = _core.ArrangementEvents(self.P, self.Q, self.text, self.text)
        edges = events.edges()
        return [
            {"kind": kind, "change": change, "edges": [edges[i] for i in on], "at": at, "to": to}
            for _, kind, change, on, at, to in events.rows(events.of_kind("arrangement"))
        ]

    @cached_property
    def _here(self) -> _core.DynamicSum:
        return _core.DynamicSum(self.P, self.Q, self.text, self.text)

    @cached_property
    def boundary(self) -> list[dict[str, Any]]:
        """The events of the boundary at the scale."""
        names = ("scale", "change", "edges", "at")
        return [dict(zip(names, row, strict=True)) for row in self._here.boundary_events()]

    @cached_property
    def topology(self) -> list[dict[str, Any]]:
        """The changes of holes and components at the scale."""
        names = ("scale", "feature", "change", "before", "after", "parts", "at")
        return [dict(zip(names, row, strict=True)) for row in self._here.topology_events()]

    @cached_property
    def gap(self) -> int:
        """The least k > 0 such that no other scale within 2^-k is critical. Bisection works, since
        a scale alone within a distance is alone within a smaller distance."""
        low, high = 0, 1
        while not self._is_free(high):
            if high >= LARGEST_GAP:
                raise ValueError(f"another event is within 2^-{high} of {self.scale}")
            low, high = high, 2 * high
        return bisect_left(range(high), True, low + 1, key=self._is_free)

    def _is_free(self, k: int) -> bool:
        near = Fraction(1, 2**k)
        return near < self.scale and self.is_alone(near)

    def is_alone(self, near: Fraction) -> bool:
        low, high = str(self.scale - near), str(self.scale + near)
        events = _core.ArrangementEvents(self.P, self.Q, low, high)
        rows = events.rows(events.of_kind("arrangement"))
        return all(row[0] == self.text for row in rows)

    @cached_property
    def at(self) -> _core.Sum:
        """The sum at the scale, with its tight passages."""
        return _core.minkowski_sum(self.P, self.Q, self.text, tight_passages=True)

    @cached_property
    def beside(self) -> tuple[_core.Sum, _core.Sum]:
        """The sums below and above, with no critical scale between."""
        near = Fraction(1, 2**self.gap)
        below, above = (
            _core.minkowski_sum(self.P, self.Q, str(s))
            for s in (self.scale - near, self.scale + near)
        )
        return below, above

    @cached_property
    def passages(self) -> list[list[Place]]:
        return [points for points, _ in self.at.passage_rows()]

    @cached_property
    def counts(self) -> tuple[tuple[int, int], ...]:
        """Components and holes below, at and above."""
        below, above = self.beside
        return tuple((s.components, s.holes) for s in (below, self.at, above))

    @cached_property
    def convolution(self) -> ConvolutionAt:
        return ConvolutionAt(self.P, self.Q, self.vertices, self.scale)

    @cached_property
    def wound_zero_times(self) -> tuple[Fraction, Fraction] | None:
        """A point inside the sum around which the full convolution winds zero times."""
        return self.convolution.wound_zero_times()

    @property
    def has_zeros(self) -> bool:
        """Whether all predicates in the draft vanish."""
        return all(self.vertices.value(zero, self.scale) == 0 for zero in self.zeros)


class Family(family.Family[Draft, Facts]):
    """A family of pairs in the plane."""

    def look(self, draft: Draft) -> Facts:
        facts = Facts.of(draft)
        if not facts.has_zeros:
            raise family.NothingDrawn
        return facts
