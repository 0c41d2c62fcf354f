"""Cases asking about a plane set and a disc radius."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import Any, ClassVar

from minkref import _core
from minkref.errors import Refusal, refusing
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.needs import is_double, needs_of_plane
from minkref.fuzz.geometry.number_text import number_of
from minkref.fuzz.geometry.plane import Shape, read_shape, written_rings

NOTHING = '{"polygons":[]}'


@dataclass(frozen=True)
class SetAndRadius:
    """`verb`: the question, and the key of the set in the case's text. `position`: the kind that a
    drawn case has, and where its radius lies. To readers of two operands Q is empty."""

    name: CaseName
    set: _core.PolygonSet
    radius: Fraction
    family: str
    position: str = "given"

    verb: ClassVar[str]
    dimension = 2
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
        return needs_of_plane(self.P_json) | {self.verb} | rational

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
        value = {self.verb: json.loads(self.P_json), "radius": str(self.radius)}
        return json.dumps(value, separators=(",", ":"))

    @property
    def size(self) -> tuple[int, int, str]:
        return (self.set.vertices, len(self.literal), self.name.text)


def read_set_and_radius(
    value: dict[str, Any], verb: str, where: str, inward: bool = False
) -> tuple[_core.PolygonSet, Fraction]:
    """Reads the set and the radius of a JSON value; `inward` radii may lie below 0. Refuses other
    values."""
    given, radius = value[verb], value.get("radius")
    mend = f'write {{"{verb}":{{"polygons":[...]}},"radius":"7/5"}}'
    if not isinstance(given, dict) or "polygons" not in given:
        raise Refusal("this is not a polygon set", where, mend)
    number = read_radius(radius, where, mend, inward)
    read: _core.PolygonSet = refusing(
        where, lambda: _core.read_text(json.dumps(given), "json", where)
    )
    refusing(where, lambda: read.validate(where))
    return read, number


def read_radius(radius: Any, where: str, mend: str, inward: bool) -> Fraction:
    """Reads a radius above 0; `inward`, also one below 0. Refuses other values."""
    try:
        number = number_of(str(radius))
    except ValueError as error:
        raise Refusal(f"the radius is no number: {error}", where, mend) from error
    if number == 0 or (number < 0 and not inward):
        raise Refusal("the radius is 0" if inward else "the radius is not above 0", where, mend)
    return number
