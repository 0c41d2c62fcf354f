"""Cases of verb `offset`: a plane set, plus a disc radius.

The radius is a rational number above 0. Erosion, by a radius below 0, and open lines are no cases.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.verbs import OFFSET
from minkref.fuzz.offsets.distance import Distances, Exact
from minkref.fuzz.offsets.exchange import IN_CURVES
from minkref.fuzz.offsets.hole_points import places_in_holes
from minkref.fuzz.offsets.set_and_radius import SetAndRadius, read_set_and_radius


@dataclass(frozen=True)
class AskedOffset(SetAndRadius):
    family: str = OFFSET

    verb = OFFSET
    exchange = IN_CURVES

    @cached_property
    def expected(self) -> _core.Offset:
        """The sum by the reference."""
        return self.grown_by(self.radius)

    @cached_property
    def counts(self) -> tuple[int, int]:
        """Components and holes of the sum."""
        return self.expected.components, self.expected.holes

    def grown_by(self, radius: Fraction) -> _core.Offset:
        return _core.offset(self.set, str(radius**2))

    def holes_at(self, radius: Fraction) -> list[Exact]:
        """Finds a point for each hole at a radius, exactly."""
        near = Distances(self.shape)
        outside = (
            next((x for x in places if near.of(x).square > radius**2), None)
            for places in places_in_holes(self.grown_by(radius))
        )
        return [point for point in outside if point is not None]


def named_offset(name: CaseName, value: dict[str, Any], where: str) -> AskedOffset:
    """Returns the case that a JSON value describes. Refuses other values."""
    return AskedOffset(name, *read_set_and_radius(value, OFFSET, where))
