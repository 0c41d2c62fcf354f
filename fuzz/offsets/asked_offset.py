"""Cases of verb `offset`: a plane set, plus a disc radius.

The radius is a rational number. A set grows by a radius above 0, and a radius below 0 erodes it: it
keeps the points whose distance from its outside is the radius or more.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.verbs import INSET, OFFSET
from minkref.fuzz.offsets.curves import NOTHING, form_of
from minkref.fuzz.offsets.distance import Distances, Exact, OutsideDistances
from minkref.fuzz.offsets.event_window import event_within
from minkref.fuzz.offsets.exchange import IN_CURVES
from minkref.fuzz.offsets.hole_points import places_in_rings
from minkref.fuzz.offsets.set_and_radius import SetAndRadius, read_set_and_radius


@dataclass(frozen=True)
class AskedOffset(SetAndRadius):
    family: str = OFFSET

    verb = OFFSET
    exchange = IN_CURVES

    @property
    def inward(self) -> bool:
        return self.radius < 0

    @property
    def is_nothing(self) -> bool:
        """Whether the answer has no interior whatever the radius is."""
        return self.set.is_empty or (self.inward and not self.set.is_region)

    @property
    def Q_name(self) -> str:
        return f"a disc of radius {abs(self.radius)}" + (", to erode by" if self.inward else "")

    @cached_property
    def needs(self) -> frozenset[str]:
        return super().needs | (frozenset((INSET,)) if self.inward else frozenset())

    @cached_property
    def expected(self) -> _core.Offset:
        """The sum, or the erosion, by the reference."""
        return self.by_disc(self.radius)

    @cached_property
    def form(self) -> str:
        """The truth in curves, as `read_curves` writes them."""
        return NOTHING if self.is_nothing else form_of(self.expected.canonical_json())

    @cached_property
    def counts(self) -> tuple[int, int]:
        """Components and holes of the truth."""
        return self.expected.components, self.expected.holes

    @cached_property
    def near(self) -> Distances:
        """Distances from the set or, to erode, from its outside."""
        return OutsideDistances(self.shape) if self.inward else Distances(self.shape)

    def by_disc(self, radius: Fraction, *route: Any) -> _core.Offset:
        """Grows or erodes the set. `route`: threads and the name of a route."""
        of = _core.inset if self.inward else _core.offset
        return of(self.set, str(radius**2), *route)

    def beyond(self, radius: Fraction) -> list[Exact]:
        """Finds a point farther than a radius in each hole of the grown set or, to erode, in each
        component of what is left, exactly."""
        grown = self.by_disc(radius)
        found = (
            next((x for x in places if self.near.of(x).square > radius**2), None)
            for places in places_in_rings(grown, outer=self.inward)
        )
        return [point for point in found if point is not None]

    def has_event(self, half: Fraction) -> bool:
        """Whether an event has a radius that differs by at most `half`."""
        P, middle = self.set, abs(self.radius)
        return event_within(
            _core.Outside(P).set if self.inward else P, middle - half, middle + half
        )


def named_offset(name: CaseName, value: dict[str, Any], where: str) -> AskedOffset:
    """Returns the case that a JSON value describes. Refuses other values."""
    return AskedOffset(name, *read_set_and_radius(value, OFFSET, where, inward=True))
