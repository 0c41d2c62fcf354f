"""Steps that make a case of a union smaller."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from itertools import chain, combinations, islice

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
    Change,
    bold_steps,
    counts_of,
    fine_steps,
    length_of,
    narrowings,
    to_the_axes,
    whole_factor,
)

FEWEST_SETS = 2
MOST_PAIRED = 12  # sets of which all pairs are tried


@dataclass(frozen=True)
class SmallUnion:
    sets: tuple[Operand, ...]

    @staticmethod
    def read(literal: str) -> SmallUnion:
        sets = json.loads(literal)["sets"]
        return SmallUnion(tuple(read_operand_text(json.dumps(each)) for each in sets))

    @cached_property
    def size(self) -> tuple[int, int, int, int, str]:
        """Counts vertices, rings, sets, and the numbers' length."""
        text = self.literal
        return (*counts_of(self.sets), len(self.sets), length_of(text), text)

    @cached_property
    def literal(self) -> str:
        value = {"sets": [plain_operand(each) for each in self.sets]}
        return json.dumps(value, separators=(",", ":"))

    def valid(self) -> bool:
        return len(self.sets) >= FEWEST_SETS and all(map(is_valid_operand, self.sets))

    @cached_property
    def together(self) -> Operand:
        """Lists all polygons, set after set."""
        return tuple(chain.from_iterable(self.sets))

    def changed(self, change: Change) -> SmallUnion:
        """Changes all sets together; the change keeps their polygons."""
        polygons = iter(change(self.together))
        return SmallUnion(tuple(tuple(islice(polygons, len(each))) for each in self.sets))


def smaller_unions(case: SmallUnion) -> Iterator[SmallUnion]:
    """Valid candidates, the boldest first."""
    for candidate in _candidates(case):
        if candidate.size < case.size and candidate.valid():
            yield candidate


def _candidates(case: SmallUnion) -> Iterator[SmallUnion]:
    sets = case.sets
    if FEWEST_SETS < len(sets) <= MOST_PAIRED:
        yield from (SmallUnion(pair) for pair in combinations(sets, FEWEST_SETS))
    for part in (2, 3, 4):
        count = len(sets) // part
        if count > 1:
            yield from (
                SmallUnion(sets[:k] + sets[k + count :]) for k in range(0, len(sets), count)
            )
    yield from (SmallUnion(sets[:k] + sets[k + 1 :]) for k in range(len(sets)))
    yield from map(SmallUnion, bold_steps(sets))
    yield from _simpler_numbers(case)
    yield from map(SmallUnion, fine_steps(sets))


def _simpler_numbers(case: SmallUnion) -> Iterator[SmallUnion]:
    move, factor = to_the_axes(case.together), whole_factor(case.together)
    if move is None:
        return
    yield case.changed(move)
    if factor is not None:
        yield case.changed(partial(scaled_operand, factor=factor))
    for unit in map(Fraction, (64, 16, 8, 4, 2, 1)):
        yield case.changed(partial(rounded_operand, step=unit))
        less = case.changed(partial(scaled_operand, factor=1 / unit))
        yield less.changed(partial(rounded_operand, step=Fraction(1)))
    for most in LIMITS:
        yield case.changed(partial(with_denominators, most=most))
    yield case.changed(ranked)
    yield from map(case.changed, narrowings(case.together))
