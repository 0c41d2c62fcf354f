"""The facets of sums of small convex polyhedra from the definition, by sympy."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import sympy as sp

Corner = Sequence[str]  # three exact numbers, n or n/d
Face = frozenset[int]


def facets(P: Sequence[Corner], Q: Sequence[Corner], scaling: Corner) -> set[tuple[Face, Face]]:
    """Find, for each facet of S P + Q, the vertices of P and Q farthest along its normal; P and Q
    are given as vertices. A direction is a facet's normal iff the sum of the two farthest faces is
    flat: its difference vectors have rank 2. Every facet has two edges that are not parallel, each
    parallel to the difference of two vertices of P or of two vertices of Q, so products of such
    differences include all normals. Exact. O((m + n)^4) directions."""
    D = sp.diag(*map(sp.Rational, scaling))
    first = [D * _vector(corner) for corner in P]
    second = [_vector(corner) for corner in Q]
    differences = [b - a for points in (first, second) for a, b in combinations(points, 2)]
    found = set()
    for u, v in combinations(_directions(differences), 2):
        for normal in (u.cross(v), v.cross(u)):
            faces = _farthest(first, normal), _farthest(second, normal)
            if faces not in found and _rank(first, second, faces) == 2:
                found.add(faces)
    return found


def _vector(corner: Corner) -> sp.Matrix:
    return sp.Matrix([sp.Rational(number) for number in corner])


def _directions(vectors: list[sp.Matrix]) -> list[sp.Matrix]:
    """Choose one vector per line, with 1 as the first nonzero coordinate."""
    unique = {}
    for vector in vectors:
        lead = next(number for number in vector if number != 0)
        unique[tuple(vector / lead)] = vector / lead
    return list(unique.values())


def _farthest(points: list[sp.Matrix], normal: sp.Matrix) -> Face:
    heights = [normal.dot(point) for point in points]
    most = max(heights)
    return frozenset(k for k, height in enumerate(heights) if height == most)


def _rank(first: list[sp.Matrix], second: list[sp.Matrix], faces: tuple[Face, Face]) -> int:
    rows = []
    for points, face in zip((first, second), faces, strict=True):
        start, *others = sorted(face)
        rows += [list(points[k] - points[start]) for k in others]
    return int(sp.Matrix(rows).rank()) if rows else 0
