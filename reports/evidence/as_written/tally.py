"""Counts of comparisons, by writer, and of faults, with examples for each kind."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

import gmpy2
import minkref
from minkref.reports.evidence.as_written.answers import BrokenDown, Refusal
from minkref.reports.evidence.as_written.units import (
    Real,
    exact,
    is_double_of,
    is_rounded,
    units_off,
)

EXAMPLES = 3


@dataclass
class Tally:
    kinds: Counter[str] = field(default_factory=Counter)
    numbers: Counter[str] = field(default_factory=Counter)  # compared, by writer
    wrong: Counter[tuple[str, str]] = field(default_factory=Counter)  # by writer and fault
    examples: dict[tuple[str, str], list[str]] = field(default_factory=dict)
    refused: Counter[str] = field(default_factory=Counter)  # by writer and code
    case: str = ""  # the current case, as command words

    def begin(self, kind: str, case: str) -> None:
        """Look at another case of a kind."""
        self.kinds[kind] += 1
        self.case = case

    def fault(self, writer: str, what: str, told: str = "") -> None:
        self.wrong[writer, what] += 1
        self._show((writer, what), [f"{self.case}: {told}" if told else self.case])

    def _show(self, key: tuple[str, str], more: list[str]) -> None:
        """Keep the shortest examples."""
        shown = self.examples.get(key, [])
        self.examples[key] = sorted([*shown, *more], key=len)[:EXAMPLES]

    @contextmanager
    def answer(self, writer: str) -> Iterator[None]:
        """Take a refusal as an answer, and count it; a breakdown or a file that cannot be read is a
        fault."""
        try:
            yield
        except (Refusal, minkref.Refusal) as refusal:
            self.refused[f"{writer}: {refusal.code}"] += 1
        except (BrokenDown, RuntimeError, ArithmeticError, AssertionError, TypeError) as broken:
            self.fault(writer, "the command breaks down", f"{type(broken).__name__} {broken}"[:300])
        except (ValueError, KeyError, IndexError) as error:
            self.fault(
                writer, "a text that is not of its format", f"{type(error).__name__} {error}"
            )

    def number(self, writer: str, text: str, true: Real, name: str) -> None:
        """Checks that a written number lies within one unit in the true number's last place, both
        as a decimal and as the double that a reader makes."""
        self.numbers[writer] += 1
        try:
            written = exact(text)
        except ValueError:
            self.fault(writer, "no number", f"{name} is {text}")
            return
        if not is_double_of(written, true):
            fault = "more than one unit off" if true else "0 is written as another number"
            self.fault(
                writer,
                fault,
                f"{name} is {text}, true {told(true)}, {units_off(written, true):.3g} units",
            )

    def printed(self, writer: str, text: str, true: Real, name: str) -> None:
        """Checks that a printed number equals the true number, rounded to the printed digits."""
        self.numbers[writer] += 1
        try:
            right = is_rounded(text, true)
        except ValueError:
            self.fault(writer, "no number", f"{name} is {text}")
            return
        if not right:
            self.fault(
                writer, "digits that are not certain", f"{name} is {text}, true {told(true)}"
            )

    def enclosed(self, writer: str, low: Real, high: Real, true: Real, name: str) -> None:
        self.numbers[writer] += 1
        if not low <= true <= high:
            self.fault(
                writer,
                "an enclosure without the value",
                f"{name} {told(low)} to {told(high)}, true {told(true)}",
            )

    def add(self, other: Tally) -> None:
        self.kinds += other.kinds
        self.numbers += other.numbers
        self.wrong += other.wrong
        self.refused += other.refused
        for key, shown in other.examples.items():
            self._show(key, shown)


def told(value: Real) -> str:
    """A number with 25 digits, for people."""
    return f"{gmpy2.mpfr(value):.25g}"
