"""A case of the verb `union`: sets in the plane."""

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
from minkref.fuzz.cases.needs import needs_of_plane
from minkref.fuzz.cases.verbs import UNION
from minkref.fuzz.geometry.plane import written_rings
from minkref.fuzz.geometry.region import Region
from minkref.fuzz.plane.protocol import IN_THE_PLANE

FEWEST_SETS = 2
MOST_SETS = 10_000
MEND = 'write {"sets":[{"polygons":[...]},{"polygons":[...]},...]}'


@dataclass(frozen=True)
class AskedUnion:
    """`position`: the degeneracy that a drawn case has. To readers of two operands P is the first
    set, and Q all polygons of the others."""

    name: CaseName
    sets: tuple[_core.PolygonSet, ...]
    family: str = UNION
    position: str = "given"

    dimension = 2
    exchange = IN_THE_PLANE
    is_valid = True
    scale = "1"
    P_name, Q_name = "the first set", "the other sets"

    @cached_property
    def texts(self) -> tuple[str, ...]:
        return tuple(each.to_json() for each in self.sets)

    @property
    def P_json(self) -> str:
        return self.texts[0]

    @cached_property
    def Q_json(self) -> str:
        return together(self.texts[1:])

    @property
    def scaled_P_json(self) -> str:
        return self.P_json

    @property
    def judged_operands(self) -> tuple[str, str]:
        return (self.P_json, self.Q_json)

    @cached_property
    def needs(self) -> frozenset[str]:
        return needs_of_plane(*self.texts) | {UNION}

    @cached_property
    def sent(self) -> list[Fraction]:
        """Returns all coordinates sent to an implementation."""
        rings = chain.from_iterable(map(written_rings, self.texts))
        return [Fraction(number) for ring in rings for point in ring for number in point]

    @property
    def magnitude(self) -> Fraction:
        """Returns the largest absolute value of a coordinate."""
        return max(map(abs, self.sent), default=Fraction(0))

    @property
    def vertices(self) -> int:
        return sum(each.vertices for each in self.sets)

    @cached_property
    def literal(self) -> str:
        value = {"sets": [json.loads(text) for text in self.texts]}
        return json.dumps(value, separators=(",", ":"))

    @property
    def size(self) -> tuple[int, int, str]:
        return (self.vertices, len(self.literal), self.name.text)

    @cached_property
    def expected(self) -> Region:
        """The union by the reference."""
        return Region(*_core.combined("union", list(self.sets)))


def together(texts: tuple[str, ...]) -> str:
    """Lists all polygons, perhaps overlapping: no valid set, but membership tests take it."""
    polygons = [polygon for text in texts for polygon in json.loads(text)["polygons"]]
    return json.dumps({"polygons": polygons}, separators=(",", ":"))


def named_union(name: CaseName, value: dict[str, Any], where: str) -> AskedUnion:
    """Returns the case that a JSON value describes. Refuses other values."""
    sets = value["sets"]
    if not isinstance(sets, list) or not FEWEST_SETS <= len(sets) <= MOST_SETS:
        what = f"the sets are not a list of {FEWEST_SETS} to {MOST_SETS:,}"
        raise Refusal(what, where, MEND)
    return AskedUnion(
        name, tuple(_set(each, f"{where}, set {k + 1}") for k, each in enumerate(sets))
    )


def _set(value: Any, where: str) -> _core.PolygonSet:
    if not isinstance(value, dict) or "polygons" not in value:
        raise Refusal("this is not a polygon set", where, MEND)
    text = json.dumps(value)
    read: _core.PolygonSet = refusing(where, lambda: _core.read_text(text, "json", where))
    refusing(where, lambda: read.validate(where))
    return read
