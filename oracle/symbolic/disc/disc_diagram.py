"""Corners of a polygon's outer Voronoi diagram, and places between two features: their squared
distances as algebraic numbers.

A feature is a vertex, or an edge with the polygon to its left, which stands for its line. These are
candidates: other features do not count, nor the place's position along a line. With two candidates,
each has its place.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from math import isqrt
from typing import Any

import sympy as sp

from ..moving import Point
from ..rational import Rational
from ..solutions import all_solutions, compiled
from ..standing import minus
from . import disc
from .disc import AlgebraicScale, Offset, cross
from .radicals import Radical, number, primes_of, square_root

Feature = Point | Offset
Bounds = tuple[Rational, Rational]
ONE = Rational(1)
BITS = 256  # for bounds
LETTERS = ["a0", "a1", "b", "c", "d0", "d1", "e", "f"]


@dataclass(frozen=True, slots=True)
class SquaredRadius:
    """A squared radius. `polynomial`: minimal, coprime integers, the highest power first; `bounds`
    contain no other root. `place`: bounds for both coordinates, None for a single candidate."""

    polynomial: tuple[int, ...]
    bounds: Bounds
    place: tuple[Bounds, Bounds] | None = None


def between(first: Feature, second: Feature) -> list[SquaredRadius]:
    """Find the place halfway between two vertices, or between a vertex and a line. Exact."""
    if isinstance(second, Offset):
        first, second = second, first
    if isinstance(second, Offset):
        raise ValueError("two lines are nearest to each other at no place")
    if isinstance(first, Offset):
        w = minus(second, first.p)
        return squared(disc.solve("circle on line", ONE, w=w, e=first.edge))
    return squared(disc.solve("circles", ONE, w=minus(second, first)))


def in_front(end: Point, edge: Offset, other: Feature) -> list[SquaredRadius]:
    """Find the place right in front of an edge's end, and equally far from a third feature.
    Exact."""
    if isinstance(other, Offset):
        w = minus(end, other.p)
        return squared(disc.solve("end on line", ONE, w=w, d=edge.edge, e=other.edge))
    return squared(disc.solve("end on circle", ONE, w=minus(end, other), e=edge.edge))


def equidistant(features: Sequence[Feature]) -> list[SquaredRadius]:
    """Find the places equally far from three features, none of them a vertex on a line. Exact."""
    points = [feature for feature in features if not isinstance(feature, Offset)]
    lines = [feature for feature in features if isinstance(feature, Offset)]
    if not points:
        return squared(disc.three_lines(lines[0], lines[1], lines[2], ONE))
    if not lines:
        v, w = minus(points[1], points[0]), minus(points[2], points[0])
        if cross(v, w) == 0:
            return []
        return squared(disc.solve("three circles", ONE, v=v, w=w))
    linear = [through(line, points[0]) for line in lines]
    linear += [half_way(minus(point, points[0])) for point in points[1:]]
    found = from_quadratic([*linear[0], *linear[1]])
    return [moved(each, points[0]) for each in found]


def squared(scale: AlgebraicScale) -> list[SquaredRadius]:
    """Square a distance given as a sum of square roots."""
    if scale.value is None:
        return []
    return [of_radical(scale.value * scale.value)]


def of_radical(value: Radical) -> SquaredRadius:
    return SquaredRadius(tuple(value.minimal_polynomial()), value.isolated())


def through(line: Offset, origin: Point) -> list[Radical]:
    """Return a, b and c for a line."""
    x, y = line.edge
    w = minus(line.p, origin)
    length = square_root(x * x + y * y)
    return [number(y), number(-x), number(y * w[0] - x * w[1]), length]


def half_way(v: Point) -> list[Radical]:
    """Return a, b and c for another point."""
    square = v[0] * v[0] + v[1] * v[1]
    return [number(v[0]), number(v[1]), number(square / 2), number(0)]


@cache
def functions() -> tuple[Any, Any, Any]:
    crossing, parallel = (all_solutions()[f"diagram {name}"] for name in ("crossing", "parallel"))
    return (
        compiled([crossing["turn"], *crossing["coefficients"]], LETTERS),
        compiled(crossing["place"], [*LETTERS, "r"]),
        compiled((parallel["numerator"], parallel["denominator"]), LETTERS),
    )


def from_quadratic(data: list[Radical]) -> list[SquaredRadius]:
    coefficients, place, level = functions()
    turn, *quadratic = (number(value) for value in coefficients(*data))
    if turn.sign() == 0:
        top, below = (number(value) for value in level(*data))
        if below.sign() == 0 or (top / below).sign() <= 0:
            return []
        return [of_radical((top / below) ** 2)]
    found = []
    for way in (1, -1):
        r = root(quadratic, way)
        if r is None:
            continue
        low, high = r
        square = low * low, high * high
        ends = [[bounds(c) for c in place(*data, number(end))] for end in r]
        spans = [hull(ends[0][k], ends[1][k]) for k in (0, 1)]
        x, y = (quotient(span, bounds(turn)) for span in spans)
        found.append(SquaredRadius(minimal(quadratic, square), square, (x, y)))
    return found


def root(quadratic: Sequence[Radical], way: int) -> Bounds | None:
    """Bound one of the two roots, if positive; a linear equation has its root for way 1."""
    a, b, c = quadratic
    if a.sign() == 0:
        if way < 0 or b.sign() == 0 or (c / b).sign() >= 0:
            return None
        return bounds(-c / b)
    discriminant = b * b - 4 * a * c
    sign = discriminant.sign()
    if sign < 0 or (sign == 0 and way < 0):
        return None
    # The root is (-b + w) / 2 a with w = way sqrt(discriminant): signs are exact.
    w_sign, b_sign = way * sign, b.sign()
    larger = (discriminant - b * b).sign()  # of |w| and |b|
    top_sign = w_sign if larger > 0 or b_sign == 0 else -b_sign if larger < 0 else w_sign - b_sign
    if top_sign * a.sign() <= 0:
        return None
    low, high = bounds(discriminant)
    w = sorted((way * root_below(max(low, Rational(0))), way * root_above(high)))
    b_low, b_high = bounds(b)
    return quotient((w[0] - b_high, w[1] - b_low), bounds(2 * a))


def bounds(value: Radical) -> Bounds:
    """Bound a number to a fixed relative precision, unless it is zero."""
    bits = BITS
    while True:
        low, high = value.bounds(bits)
        is_sharp = low * high > 0 and (high - low) * (1 << BITS) < abs(low)
        if is_sharp or not value.terms:
            return low, high
        bits *= 2


def root_below(value: Rational) -> Rational:
    return Rational(isqrt(int((value.numerator << 4 * BITS) // value.denominator)), 1 << 2 * BITS)


def root_above(value: Rational) -> Rational:
    return root_below(value) + Rational(1, 1 << 2 * BITS)


def hull(first: Bounds, second: Bounds) -> Bounds:
    return min(first[0], second[0]), max(first[1], second[1])


def quotient(top: Bounds, below: Bounds) -> Bounds:
    """Divide intervals; the second must not contain zero."""
    ends = [a / b for a in top for b in below]
    return min(ends), max(ends)


def moved(found: SquaredRadius, origin: Point) -> SquaredRadius:
    if found.place is None:
        return found
    x, y = ((low + c, high + c) for (low, high), c in zip(found.place, origin, strict=True))
    return SquaredRadius(found.polynomial, found.bounds, (x, y))


def minimal(quadratic: Sequence[Radical], square: Bounds) -> tuple[int, ...]:
    """Find the minimal polynomial for the square of a root of a r^2 + b r + c, given bounds
    `square`. It divides the product of (a R + c)^2 - b^2 R over the conjugates."""
    a, b, c = quadratic
    own = [a * a, 2 * a * c - b * b, c * c]
    product = own
    while irrational := {m for x in product for m, _ in x.terms if m > 1}:
        prime = primes_of(max(irrational))[0]
        product = times(product, [x.flipped(prime) for x in product])
    unknown = sp.Symbol("R")
    rational = [dict(x.terms).get(1, Rational(0)) for x in product]
    whole = sp.Poly([sp.Rational(int(x.numerator), int(x.denominator)) for x in rational], unknown)
    low, high = (sp.Rational(int(x.numerator), int(x.denominator)) for x in square)
    held = [factor for factor, _ in whole.factor_list()[1] if factor.count_roots(low, high)]
    if len(held) != 1:
        raise ArithmeticError(f"{len(held)} factors have a root in bounds of {BITS} bits")
    found = [int(x) for x in held[0].primitive()[1].all_coeffs()]
    return tuple(x if found[0] > 0 else -x for x in found)


def times(first: Sequence[Radical], second: Sequence[Radical]) -> list[Radical]:
    found = [number(0)] * (len(first) + len(second) - 1)
    for i, x in enumerate(first):
        for k, y in enumerate(second):
            found[i + k] = found[i + k] + x * y
    return found
