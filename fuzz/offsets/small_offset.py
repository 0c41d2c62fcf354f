"""Steps that make a case of a set and a radius smaller."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref.fuzz.cases.verbs import OFFSET
from minkref.fuzz.plane.smaller_operands import (
    Operand,
    is_valid_operand,
    plain_operand,
    ranked,
    read_operand_text,
    rounded_operand,
    scaled_operand,
    with_denominators,
)
from minkref.fuzz.plane.smaller_sets import (
    LIMITS,
    bold_steps,
    counts_of,
    fine_steps,
    length_of,
    narrowings,
    to_the_axes,
    whole_factor,
)


@dataclass(frozen=True)
class SmallOffset:
    """`verb`: the question about the set and the radius."""

    set: Operand
    radius: Fraction
    verb: str = OFFSET
    more: tuple[tuple[str, Any], ...] = ()  # joins, as the case's text has them

    @staticmethod
    def read(literal: str, verb: str = OFFSET) -> SmallOffset:
        value = json.loads(literal)
        given = read_operand_text(json.dumps(value[verb]))
        more = tuple((key, value[key]) for key in ("join", "limit") if key in value)
        return SmallOffset(given, Fraction(str(value["radius"])), verb, more)

    @cached_property
    def size(self) -> tuple[int, int, int, str]:
        """Counts vertices, rings, and the numbers' length."""
        return (*counts_of([self.set]), length_of(self.literal), self.literal)

    @cached_property
    def literal(self) -> str:
        value = {self.verb: plain_operand(self.set), "radius": str(self.radius), **dict(self.more)}
        return json.dumps(value, separators=(",", ":"))

    def valid(self) -> bool:
        return self.radius != 0 and is_valid_operand(self.set)

    def scaled(self, factor: Fraction) -> SmallOffset:
        return replace(self, set=scaled_operand(self.set, factor), radius=self.radius * factor)

    def rounded(self, step: Fraction) -> SmallOffset:
        return replace(self, set=rounded_operand(self.set, step))


def smaller_offsets(case: SmallOffset) -> Iterator[SmallOffset]:
    """Valid candidates, the boldest first."""
    for candidate in _candidates(case):
        if candidate.size < case.size and candidate.valid():
            yield candidate


def _candidates(case: SmallOffset) -> Iterator[SmallOffset]:
    for (fewer,) in bold_steps((case.set,)):
        yield replace(case, set=fewer)
    yield from _simpler_numbers(case)
    for (fewer,) in fine_steps((case.set,)):
        yield replace(case, set=fewer)


def _simpler_numbers(case: SmallOffset) -> Iterator[SmallOffset]:
    """Scaling takes the radius along."""
    move, factor = to_the_axes(case.set), whole_factor(case.set)
    if move is None:
        return
    yield replace(case, set=move(case.set))
    if factor is not None:
        yield case.scaled(factor)
    yield case.scaled(1 / abs(case.radius))
    for most in LIMITS:
        yield replace(case, radius=case.radius.limit_denominator(most))
    for unit in map(Fraction, (256, 64, 16, 8, 4, 2, 1)):
        yield case.rounded(unit)
        less = case.scaled(1 / unit).rounded(Fraction(1))
        yield less
        yield replace(less, radius=Fraction(round(less.radius)))
    for most in LIMITS:
        yield replace(case, set=with_denominators(case.set, most))
    yield replace(case, set=ranked(case.set))
    for narrowing in narrowings(case.set):
        yield replace(case, set=narrowing(case.set))
