"""Steps that make a list of sets smaller, one set at a time, for all questions about sets."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from itertools import chain
from math import gcd, lcm

from minkref.fuzz.plane.smaller_operands import (
    Operand,
    fewer_holes,
    fewer_polygons,
    gaps,
    moved_operand,
    narrowed,
    vertices_moved,
    vertices_of,
    without_runs,
    without_vertices,
)

Sets = tuple[Operand, ...]
Change = Callable[[Operand], Operand]
LIMITS = (1, 2, 4, 8, 16, 64)  # of denominators


def bold_steps(sets: Sets) -> Iterator[Sets]:
    """Drops polygons and holes, then runs of vertices, then one vertex."""
    yield from _each(sets, lambda one: chain(fewer_polygons(one), fewer_holes(one)))
    for part in (2, 3, 4):
        yield from _each(sets, partial(without_runs, part=part))
    yield from _each(sets, partial(without_vertices, count=1))


def fine_steps(sets: Sets) -> Iterator[Sets]:
    """Drops two vertices, then moves one."""
    yield from _each(sets, partial(without_vertices, count=2))
    yield from _each(sets, vertices_moved)


def _each(sets: Sets, step: Callable[[Operand], Iterable[Operand]]) -> Iterator[Sets]:
    for k, operand in enumerate(sets):
        yield from ((*sets[:k], fewer, *sets[k + 1 :]) for fewer in step(operand))


def counts_of(sets: Sequence[Operand]) -> tuple[int, int]:
    """Counts vertices and rings."""
    rings = [ring for operand in sets for polygon in operand for ring in polygon]
    return sum(map(len, rings)), len(rings)


def length_of(text: str) -> int:
    """A text's length, in which signs and fractions count more."""
    return len(text) + 2 * text.count("-") + 20 * text.count("/")


def to_the_axes(operand: Operand) -> Change | None:
    """Moves so that the least coordinates become 0; None for nothing."""
    points = vertices_of(operand)
    if not points:
        return None
    x, y = min(p[0] for p in points), min(p[1] for p in points)
    return partial(moved_operand, by=(-x, -y))


def whole_factor(operand: Operand) -> Fraction | None:
    """The factor that makes coordinates whole numbers without a common divisor."""
    numbers = [number for point in vertices_of(operand) for number in point]
    denominator = lcm(*(number.denominator for number in numbers))
    divisor = gcd(*(int(number * denominator) for number in numbers))
    return Fraction(denominator, divisor) if divisor else None


def narrowings(operand: Operand) -> Iterator[Change]:
    """Each takes a wide gap out of the set, along an axis."""
    for axis in (0, 1):
        for after, by in gaps(operand, axis):
            yield partial(narrowed, axis=axis, after=after, by=by)
