"""Predicates of points that move with the scale: their signs (docs/certificates.md)."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

Place = tuple[Fraction, Fraction]
Point = Sequence[int | None]  # a vertex of P and a vertex of Q, None for no vertex
Predicate = tuple[str, Any]  # ("orientation", three points); ("concurrent", three pairs)
Row = tuple[Fraction, Fraction, Fraction]


class Vertices:
    """Both operands' vertices, as a certificate numbers them."""

    def __init__(self, P: Sequence[Place], Q: Sequence[Place]) -> None:
        self.P, self.Q = P, Q

    def at(self, point: Point, scale: Fraction) -> Place:
        """The point s p + q."""
        x, y = Fraction(0), Fraction(0)
        for i, vertices, factor in zip(point, (self.P, self.Q), (scale, Fraction(1)), strict=True):
            if i is not None:
                x, y = x + factor * vertices[i][0], y + factor * vertices[i][1]
        return x, y

    def value(self, predicate: Predicate, scale: Fraction) -> Fraction:
        """At one scale. Exact."""
        return self.coefficients(predicate, scale, scale)[0]

    def coefficients(self, predicate: Predicate, a: Fraction, b: Fraction) -> list[Fraction]:
        """Returns the Bernstein coefficients from a to b, times the binomials. A predicate is
        linear in each point, so each coefficient sums the predicate's values with so many points
        taken at b. Exact."""
        name, entries = predicate
        points = list(entries) if name == "orientation" else [p for line in entries for p in line]
        ends = [[(*self.at(p, s), Fraction(1)) for s in (a, b)] for p in points]
        sums = [Fraction(0)] * (len(points) + 1)
        for choice in itertools.product((0, 1), repeat=len(points)):
            rows = [end[i] for end, i in zip(ends, choice, strict=True)]
            sums[sum(choice)] += determinant(rows if len(rows) == 3 else lines(rows))
        return sums

    def sign_between(self, predicate: Predicate, a: Fraction, b: Fraction) -> int | None:
        """Returns the sign that the coefficients prove from a to b; 0 if the predicate vanishes
        everywhere, None if the coefficients prove no sign."""
        signs = {(c > 0) - (c < 0) for c in self.coefficients(predicate, a, b)}
        if signs == {0}:
            return 0
        return next((sign for sign in (1, -1) if signs <= {0, sign}), None)


def lines(rows: Sequence[Row]) -> list[Row]:
    """The lines through the first and second point, the third and fourth, ..."""
    return [crossed(rows[i], rows[i + 1]) for i in range(0, len(rows), 2)]


def crossed(u: Row, v: Row) -> Row:
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def determinant(rows: Sequence[Row]) -> Fraction:
    x, y, z = crossed(rows[1], rows[2])
    return rows[0][0] * x + rows[0][1] * y + rows[0][2] * z
