"""The outline of a setting: what the catalogue, files, lint and the corpus ask of each one."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from minkref.degeneracies.case_texts import CaseTexts
from minkref.degeneracies.files import Made, made_case

CORPUS = Path(__file__).parent / "corpus"


def families_of(*modules: ModuleType) -> dict[str, Any]:
    """The families of modules, by name."""
    return {family.name: family for module in modules for family in module.FAMILIES}


@dataclass(frozen=True, kw_only=True)
class Group(ABC):
    """Families that `minkref generate` makes by one word. `sizeless`: their kind in messages, if
    they have no sizes."""

    word: str
    dimension: int
    families: dict[str, Any]
    sizeless: str = ""

    @property
    def certified(self) -> bool:
        """Whether members have certificates."""
        return False

    @abstractmethod
    def made(self, family: Any, seed: int, index: int, size: int | None = None) -> Made:
        """Makes a member's files."""


@dataclass(frozen=True, kw_only=True)
class Outline(Group):
    """A setting with cases. `holds`: whether a case file is one of its cases. `faults`: the faults
    of such a file, which fits the schema of `case`, given the contents of earlier cases. `count`:
    members of each family in `corpus`."""

    case: type[CaseTexts[Any]]
    holds: Callable[[dict[str, Any]], bool]
    faults: Callable[[Path, dict[str, Any], dict[str, Path]], Iterator[str]]
    flags: frozenset[str] = frozenset()
    count: int
    corpus: Path = CORPUS

    @property
    def certified(self) -> bool:
        return self.case.certified

    def made(self, family: Any, seed: int, index: int, size: int | None = None) -> Made:
        return made_case(self.case.of(family, seed, index, size), index)
