"""The degree of incompatibility from Behar & Lien 2012, Section 6, by computer algebra, and the
descent along it: as printed and corrected."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

Corner = Sequence[str]  # three exact numbers, n or n/d
T = sp.Symbol("t", real=True)


def degrees(
    facet: Sequence[Corner], vertex: Corner, others: Sequence[Corner], scaling: Corner
) -> dict[str, list[sp.Rational]]:
    """Compute each edge's part of IC(f, v) squared, from the vertex to each of the others. `facet`:
    a facet's corners on P, counter-clockwise seen from outside, before scaling. The scaled facet's
    plane moves to the vertex. `printed`: the longest distance from the plane along the edge;
    `corrected`: only above the plane. Exact."""
    normal = _normal(facet, scaling)
    start = _vector(vertex)
    square = normal.dot(normal)
    found: dict[str, list[sp.Rational]] = {"printed": [], "corrected": []}
    for other in others:
        point = start + T * (_vector(other) - start)  # t from 0 to 1
        height = sp.expand(normal.dot(point - start))
        ends = [height.subs(T, t) for t in (0, 1)]  # linear in t
        found["printed"].append(max(end**2 for end in ends) / square)
        found["corrected"].append(max(ends) ** 2 / square)
    return found


def descent(
    facet: Sequence[Corner],
    points: Sequence[Corner],
    neighbours: Mapping[int, Sequence[int]],
    vertex: int,
    scaling: Corner,
    form: str,
) -> tuple[list[tuple[int, set[int], sp.Rational]], int | None]:
    """Descend from a vertex along witnesses until no edge rises above the plane. Returns for each
    vertex on the way the other ends of its witnesses, and IC squared; then the end, None if a
    vertex repeats. The text does not choose among several witnesses: the way ends there."""
    way: list[tuple[int, set[int], sp.Rational]] = []
    while vertex not in [at for at, _, _ in way]:
        others = list(neighbours[vertex])
        found = degrees(facet, points[vertex], [points[k] for k in others], scaling)
        if max(found["corrected"]) == 0:
            return way, vertex
        most = max(found[form])
        witnesses = {k for k, own in zip(others, found[form], strict=True) if own == most}
        way.append((vertex, witnesses, most))
        if len(witnesses) > 1:  # the text does not choose
            return way, None
        (vertex,) = witnesses
    return way, None


def _normal(facet: Sequence[Corner], scaling: Corner) -> sp.Matrix:
    scale = sp.diag(*map(sp.Rational, scaling))
    a, b, c = (scale * _vector(corner) for corner in facet[:3])
    return (b - a).cross(c - a)


def _vector(corner: Corner) -> sp.Matrix:
    return sp.Matrix([sp.Rational(number) for number in corner])
