"""Space as a setting of `verify`."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.cases.verbs import UPDATE
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.setting import Setting
from minkref.fuzz.space.asking import SpaceAsking
from minkref.fuzz.space.case import LAWS_IN_SPACE, SpaceCase, load_space
from minkref.fuzz.space.case_file import DIMENSION, is_in_space, read_space_case, scalings_in
from minkref.fuzz.space.families import SPACE_FAMILIES
from minkref.fuzz.space.hull import is_convex
from minkref.fuzz.space.small_case import SolidCase, smaller_in_space

SOME_SCALING = "1"  # operands are read before a run, scalings when their turn comes


class Space(Setting):
    """Polyhedra, and scales with one factor or three."""

    name, where, dimension = "space", "in space", DIMENSION
    target = "minkref:convex"
    asking = SpaceAsking
    families = SPACE_FAMILIES
    verbs = (UPDATE,)

    def holds(self, operands: list[Any]) -> bool:
        return all(isinstance(each, dict) and "faces" in each for each in operands)

    def is_document(self, value: Any) -> bool:
        return is_in_space(value)

    def case_of(self, name: CaseName, operands: list[Any], scale: Any, where: str) -> SpaceCase:
        return SpaceCase.of(name, operands, scale, where)

    def scales_in(self, value: dict[str, Any], path: Path) -> list[str]:
        return scalings_in(value, str(path))

    def case_in(self, name: CaseName, path: Path, scale: str) -> SpaceCase:
        return read_space_case(name, path, scale)

    def refuse_bad_operands(self, path: Path) -> None:
        read_space_case(CaseName(str(path), "case files"), path, SOME_SCALING)

    def drawn(self, name: CaseName, family: str, seed: int, index: int) -> SpaceCase | None:
        return load_space(name, family, seed, index) if family in SPACE_FAMILIES else None

    def derived(
        self, base: AnyCase, name: CaseName, operation: str, number: int | None
    ) -> SpaceCase:
        assert isinstance(base, SpaceCase)
        if number is None and operation in LAWS_IN_SPACE:
            return base.under(operation, name)
        if number is None and operation == UPDATE:
            return base.updated(name)
        raise NoCase("a case in space has no probes and no mutants, and other laws")

    def small_case(self, P: str, Q: str, scale: str) -> SolidCase:
        return SolidCase.read(P, Q, scale)

    @property
    def smaller(self) -> Callable[[SolidCase], Iterator[SolidCase]]:
        return smaller_in_space

    def scales_of_file(self, scale: str) -> list[list[str]]:
        factors = scale.split(",")
        return [factors if len(factors) == DIMENSION else factors * DIMENSION]

    def has_case_file(self, literal: str) -> bool:
        """Only convex operands have a case file."""
        value = json.loads(literal)
        return all(is_convex(Polyhedron.from_document(value[name])) for name in "PQ")


SPACE = Space()
