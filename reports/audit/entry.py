"""An audit entry: a statement of the paper, the correct statement, and a check that runs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from decimal import Decimal
from enum import StrEnum
from fractions import Fraction
from typing import Any

import sympy


class Status(StrEnum):
    """FALSE: under no known reading do the words or the formula hold. LITERAL: false with words and
    symbols as defined, but true under a reading that the entry names."""

    HOLDS = "holds"
    CONDITION = "holds under a condition"
    MISPRINT = "misprint"
    FALSE = "false"
    LITERAL = "false as read literally"
    INCOMPLETE = "incomplete"
    NOT_REPRODUCIBLE = "not reproducible"


class CheckFailed(Exception):
    """Raised if a check contradicts its entry."""


@dataclass(frozen=True)
class Drawing:
    caption: str
    svg: str


@dataclass
class Shown:
    """Facts that a check has shown: a line for each fact, in the check's order."""

    facts: list[str] = field(default_factory=list)
    drawings: list[Drawing] = field(default_factory=list)

    def identity(self, what: str, expression: Any) -> None:
        """Shows by computer algebra that an expression, or each entry of a vector, is zero for all
        values of its symbols."""
        parts = expression if isinstance(expression, sympy.MatrixBase) else [expression]
        for part in parts:
            left = sympy.simplify(sympy.together(sympy.expand(part)))
            self._must(left == 0, what, f"what is left is {left}")
        self._add(f"{what}: the difference of both sides is zero, by computer algebra.")

    def equal(self, what: str, found: Any, wanted: Any) -> None:
        self._must(found == wanted, what, f"{text(found)}, not {text(wanted)}")
        self._add(f"{what}: {text(found)}.")

    def different(self, what: str, printed: Any, right: Any) -> None:
        """Shows a counterexample: two values that differ."""
        self._must(printed != right, what, f"both are {text(right)}")
        self._add(f"{what}: as printed {text(printed)}, right is {text(right)}.")

    def true(self, what: str, condition: bool) -> None:
        self._must(bool(condition), what, "it is not so")
        self._add(f"{what}.")

    def tell(self, fact: str) -> None:
        """Adds a fact that is not a law: a count or a figure."""
        self._add(fact)

    def draw(self, caption: str, svg: str) -> None:
        self.drawings.append(Drawing(caption, svg))

    def _add(self, fact: str) -> None:
        self.facts.append(fact[0].upper() + fact[1:] + "." * (not fact.endswith(".")))

    def _must(self, condition: bool, what: str, otherwise: str) -> None:
        if not condition:
            raise CheckFailed(f"{what}: {otherwise}")


def text(value: Any) -> str:
    """The value as text; a fraction becomes a decimal if that decimal is exact and short."""
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
    """`place`: the place in the paper. `printed`: the paper's statement, in our words and formulas;
    `right`: the correct statement. `reading`: a reading under which a literally false statement
    holds. All are Markdown, with formulas between dollars. `formula`: the formula or sentence at
    issue, which several entries may share. `code`: project files with that formula. `how`: the
    check's docstring, which describes the check."""

    name: str
    title: str
    place: str
    status: Status
    printed: str
    right: str
    reading: str
    formula: str
    code: tuple[str, ...]
    slow: bool  # left out of a quick report
    of_models: bool  # the facts depend on the models at hand (MINKREF_MODELS)
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
        reading: str = "",
        formula: str = "",
        code: tuple[str, ...] = (),
        slow: bool = False,
        of_models: bool = False,
    ) -> Callable[[Check], Check]:
        """Adds an entry whose check is the decorated function. `formula` defaults to the title."""

        def add(check: Check) -> Check:
            told, holds, read = (" ".join(part.split()) for part in (printed, right, reading))
            about = formula or title
            self.entries.append(
                Entry(name, title, place, status, told, holds, read, about, code, slow, of_models,
                      check)
            )  # fmt: skip
            return check

        return add


#: Statuses from gravest to mildest; the gravest status among a formula's entries counts for the
#: formula.
GRAVEST = (Status.FALSE, Status.LITERAL, Status.MISPRINT, Status.INCOMPLETE,
           Status.NOT_REPRODUCIBLE, Status.CONDITION, Status.HOLDS)  # fmt: skip


def formulas(entries: Iterable[Entry]) -> dict[str, list[Entry]]:
    """The entries about each formula or sentence, in their order."""
    found: dict[str, list[Entry]] = {}
    for entry in entries:
        found.setdefault(entry.formula, []).append(entry)
    return found


def status_of(entries: Iterable[Entry]) -> Status:
    """The shared formula's status: the gravest among all entries."""
    return min((entry.status for entry in entries), key=GRAVEST.index)


def counted(entries: Iterable[Entry]) -> dict[Status, int]:
    """How many formulas or sentences of each status, not entries."""
    counts = Counter(status_of(group) for group in formulas(entries).values())
    return {status: counts[status] for status in Status if counts[status]}
