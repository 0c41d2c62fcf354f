"""For which scales a part passes along a path, as a question of `verify`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.verbs import is_path
from minkref.fuzz.motion.asked_path import FAMILIES, AskedPath, drawn_path, named_path
from minkref.fuzz.motion.asking import PathAsking
from minkref.fuzz.motion.small_path import SmallPath, smaller_paths
from minkref.fuzz.setting import ShrinkableQuestion


class Paths(ShrinkableQuestion):
    """Parts, obstacles and paths in the plane."""

    cases = AskedPath
    asking = PathAsking

    def drawn(self, name: CaseName, family: str, seed: int, index: int) -> AskedPath | None:
        return drawn_path(name, family, seed, index) if family in FAMILIES else None

    def named(self, name: CaseName, value: dict[str, Any], where: str) -> AskedPath | None:
        return named_path(name, value, where) if "path" in value else None

    def is_asked(self, literal: str) -> bool:
        return is_path(literal)

    def small_case(self, literal: str) -> SmallPath:
        return SmallPath.read(literal)

    def smaller(self, case: SmallPath) -> Iterator[SmallPath]:
        return smaller_paths(case)


PATHS = Paths()
