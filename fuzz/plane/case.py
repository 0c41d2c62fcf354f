"""A case in the plane: two operands and a scale."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.needs import is_double, needs_of_plane
from minkref.fuzz.geometry.plane import is_uniform, written_rings
from minkref.fuzz.plane.protocol import IN_THE_PLANE

NON_UNIFORM = "non-uniform"


@dataclass
class Case:
    name: CaseName
    P: _core.PolygonSet
    Q: _core.PolygonSet
    scale: str
    P_name: str
    Q_name: str
    family: str = "named"
    position: str = "given"  # the scale's place among the pair's boundary events
    law: tuple[str, Case] | None = None  # the law that changed the case, and the original case

    dimension = 2
    exchange = IN_THE_PLANE
    is_valid = True

    @cached_property
    def P_json(self) -> str:
        return self.P.to_json()

    @cached_property
    def Q_json(self) -> str:
        return self.Q.to_json()

    @property
    def is_uniform(self) -> bool:
        return is_uniform(self.scale)

    def taken_by(self, capabilities: frozenset[str]) -> Case:
        """The case as an implementation with these capabilities is asked it: one that knows no
        factor for each axis gets `S P` as P, at the scale 1."""
        if self.is_uniform or NON_UNIFORM in capabilities:
            return self
        return replace(self, P=self.P.scaled(self.scale), scale="1")

    @cached_property
    def scaled_P_json(self) -> str:
        return self.P_json if self.scale == "1" else self.P.scaled(self.scale).to_json()

    @property
    def judged_operands(self) -> tuple[str, str]:
        return (self.P_json, self.Q_json)

    @property
    def vertex_pairs(self) -> int:
        return self.P.vertices * self.Q.vertices

    @property
    def size(self) -> tuple[int, int, str]:
        """Smaller is easier to read: vertices first, then the length of the numbers."""
        return (
            self.P.vertices + self.Q.vertices,
            len(self.P_json) + len(self.Q_json) + len(self.scale),
            self.name.text,
        )

    @cached_property
    def needs(self) -> frozenset[str]:
        """The capabilities that an implementation needs to be sent P, sP and Q."""
        needs = needs_of_plane(self.scaled_P_json, self.Q_json)
        if self.scale == "1" or all(map(is_double, _numbers(self.P_json))):
            return needs
        return needs | {"rational"}

    @cached_property
    def magnitude(self) -> Fraction:
        """Adds the largest absolute coordinates of sP and of Q."""
        return sum(
            (
                max(map(abs, _numbers(text)), default=Fraction(0))
                for text in (self.scaled_P_json, self.Q_json)
            ),
            Fraction(0),
        )

    @cached_property
    def coordinates(self) -> list[Fraction]:
        """Returns the coordinates of sP and of Q."""
        return _numbers(self.scaled_P_json) + _numbers(self.Q_json)

    @cached_property
    def sent(self) -> list[Fraction]:
        """Returns all coordinates sent to an implementation, including P's."""
        return _numbers(self.P_json) + self.coordinates

    @property
    def literal(self) -> str:
        """Writes the case as a text that names it, on one line."""
        P, Q = _without_empty(self.P_json), _without_empty(self.Q_json)
        return f'{{"P":{P},"Q":{Q},"scale":"{self.scale}"}}'


def _numbers(text: str) -> list[Fraction]:
    return [Fraction(number) for ring in written_rings(text) for point in ring for number in point]


def _without_empty(text: str) -> str:
    """Integers as such and no empty lists of holes: shorter to read."""
    polygons = [
        {
            name: rings
            for name, rings in (
                ("outer", _short(polygon["outer"])),
                ("holes", [_short(hole) for hole in polygon["holes"]]),
            )
            if rings
        }
        for polygon in json.loads(text)["polygons"]
    ]
    return json.dumps({"polygons": polygons}, separators=(",", ":"))


def _short(ring: list[list[str]]) -> list[list[int | str]]:
    return [[number if "/" in number else int(number) for number in point] for point in ring]
