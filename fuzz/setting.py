"""The facts that a `verify` run needs about the plane, space, and later settings."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, ClassVar, Protocol

from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.targets.asking import Asking


class SmallCase(Protocol):
    """A case while shrinking, with a text that names it. A smaller `size` is better."""

    @property
    def size(self) -> Any: ...
    @property
    def literal(self) -> str: ...


class Setting(ABC):
    """Reads, sends, receives, judges and shrinks cases in one setting. Each setting has a folder in
    `fuzz/`, listed in `settings.py`."""

    name: ClassVar[str]  # also the capability by which a target declares that it takes the cases
    where: ClassVar[str]
    dimension: ClassVar[int]
    target: ClassVar[str]  # a reference route that takes the cases
    verbs: ClassVar[tuple[str, ...]]  # beside `at`; if a target declares them
    asking: ClassVar[type[Asking]]  # asks targets, and judges their answers
    families: ClassVar[dict[str, str]]  # titles of the generators of pairs, by name
    never: ClassVar[frozenset[str]] = frozenset()  # capabilities never asked for

    # Cases.

    @abstractmethod
    def holds(self, operands: list[Any]) -> bool:
        """Whether two JSON values look like sets in this setting."""

    @abstractmethod
    def is_document(self, value: Any) -> bool:
        """Whether a JSON value looks like a case file in this setting."""

    @abstractmethod
    def case_of(self, name: CaseName, operands: list[Any], scale: Any, where: str) -> AnyCase:
        """Makes a case from two sets as JSON values. Refuses values that are no sets."""

    @abstractmethod
    def scales_in(self, value: dict[str, Any], path: Path) -> list[str]:
        """The scales at which a case file asks for sums."""

    @abstractmethod
    def case_in(self, name: CaseName, path: Path, scale: str) -> AnyCase:
        """A case file at a scale. Refuses what is none."""

    @abstractmethod
    def refuse_bad_operands(self, path: Path) -> None:
        """Refuses bad operands of a case file."""

    @abstractmethod
    def drawn(self, name: CaseName, family: str, seed: int, index: int) -> AnyCase | None:
        """Makes a case by the generator `family`; None for an unknown generator."""

    @abstractmethod
    def derived(
        self, base: AnyCase, name: CaseName, operation: str, number: int | None
    ) -> AnyCase | None:
        """Derives a case by an operation; None for an unknown operation. NoCase if nothing can be
        made."""

    # Shrinking.

    @abstractmethod
    def small_case(self, P: str, Q: str, scale: str) -> SmallCase:
        """The small case of operands as JSON texts."""

    @property
    @abstractmethod
    def smaller(self) -> Callable[[Any], Iterator[Any]]:
        """Valid candidates, the boldest first."""

    @abstractmethod
    def scales_of_file(self, scale: str) -> list[Any]:
        """The scales as a case file has them."""

    def has_case_file(self, literal: str) -> bool:
        """Whether a case can be written as a case file."""
        return True


class Question(ABC):
    """A question about sets in a setting, other than their sum, and the cases that ask it."""

    cases: ClassVar[type]
    asking: ClassVar[type[Asking]]
    families: ClassVar[dict[str, str]] = {}  # titles of the generators that a run may choose

    @abstractmethod
    def drawn(self, name: CaseName, family: str, seed: int, index: int) -> AnyCase | None:
        """Makes a case by the generator `family`; None for an unknown generator."""

    def named(self, name: CaseName, value: dict[str, Any], where: str) -> AnyCase | None:
        """The case of a JSON value; None if it asks something else. Refuses a wrong value."""
        return None


class ShrinkableQuestion(Question):
    """A question whose cases can be made smaller."""

    @abstractmethod
    def is_asked(self, literal: str) -> bool:
        """Whether the text that names a case asks this."""

    @abstractmethod
    def small_case(self, literal: str) -> SmallCase:
        """The small case of a text that names one."""

    @abstractmethod
    def smaller(self, case: Any) -> Iterator[Any]:
        """Valid candidates, the boldest first."""
