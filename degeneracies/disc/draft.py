"""Drafts from a generator of sums with a disc, and facts about them."""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from random import Random
from typing import Any

from minkref import _core
from minkref.degeneracies.family import Family
from minkref.degeneracies.plane.draft import valid_sets
from minkref.fuzz.geometry.plane import Shape, cross, dot, edges, minus
from minkref.fuzz.plane.families.drawing import shape_text

Spot = tuple[Fraction, Fraction]
LARGEST_GAP = 400  # 2^-k beside a squared radius is looked at down to this k
FINE = 60  # bits: the nearest siblings


@dataclass(frozen=True)
class Near:
    """A set's nearest points to a place. `joints`: nearest points at an edge's end, seen at a right
    angle to the edge."""

    squared_distance: Fraction
    points: tuple[Spot, ...]
    joints: tuple[Spot, ...]

    @classmethod
    def to(cls, shape: Shape, place: Spot) -> Near:
        """Applies the definition, in fractions: O(n)."""
        least: Fraction | None = None
        points: dict[Spot, bool] = {}
        for a, b in edges(shape):
            start, end = _spot(a), _spot(b)
            along = minus(end, start)
            part = dot(minus(place, start), along) / dot(along, along)
            inside = min(max(part, Fraction(0)), Fraction(1))
            foot = (start[0] + inside * along[0], start[1] + inside * along[1])
            off = minus(place, foot)
            square = dot(off, off)
            if least is None or square < least:
                least, points = square, {}
            if square == least:
                points[foot] = points.get(foot, False) or part in (0, 1)
        assert least is not None
        joints = tuple(sorted(point for point, joint in points.items() if joint))
        return cls(least, tuple(sorted(points)), joints)

    def opposite(self, place: Spot) -> bool:
        """Whether two points lie right across from each other."""
        ways = [minus(point, place) for point in self.points]
        return any(cross(u, v) == 0 and dot(u, v) < 0 for u in ways for v in ways)


@dataclass(frozen=True)
class DiscDraft:
    """A polygon set, a squared radius, and places at which something happens there. `were_near`:
    how many points were nearest to each, before a part was moved."""

    P: Shape
    squared_radius: Fraction
    places: tuple[Spot, ...]
    were_near: tuple[int, ...] = ()


@dataclass(frozen=True)
class DiscFacts:
    """A draft as the reference sees it, and the points nearest to the places."""

    P: _core.PolygonSet
    shape: Shape
    squared_radius: Fraction
    places: tuple[Spot, ...]
    were_near: tuple[int, ...] = ()
    _sums: dict[tuple[Fraction, str], _core.Offset] = field(default_factory=dict, compare=False)

    @classmethod
    def of(cls, draft: DiscDraft) -> DiscFacts:
        """Raises _core.BadInput if the set is invalid."""
        (P,) = valid_sets({"P": shape_text(draft.P)})
        return cls(P, draft.P, draft.squared_radius, draft.places, draft.were_near)

    @cached_property
    def near(self) -> list[Near]:
        """The nearest points to each place."""
        return [Near.to(self.shape, place) for place in self.places]

    @property
    def is_at_places(self) -> bool:
        """The places are as far as the radius."""
        return all(near.squared_distance == self.squared_radius for near in self.near)

    @cached_property
    def events(self) -> list[dict[str, Any]]:
        """The events at the radius."""
        return self.events_within(Fraction(0))

    def events_within(self, part: Fraction) -> list[dict[str, Any]]:
        """Up to this part of the squared radius below and above. Raises LimitExceeded where the
        reference does not tell."""
        found = self._window(part)
        rows = []
        for kind, square, _, radius, place, features in found.rows(0, len(found)):
            rows.append(
                {
                    "kind": kind,
                    "squared_radius": str(self.squared_radius) if part == 0 else square,
                    "radius": list(radius),
                    "place": list(place),
                    "features": [list(feature) for feature in features],
                }
            )
        return rows

    def _window(self, part: Fraction) -> _core.DiagramEvents:
        low, high = (self.squared_radius * (1 + step) for step in (-part, part))
        return _core.diagram_events(self.P, 1, str(low), str(high))

    @cached_property
    def gap(self) -> int:
        """The least k > 0 such that all events within 2^-k of the squared radius lie at the
        radius."""
        at = len(self._window(Fraction(0)))

        def is_free(k: int) -> bool:
            return len(self._window(Fraction(1, 2**k))) == at

        low, high = 0, 1
        while not is_free(high):
            if high >= LARGEST_GAP:
                raise ValueError(f"another event is within 2^-{high} of {self.squared_radius}")
            low, high = high, 2 * high
        return bisect_left(range(high), True, low + 1, key=is_free)

    @cached_property
    def squares(self) -> list[Fraction]:
        """The squared radius, and siblings below and above: the nearest powers of two apart from
        other events, and still nearer siblings."""
        parts = [Fraction(1, 2**k) for k in sorted({self.gap, max(self.gap, FINE)})]
        s = self.squared_radius
        return [s, *(s * (1 - part) for part in parts), *(s * (1 + part) for part in parts)]

    def sum(self, square: Fraction, route: str = "definition") -> _core.Offset:
        key = (square, route)
        if key not in self._sums:
            self._sums[key] = _core.offset(self.P, str(square), 1, route)
        return self._sums[key]

    @cached_property
    def counts(self) -> list[tuple[int, int]]:
        """Components and holes just below, at and just above the radius."""
        s, part = self.squared_radius, Fraction(1, 2**self.gap)
        found = [self.sum(square) for square in (s * (1 - part), s, s * (1 + part))]
        return [(each.components, each.holes) for each in found]

    @cached_property
    def passages(self) -> list[list[list[str]]]:
        """Tight at the radius: points, and segments by their ends."""
        found = self.sum(self.squared_radius).tight_passages()
        return [[list(point) for point in points] for points, _, _ in found]


class DiscFamily(Family[DiscDraft, DiscFacts]):
    """A family of sums with a disc."""

    def look(self, draft: DiscDraft) -> DiscFacts:
        return DiscFacts.of(draft)

    def tried(self, dice: Random, *size: int) -> tuple[DiscFacts, bool] | None:
        """Passes over sets whose events the reference does not tell."""
        try:
            return super().tried(dice, *size)
        except _core.BadInput:
            return None


def _spot(point: tuple[Fraction | int, Fraction | int]) -> Spot:
    return Fraction(point[0]), Fraction(point[1])
