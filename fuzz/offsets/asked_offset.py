"""A case of the verb `offset`: a set in the plane, and the radius of the disc that it grows by.

The radius is a rational number above 0. Erosion, by a radius below 0, and open lines are no cases.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import Any

from minkref import _core
from minkref.errors import Refusal, refusing
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.needs import is_double, needs_of_plane
from minkref.fuzz.cases.verbs import OFFSET
from minkref.fuzz.geometry.number_text import number_of
from minkref.fuzz.geometry.plane import Shape, read_shape, written_rings
from minkref.fuzz.offsets.distance import Distances, Exact
from minkref.fuzz.offsets.exchange import IN_CURVES
from minkref.fuzz.offsets.hole_points import places_in_holes

MEND = 'write {"offset":{"polygons":[...]},"radius":"7/5"}'
NOTHING = '{"polygons":[]}'


@dataclass(frozen=True)
class AskedOffset:
    """`position`: the kind that a drawn case has, and where its radius lies. To readers of two
    operands Q is empty."""

    name: CaseName
    set: _core.PolygonSet
    radius: Fraction
    family: str = OFFSET
    position: str = "given"

    dimension = 2
    exchange = IN_CURVES
    is_valid = True
    scale = "1"
    P_name = "the set"
    Q_json = NOTHING

    @property
    def Q_name(self) -> str:
        return f"a disc of radius {self.radius}"

    @cached_property
    def P_json(self) -> str:
        return self.set.to_json()

    @property
    def scaled_P_json(self) -> str:
        return self.P_json

    @property
    def judged_operands(self) -> tuple[str, str]:
        return (self.P_json, self.Q_json)

    @cached_property
    def needs(self) -> frozenset[str]:
        rational = frozenset() if is_double(self.radius) else frozenset(("rational",))
        return needs_of_plane(self.P_json) | {OFFSET} | rational

    @cached_property
    def sent(self) -> list[Fraction]:
        """Returns all coordinates sent to an implementation; the radius may be off their grid."""
        rings = chain.from_iterable(written_rings(self.P_json))
        return [Fraction(number) for point in rings for number in point]

    @property
    def magnitude(self) -> Fraction:
        """Returns the largest absolute value of a coordinate."""
        return max(map(abs, self.sent), default=Fraction(0))

    @cached_property
    def shape(self) -> Shape:
        return read_shape(self.P_json)

    @cached_property
    def literal(self) -> str:
        value = {"offset": json.loads(self.P_json), "radius": str(self.radius)}
        return json.dumps(value, separators=(",", ":"))

    @property
    def size(self) -> tuple[int, int, str]:
        return (self.set.vertices, len(self.literal), self.name.text)

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
    given, radius = value["offset"], value.get("radius")
    if not isinstance(given, dict) or "polygons" not in given:
        raise Refusal("this is not a polygon set", where, MEND)
    try:
        number = number_of(str(radius))
    except ValueError as error:
        raise Refusal(f"the radius is no number: {error}", where, MEND) from error
    if number <= 0:
        raise Refusal("the radius is not above 0", where, MEND)
    read: _core.PolygonSet = refusing(
        where, lambda: _core.read_text(json.dumps(given), "json", where)
    )
    refusing(where, lambda: read.validate(where))
    return AskedOffset(name, read, number)
