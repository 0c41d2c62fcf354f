"""The degree of incompatibility of Behar & Lien 2012, Section 6, by computer algebra, and the
descent on it: as printed and in its right form."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

Corner = Sequence[str]  # three exact numbers, n or n/d
T = sp.Symbol("t", real=True)


def degrees(
    facet: Sequence[Corner], vertex: Corner, others: Sequence[Corner], scaling: Corner
) -> dict[str, list[sp.Rational]]:
    """For each edge from the vertex to one of the others its part of IC(f, v) squared. `facet`:
    the corners of a facet of P, counter-clockwise seen from outside, not yet scaled. The plane of
    the scaled facet is moved to the vertex. `printed`: the longest distance of a point on the edge
    from it; `corrected`: of a point above it. Exact."""
    normal = _normal(facet, scaling)
    start = _vector(vertex)
    square = normal.dot(normal)
    found: dict[str, list[sp.Rational]] = {"printed": [], "corrected": []}
    for other in others:
        point = start + T * (_vector(other) - start)  # t from 0 to 1
        height = sp.expand(normal.dot(point - start))
        ends = [height.subs(T, t) for t in (0, 1)]  # it is linear in t
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
    """From a vertex along witnesses until no edge is above the plane: for each vertex on the way
    the other ends of its witnesses, and IC squared; and the end, None where a vertex is met again.
    Where there are several witnesses, the text does not say which is taken: the way ends there."""
    way: list[tuple[int, set[int], sp.Rational]] = []
    while vertex not in [at for at, _, _ in way]:
        others = list(neighbours[vertex])
        found = degrees(facet, points[vertex], [points[k] for k in others], scaling)
        if max(found["corrected"]) == 0:
            return way, vertex
        most = max(found[form])
        witnesses = {k for k, own in zip(others, found[form], strict=True) if own == most}
        way.append((vertex, witnesses, most))
        if len(witnesses) > 1:  # which is taken is not said
            return way, None
        (vertex,) = witnesses
    return way, None


def _normal(facet: Sequence[Corner], scaling: Corner) -> sp.Matrix:
    scale = sp.diag(*map(sp.Rational, scaling))
    a, b, c = (scale * _vector(corner) for corner in facet[:3])
    return (b - a).cross(c - a)


def _vector(corner: Corner) -> sp.Matrix:
    return sp.Matrix([sp.Rational(number) for number in corner])
