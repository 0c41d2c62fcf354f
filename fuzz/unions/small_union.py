"""Steps that make a case of a union smaller."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from itertools import chain, combinations, islice
from math import gcd, lcm

from minkref.fuzz.plane.smaller_operands import (
    Operand,
    fewer_holes,
    fewer_polygons,
    gaps,
    is_valid_operand,
    moved_operand,
    narrowed,
    plain_operand,
    ranked,
    read_operand_text,
    rounded_operand,
    scaled_operand,
    vertices_moved,
    vertices_of,
    with_denominators,
    without_runs,
    without_vertices,
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
        rings = [ring for each in self.sets for polygon in each for ring in polygon]
        length = len(text) + 2 * text.count("-") + 20 * text.count("/")
        return (sum(map(len, rings)), len(rings), len(self.sets), length, text)

    @cached_property
    def literal(self) -> str:
        value = {"sets": [plain_operand(each) for each in self.sets]}
        return json.dumps(value, separators=(",", ":"))

    def valid(self) -> bool:
        return len(self.sets) >= FEWEST_SETS and all(map(is_valid_operand, self.sets))

    def with_set(self, k: int, operand: Operand) -> SmallUnion:
        return SmallUnion((*self.sets[:k], operand, *self.sets[k + 1 :]))

    @cached_property
    def together(self) -> Operand:
        """Lists all polygons, set after set."""
        return tuple(chain.from_iterable(self.sets))

    def changed(self, change: Callable[[Operand], Operand]) -> SmallUnion:
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
    for step in (fewer_polygons, fewer_holes):
        yield from _each(case, step)
    for part in (2, 3, 4):
        yield from _each(case, partial(without_runs, part=part))
    yield from _each(case, partial(without_vertices, count=1))
    yield from _simpler_numbers(case)
    yield from _each(case, partial(without_vertices, count=2))
    yield from _each(case, vertices_moved)


def _each(case: SmallUnion, step: Callable[[Operand], Iterator[Operand]]) -> Iterator[SmallUnion]:
    """Applies a step to each set in turn."""
    for k, operand in enumerate(case.sets):
        yield from (case.with_set(k, fewer) for fewer in step(operand))


def _simpler_numbers(case: SmallUnion) -> Iterator[SmallUnion]:
    points = vertices_of(case.together)
    if not points:
        return
    x, y = min(p[0] for p in points), min(p[1] for p in points)
    yield case.changed(partial(moved_operand, by=(-x, -y)))
    denominator = lcm(*(number.denominator for point in points for number in point))
    divisor = gcd(*(int(number * denominator) for point in points for number in point))
    if divisor:
        yield case.changed(partial(scaled_operand, factor=Fraction(denominator, divisor)))
    for unit in map(Fraction, (64, 16, 8, 4, 2, 1)):
        yield case.changed(partial(rounded_operand, step=unit))
        less = case.changed(partial(scaled_operand, factor=1 / unit))
        yield less.changed(partial(rounded_operand, step=Fraction(1)))
    for most in (1, 2, 4, 8, 16, 64):
        yield case.changed(partial(with_denominators, most=most))
    yield case.changed(ranked)
    for axis in (0, 1):
        for after, by in gaps(case.together, axis):
            yield case.changed(partial(narrowed, axis=axis, after=after, by=by))
