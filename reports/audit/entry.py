"""An entry of the audit: a statement of the paper, what holds, and a check that runs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from decimal import Decimal
from enum import StrEnum
from fractions import Fraction
from typing import Any

import sympy


class Status(StrEnum):
    HOLDS = "holds"
    CONDITION = "holds under a condition"
    MISPRINT = "misprint"
    FALSE = "false"
    INCOMPLETE = "incomplete"
    NOT_REPRODUCIBLE = "not reproducible"


class CheckFailed(Exception):
    """A check has found something else than the entry says."""


@dataclass(frozen=True)
class Drawing:
    caption: str
    svg: str


@dataclass
class Shown:
    """What a check has shown: a line for each fact, in the order of the check."""

    facts: list[str] = field(default_factory=list)
    drawings: list[Drawing] = field(default_factory=list)

    def identity(self, what: str, expression: Any) -> None:
        """An expression, or each of a vector, that is zero for all values of its symbols, by
        computer algebra."""
        parts = expression if isinstance(expression, sympy.MatrixBase) else [expression]
        for part in parts:
            left = sympy.simplify(sympy.together(sympy.expand(part)))
            self._must(left == 0, what, f"what is left is {left}")
        self._add(f"{what}: the difference of both sides is zero, by computer algebra.")

    def equal(self, what: str, found: Any, wanted: Any) -> None:
        self._must(found == wanted, what, f"{text(found)}, not {text(wanted)}")
        self._add(f"{what}: {text(found)}.")

    def different(self, what: str, printed: Any, right: Any) -> None:
        """A counterexample: both values, which differ."""
        self._must(printed != right, what, f"both are {text(right)}")
        self._add(f"{what}: as printed {text(printed)}, right is {text(right)}.")

    def true(self, what: str, condition: bool) -> None:
        self._must(bool(condition), what, "it is not so")
        self._add(f"{what}.")

    def tell(self, fact: str) -> None:
        """Something that is no law: a count, a figure."""
        self._add(fact)

    def draw(self, caption: str, svg: str) -> None:
        self.drawings.append(Drawing(caption, svg))

    def _add(self, fact: str) -> None:
        self.facts.append(fact[0].upper() + fact[1:] + "." * (not fact.endswith(".")))

    def _must(self, condition: bool, what: str, otherwise: str) -> None:
        if not condition:
            raise CheckFailed(f"{what}: {otherwise}")


def text(value: Any) -> str:
    """A fraction as a decimal where that is exact and short."""
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, (tuple, list)):
        return "(" + ", ".join(map(text, value)) + ")"
    if value is None:
        return "none"
    if isinstance(value, Fraction) and 10**6 % value.denominator == 0 != 1 - value.denominator:
        return f"{Decimal(value.numerator) / Decimal(value.denominator):f}"
    return str(value)


Check = Callable[[Shown], None]


@dataclass(frozen=True)
class Entry:
    """`place`: where in the paper. `printed`: what it says, in our words and formulas; `right`:
    what holds. Both are Markdown, with formulas between dollars. `code`: files of the project that
    have it. `how`: what the check does, its docstring."""

    name: str
    title: str
    place: str
    status: Status
    printed: str
    right: str
    code: tuple[str, ...]
    slow: bool  # left out of a quick report
    of_models: bool  # what it shows depends on the models at hand (MINKREF_MODELS)
    check: Check

    @property
    def how(self) -> str:
        return " ".join((self.check.__doc__ or "").split())

    def run(self) -> Shown:
        """Raises CheckFailed."""
        shown = Shown()
        self.check(shown)
        return shown


@dataclass
class Chapter:
    """A section of the paper, with its entries in the order of the text."""

    name: str
    title: str
    entries: list[Entry] = field(default_factory=list)

    def entry(
        self,
        name: str,
        title: str,
        *,
        place: str,
        status: Status,
        printed: str,
        right: str,
        code: tuple[str, ...] = (),
        slow: bool = False,
        of_models: bool = False,
    ) -> Callable[[Check], Check]:
        """Adds the entry whose check is the function that follows."""

        def add(check: Check) -> Check:
            told, holds = (" ".join(part.split()) for part in (printed, right))
            self.entries.append(
                Entry(name, title, place, status, told, holds, code, slow, of_models, check)
            )
            return check

        return add
