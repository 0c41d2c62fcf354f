"""A case with an invalid operand, for targets to refuse."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.invalid.family import invalid_pair
from minkref.fuzz.plane.protocol import IN_THE_PLANE

FAMILY = "invalid"
NEEDS = frozenset(("plane", "rejects-invalid"))


@dataclass
class InvalidCase:
    """`kind` names the fault in one operand, `refusal` gives the reference's words, and `place` the
    point that they name."""

    name: CaseName
    kind: str
    P_json: str
    Q_json: str
    refusal: str
    place: tuple[str, str] | None
    family: str = FAMILY
    position: str = "given"
    scale: str = "1"
    P_name: str = "P"
    Q_name: str = "Q"

    dimension = 2
    exchange = IN_THE_PLANE
    needs = NEEDS
    is_valid = False
    sent: ClassVar[list[Fraction]] = []

    @property
    def scaled_P_json(self) -> str:
        return self.P_json

    @property
    def judged_operands(self) -> tuple[str, str]:
        return (self.P_json, self.Q_json)

    @property
    def literal(self) -> str:
        return f'{{"P":{self.P_json},"Q":{self.Q_json},"scale":"1"}}'

    @property
    def size(self) -> tuple[int, int, str]:
        text = self.P_json + self.Q_json
        return (text.count("[") - text.count("[["), len(text), self.name.text)


def load_invalid(name: CaseName, seed: int, index: int) -> InvalidCase:
    kind, P, Q = invalid_pair(seed, index)
    refusal, place = "", None
    for text, which in ((P, "P"), (Q, "Q")):
        try:
            _core.PolygonSet.from_json(text).validate(which)
        except _core.BadInput as error:
            refusal = f"{which}: {error}"
            corners = list(getattr(error, "coordinates", None) or [])
            place = _place(corners)
        except ValueError as error:
            refusal = f"{which}: {error}"
    return InvalidCase(name, kind, P, Q, refusal, place or _first(P, Q))


def _place(corners: list[object]) -> tuple[str, str] | None:
    for corner in corners:
        if isinstance(corner, list | tuple) and len(corner) == 2:
            return (str(corner[0]), str(corner[1]))
    return None


def _first(P: str, Q: str) -> tuple[str, str] | None:
    """Returns a vertex of an operand."""
    for text in (P, Q):
        for polygon in json.loads(text)["polygons"]:
            for x, y in polygon["outer"]:
                return (str(x), str(y))
    return None
