"""The plane as a setting of `verify`."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from minkref import _core
from minkref.errors import refusing
from minkref.exact import read_scale
from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.cases.verbs import EVENTS, PATH, RANGES, REJECTS, UPDATE, is_path
from minkref.fuzz.geometry.number_text import number_of
from minkref.fuzz.invalid.invalid_case import FAMILY, InvalidCase, load_invalid
from minkref.fuzz.motion import asked_path
from minkref.fuzz.motion.asked_path import AskedPath, drawn_path, named_path
from minkref.fuzz.motion.small_path import SmallPath, smaller_paths
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.derived import derived
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.small_case import PlaneCase, smaller_in_plane
from minkref.fuzz.setting import Setting
from minkref.plane.operand import read_operand

if TYPE_CHECKING:
    from minkref.fuzz.plane.asking import PlaneAsking


class Plane(Setting):
    """Sets of polygons and uniform scales."""

    name, where, dimension = "plane", "in the plane", 2
    target = "minkref:paper"
    verbs = (UPDATE, EVENTS, REJECTS, PATH, RANGES)
    never = frozenset({"non-uniform"})

    def holds(self, operands: list[Any]) -> bool:
        return all(isinstance(each, dict) and "polygons" in each for each in operands)

    def is_document(self, value: Any) -> bool:
        return isinstance(value, dict) and value.get("schema") == "case-v1"

    def case_of(self, name: CaseName, operands: list[Any], scale: Any, where: str) -> Case:
        P, Q = (_valid(json.dumps(each), where) for each in operands)
        return Case(name, P, Q, read_scale(str(scale), where), "P", "Q", "named")

    def question(self, name: CaseName, value: dict[str, Any], where: str) -> AskedPath | None:
        return named_path(name, value, where) if "path" in value else None

    def scales_in(self, value: dict[str, Any], path: Path) -> list[str]:
        scales = value.get("scales")
        if isinstance(scales, list) and scales:
            return [str(scale) for scale in scales]
        return [_within(value.get("interval"))]

    def case_in(self, name: CaseName, path: Path, scale: str) -> Case:
        P, Q = (read_operand(f"{path}#{part}") for part in "PQ")
        return Case(name, P.set, Q.set, read_scale(scale), P.name, Q.name)

    def refuse_bad_operands(self, path: Path) -> None:
        for part in "PQ":
            read_operand(f"{path}#{part}")

    def drawn(
        self, name: CaseName, family: str, seed: int, index: int
    ) -> Case | InvalidCase | AskedPath | None:
        if family == FAMILY:
            return load_invalid(name, seed, index)
        if family in asked_path.FAMILIES:
            return drawn_path(name, family, seed, index)
        if family not in FAMILIES:
            return None
        pair = FAMILIES[family].pair(seed, index)
        P, Q = _core.PolygonSet.from_json(pair.P), _core.PolygonSet.from_json(pair.Q)
        return Case(name, P, Q, pair.scale, "P", "Q", family)

    def derived(
        self, base: AnyCase, name: CaseName, operation: str, number: int | None
    ) -> Case | None:
        if not isinstance(base, Case):
            raise NoCase("nothing is got from a case of invalid operands, or of a path")
        return derived(base, name, operation, number)

    @property
    def asking(self) -> type[PlaneAsking]:
        from minkref.fuzz.plane.asking import PlaneAsking  # it takes the targets, which take this

        return PlaneAsking

    def small_case(self, P: str, Q: str, scale: str, literal: str) -> PlaneCase | SmallPath:
        return SmallPath.read(literal) if is_path(literal) else PlaneCase.read(P, Q, scale)

    @property
    def smaller(self) -> Callable[[Any], Iterator[Any]]:
        return _smaller

    def has_case_file(self, literal: str) -> bool:
        return not is_path(literal)

    def scales_of_file(self, scale: str) -> list[str]:
        return [scale]


def _smaller(case: PlaneCase | SmallPath) -> Iterator[PlaneCase | SmallPath]:
    return smaller_paths(case) if isinstance(case, SmallPath) else smaller_in_plane(case)


def _valid(text: str, where: str) -> _core.PolygonSet:
    read: _core.PolygonSet = refusing(where, lambda: _core.read_text(text, "json", where))
    refusing(where, lambda: read.validate(where))
    return read


def _within(interval: Any) -> str:
    """1, or the end that is nearer to it."""
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
