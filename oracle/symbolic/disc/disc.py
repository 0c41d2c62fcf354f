"""Event scales for a disc of radius s r swept along a standing polygon: offset edges and arcs.
Every scale is a sum of square roots of rationals, given as an algebraic number.

Offset edges and arcs share their ends, so two features can come to touch in six ways with four
conditions: `end on line` (an edge's or an arc's end), `end on circle`, `circle on line`, `circles`.
`three lines` and `three circles` pass through one point.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from ..moving import Point
from ..rational import Rational, rationals
from ..solutions import all_solutions, compiled
from ..standing import minus
from .radicals import Radical, number, square_root

Place = tuple[Radical, Radical]


@dataclass(frozen=True, slots=True)
class Offset:
    """The edge from p to q of a polygon to its left, moved outwards by s r."""

    p: Point
    q: Point

    @property
    def edge(self) -> Point:
        return minus(self.q, self.p)


@dataclass(frozen=True, slots=True)
class Arc:
    """An arc about a convex vertex of the polygon, from the normal of the edge `before`, which ends
    there, to the normal of the edge `after`."""

    before: Offset
    after: Offset

    def __post_init__(self) -> None:
        if self.before.q != self.after.p or cross(self.before.edge, self.after.edge) <= 0:
            raise ValueError("an arc belongs to two edges that meet in a strictly convex vertex")

    @property
    def centre(self) -> Point:
        return self.after.p


@dataclass(frozen=True, slots=True)
class AlgebraicScale:
    """A root s > 0: as a sum of radicals, by its minimal polynomial (highest power first), by an
    interval without other roots. `case` once; or always or never, without a number."""

    case: str
    value: Radical | None = None
    polynomial: tuple[int, ...] = ()
    interval: tuple[Rational, Rational] | None = None


def cross(u: Sequence[Any], v: Sequence[Any]) -> Any:
    return u[0] * v[1] - u[1] * v[0]


@cache
def functions(name: str) -> tuple[list[str], Any, Any, Any]:
    """Return data names, squared lengths, the solved scale, and the terms with coefficients."""
    found = all_solutions()[f"disc {name}"]
    data, lengths = found["data"], found["lengths"]
    squared = [f"L{i}" for i in range(len(lengths))]
    terms = [f"c{i}" for i in range(len(found["terms"]))]
    arguments = [x for x in DATA if x in data or x[0] in SQUARED.get(name, "")]
    return (
        arguments,
        compiled(found["squares"], arguments),
        compiled((found["numerator"], found["denominator"]), [*arguments, *lengths]),
        (compiled(found["terms"], arguments), compiled(found["coefficients"], [*terms, *squared])),
    )


DATA = ("r", *(f"{letter}{i}" for letter in "defvw" for i in (0, 1)))
# Vectors known to a condition only by their length.
SQUARED = {"circles": "w"}


def solve(name: str, radius: Rational, **vectors: Point) -> AlgebraicScale:
    """Solve a condition above for the scale, for vectors named as in the derivation. Exact."""
    values = {f"{key}{i}": x for key, vector in vectors.items() for i, x in enumerate(vector)}
    arguments, squares, scale, _ = functions(name)
    data = [radius if x == "r" else values[x] for x in arguments]
    lengths = [square_root(square) for square in squares(*data)]
    top, below = (number(x) for x in scale(*data, *lengths))
    if below.sign() == 0:
        return AlgebraicScale("always" if top.sign() == 0 else "never")
    value = top / below
    if name == "three circles" and value.sign() < 0:
        value = -value  # the area has a sign, the radius has not
    if value.sign() <= 0:
        return AlgebraicScale("never")
    return AlgebraicScale("once", value, tuple(value.minimal_polynomial()), value.isolated())


def eliminated_polynomial(name: str, radius: Rational, **vectors: Point) -> list[Rational]:
    """Evaluate the general polynomial without lengths for these numbers, highest power first; the
    scale is a root. Zero if a conjugate condition holds at all scales."""
    values = {f"{key}{i}": x for key, vector in vectors.items() for i, x in enumerate(vector)}
    arguments, squares, _, (terms, coefficients) = functions(name)
    data = [radius if x == "r" else values[x] for x in arguments]
    return list(coefficients(*terms(*data), *squares(*data)))


def end_on_line(end: Point, of: Offset, line: Offset, r: Rational) -> AlgebraicScale:
    """Solve for the scale at which the end `end` (p or q) of the offset edge `of` comes to
    another's line."""
    return solve("end on line", r, w=minus(end, line.p), d=of.edge, e=line.edge)


def end_on_circle(end: Point, of: Offset, arc: Arc, r: Rational) -> AlgebraicScale:
    """Solve for the scale at which an end of an offset edge, or of an arc, comes to an arc's
    circle."""
    return solve("end on circle", r, w=minus(end, arc.centre), e=of.edge)


def circle_on_line(arc: Arc, line: Offset, r: Rational) -> AlgebraicScale:
    """Solve for the scale at which an arc's circle touches an offset edge's line from outside."""
    return solve("circle on line", r, w=minus(arc.centre, line.p), e=line.edge)


def circles(first: Arc, second: Arc, r: Rational) -> AlgebraicScale:
    """Solve for the scale at which the circles of two arcs touch."""
    return solve("circles", r, w=minus(second.centre, first.centre))


def three_lines(first: Offset, second: Offset, third: Offset, r: Rational) -> AlgebraicScale:
    """Solve for the scale at which the lines of three offset edges pass through one point."""
    v, w = minus(second.p, first.p), minus(third.p, first.p)
    return solve("three lines", r, d=first.edge, e=second.edge, f=third.edge, v=v, w=w)


def three_circles(first: Arc, second: Arc, third: Arc, r: Rational) -> AlgebraicScale:
    """Solve for the scale at which the circles of three arcs pass through one point."""
    v, w = minus(second.centre, first.centre), minus(third.centre, first.centre)
    return solve("three circles", r, v=v, w=w)


def offsets(polygon: Sequence[Any]) -> list[Offset]:
    """List the offset edges of a ring that has its polygon to the left."""
    ring: list[Point] = [(x, y) for x, y in map(rationals, polygon)]
    return [Offset(p, q) for p, q in zip(ring, [*ring[1:], ring[0]], strict=True)]


def arcs(polygon: Sequence[Any]) -> list[Arc]:
    """List a ring's arcs, about its strictly convex vertices."""
    edges = offsets(polygon)
    pairs = zip([edges[-1], *edges[:-1]], edges, strict=True)
    return [Arc(a, b) for a, b in pairs if cross(a.edge, b.edge) > 0]
