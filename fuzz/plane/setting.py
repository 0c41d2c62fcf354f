"""The plane as a setting of `verify`."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, ClassVar

from minkref import _core
from minkref.errors import refusing
from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.cases.verbs import (
    EVENTS,
    FEATURES,
    OFFSET,
    PAIR_EVENTS,
    PATH,
    RANGES,
    REJECTS,
    UNION,
    UPDATE,
)
from minkref.fuzz.geometry.number_text import number_of
from minkref.fuzz.plane.asking import PlaneAsking
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.derived import derived
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.small_case import PlaneCase, smaller_in_plane
from minkref.fuzz.setting import Setting
from minkref.plane.operand import read_operand
from minkref.plane.scaling import read_plane_scale, text_of


class Plane(Setting):
    """Sets of polygons, and scales, perhaps with a factor for each axis."""

    name, where, dimension = "plane", "in the plane", 2
    target = "minkref:paper"
    asking = PlaneAsking
    families: ClassVar[dict[str, str]] = {name: one.title for name, one in FAMILIES.items()}
    verbs = (UPDATE, EVENTS, PAIR_EVENTS, REJECTS, PATH, RANGES, UNION, OFFSET, FEATURES)
    never = frozenset({"non-uniform"})  # no case needs it: other targets get `S P` as P

    def holds(self, operands: list[Any]) -> bool:
        return all(isinstance(each, dict) and "polygons" in each for each in operands)

    def is_document(self, value: Any) -> bool:
        return isinstance(value, dict) and value.get("schema") == "case-v1"

    def case_of(self, name: CaseName, operands: list[Any], scale: Any, where: str) -> Case:
        P, Q = (_valid(json.dumps(each), where) for each in operands)
        return Case(name, P, Q, _scale(scale, where), "P", "Q", "named")

    def scales_in(self, value: dict[str, Any], path: Path) -> list[str]:
        scales = value.get("scales")
        if isinstance(scales, list) and scales:
            return [",".join(map(str, s)) if isinstance(s, list) else str(s) for s in scales]
        return [_within(value.get("interval"))]

    def case_in(self, name: CaseName, path: Path, scale: str) -> Case:
        P, Q = (read_operand(f"{path}#{part}") for part in "PQ")
        return Case(name, P.set, Q.set, _scale(scale, str(path)), P.name, Q.name)

    def refuse_bad_operands(self, path: Path) -> None:
        for part in "PQ":
            read_operand(f"{path}#{part}")

    def drawn(self, name: CaseName, family: str, seed: int, index: int) -> Case | None:
        if family not in FAMILIES:
            return None
        pair = FAMILIES[family].pair(seed, index)
        P, Q = _core.PolygonSet.from_json(pair.P), _core.PolygonSet.from_json(pair.Q)
        return Case(name, P, Q, pair.scale, "P", "Q", family)

    def derived(
        self, base: AnyCase, name: CaseName, operation: str, number: int | None
    ) -> Case | None:
        if not isinstance(base, Case):
            raise NoCase(
                "nothing is got from a case of invalid operands, of a path, of sets to unite, or "
                "of a set to grow"
            )
        return derived(base, name, operation, number)

    def small_case(self, P: str, Q: str, scale: str) -> PlaneCase:
        return PlaneCase.read(P, Q, scale)

    @property
    def smaller(self) -> Callable[[PlaneCase], Iterator[PlaneCase]]:
        return smaller_in_plane

    def scales_of_file(self, scale: str) -> list[str]:
        return [scale]


def _scale(scale: Any, where: str) -> str:
    text = ",".join(map(str, scale)) if isinstance(scale, list) else str(scale)
    return text_of(read_plane_scale(text, where))


def _valid(text: str, where: str) -> _core.PolygonSet:
    read: _core.PolygonSet = refusing(where, lambda: _core.read_text(text, "json", where))
    refusing(where, lambda: read.validate(where))
    return read


def _within(interval: Any) -> str:
    """Returns 1, or the interval's end nearest to 1."""
    ends = interval if isinstance(interval, dict) else {}
    try:
        if "from" in ends and number_of(str(ends["from"])) > 1:
            return str(ends["from"])
        if "to" in ends and number_of(str(ends["to"])) < 1:
            return str(ends["to"])
    except ValueError:
        pass  # the reader of cases refuses it
    return "1"


PLANE = Plane()
