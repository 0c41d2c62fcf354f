"""Steps that make lines to grow smaller."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref.errors import Refusal
from minkref.fuzz.cases.verbs import OFFSET
from minkref.fuzz.offsets.lines import Line, lines_value, read_lines

UNITS = tuple(map(Fraction, (256, 64, 16, 8, 4, 2, 1)))


@dataclass(frozen=True)
class SmallLines:
    """`more`: joins and caps, as the case's text has them."""

    lines: tuple[Line, ...]
    radius: Fraction
    more: tuple[tuple[str, Any], ...] = ()

    @staticmethod
    def read(literal: str) -> SmallLines:
        value = json.loads(literal)
        lines, _ = read_lines(value.pop(OFFSET)["lines"], "shrunk")
        return SmallLines(lines, Fraction(str(value.pop("radius"))), tuple(value.items()))

    @cached_property
    def literal(self) -> str:
        value = {OFFSET: lines_value(self.lines), "radius": str(self.radius), **dict(self.more)}
        return json.dumps(value, separators=(",", ":"))

    @cached_property
    def size(self) -> tuple[int, int, int, str]:
        """Counts points, lines, and the length of the text."""
        return (sum(map(len, self.lines)), len(self.lines), len(self.literal), self.literal)

    def valid(self) -> bool:
        try:
            read_lines(lines_value(self.lines)["lines"], "shrunk")
        except Refusal:
            return False
        has_point = any(len(line) == 1 for line in self.lines)
        return self.radius > 0 and not (has_point and "cap" in dict(self.more))

    def mapped(self, factor: Fraction, step: Fraction = Fraction(0)) -> SmallLines:
        """Scaled, and rounded to multiples of a step."""

        def number(x: Fraction) -> Fraction:
            return step * round(factor * x / step) if step else factor * x

        lines = tuple(tuple((number(x), number(y)) for x, y in line) for line in self.lines)
        return replace(self, lines=lines, radius=self.radius * factor)


def smaller_lines(case: SmallLines) -> Iterator[SmallLines]:
    """Valid candidates, the boldest first."""
    for candidate in _candidates(case):
        if candidate.size < case.size and candidate.valid():
            yield candidate


def _candidates(case: SmallLines) -> Iterator[SmallLines]:
    lines = case.lines
    for k in range(len(lines) if len(lines) > 1 else 0):
        yield replace(case, lines=lines[:k] + lines[k + 1 :])
    for k, line in enumerate(lines):
        for i in range(len(line) if len(line) > 1 else 0):
            yield replace(case, lines=(*lines[:k], line[:i] + line[i + 1 :], *lines[k + 1 :]))
    x, y = lines[0][0]
    moved = tuple(tuple((a - x, b - y) for a, b in line) for line in lines)
    yield replace(case, lines=moved)
    yield case.mapped(1 / case.radius)
    yield replace(case, radius=Fraction(round(case.radius)))
    for unit in UNITS:
        less = case.mapped(1 / unit, Fraction(1))
        yield replace(less, radius=Fraction(round(less.radius)))
        yield case.mapped(Fraction(1), unit)
        yield case.mapped(Fraction(1), 1 / unit)
