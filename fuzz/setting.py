"""What a run of `verify` has to know of the plane, of space, and of whatever comes next."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, ClassVar, Protocol

from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.targets.asking import Asking


class SmallCase(Protocol):
    """A case that is being shrunk, and as a text that names it. The least `size` is wanted."""

    @property
    def size(self) -> Any: ...
    @property
    def literal(self) -> str: ...


class Setting(ABC):
    """How cases are read, sent, received, judged and shrunk where they live. A folder of `fuzz/`
    has its filling; `settings.py` lists them."""

    name: ClassVar[str]  # also the capability by which a target declares that it takes its cases
    where: ClassVar[str]
    dimension: ClassVar[int]
    target: ClassVar[str]  # a route of the reference that takes its cases
    verbs: ClassVar[tuple[str, ...]]  # beside `at`; where a target declares them
    asking: ClassVar[type[Asking]]  # how targets are asked, and their answers judged
    never: ClassVar[frozenset[str]] = frozenset()  # capabilities that none of its cases asks for

    # Cases.

    @abstractmethod
    def holds(self, operands: list[Any]) -> bool:
        """Whether two JSON values are meant as its sets."""

    @abstractmethod
    def is_document(self, value: Any) -> bool:
        """Whether a JSON value is meant as one of its case files."""

    @abstractmethod
    def case_of(self, name: CaseName, operands: list[Any], scale: Any, where: str) -> AnyCase:
        """Of two sets as JSON values. Refuses what is no set."""

    @abstractmethod
    def scales_in(self, value: dict[str, Any], path: Path) -> list[str]:
        """Those at which a case file asks for sums."""

    @abstractmethod
    def case_in(self, name: CaseName, path: Path, scale: str) -> AnyCase:
        """A case file at a scale. Refuses what is none."""

    @abstractmethod
    def refuse_bad_operands(self, path: Path) -> None:
        """Those of a case file."""

    @abstractmethod
    def drawn(self, name: CaseName, family: str, seed: int, index: int) -> AnyCase | None:
        """What a generator makes; None where it has none of that name."""

    @abstractmethod
    def derived(
        self, base: AnyCase, name: CaseName, operation: str, number: int | None
    ) -> AnyCase | None:
        """What an operation makes of a case; None where it knows none of that name. NoCase where
        there is nothing to be made."""

    # Shrinking.

    @abstractmethod
    def small_case(self, P: str, Q: str, scale: str) -> SmallCase:
        """Of operands as JSON texts."""

    @property
    @abstractmethod
    def smaller(self) -> Callable[[Any], Iterator[Any]]:
        """Valid candidates, the boldest first."""

    @abstractmethod
    def scales_of_file(self, scale: str) -> list[Any]:
        """As a case file has them."""

    def has_case_file(self, literal: str) -> bool:
        """Whether a case can be written as a case file."""
        return True


class Question(ABC):
    """About sets of a setting, other than for their sum: the cases that ask it, and how they are
    made smaller."""

    cases: ClassVar[type]
    asking: ClassVar[type[Asking]]

    @abstractmethod
    def drawn(self, name: CaseName, family: str, seed: int, index: int) -> AnyCase | None:
        """What a generator makes; None where it has none of that name."""

    def named(self, name: CaseName, value: dict[str, Any], where: str) -> AnyCase | None:
        """Of the JSON value of a case; None where it asks something else. Refuses what is wrong
        with it."""
        return None

    def is_asked(self, literal: str) -> bool:
        """Whether the text that names a case asks this, and can be made smaller."""
        return False

    def small_case(self, literal: str) -> SmallCase:
        raise NotImplementedError

    def smaller(self, case: Any) -> Iterator[Any]:
        """Valid candidates, the boldest first."""
        raise NotImplementedError
