"""A point outside a sum: a code holds it apart from all pairs of pieces."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from math import lcm

from minkref.certify.plane.piece_nodes import Tree, Vector
from minkref.certify.plane.predicate import Place, Vertices

SPLIT_P, SPLIT_Q = -1, -2
RECENT = 4  # normals to try first: pairs next to each other often share one


class PointApart:
    """Normals, and a code like `sep` (docs/certificates.md), to show a point outside sP + Q.
    `steps`: the steps `pieces` for P and Q. Exact; the cost grows with the pairs of pieces whose
    groups are near the point."""

    def __init__(
        self, steps: Sequence[str], vertices: Vertices, scale: Fraction, point: Place
    ) -> None:
        both = (vertices.P, vertices.Q)
        unit = lcm(*(c.denominator for of in both for place in of for c in place))
        self._P, self._Q = (
            Tree(json.loads(step), of, unit) for step, of in zip(steps, both, strict=True)
        )
        self._factors = scale.as_integer_ratio()
        self._point = [c * unit * scale.denominator for c in point]
        self._numbers: dict[Vector, int] = {}
        self._recent: list[Vector] = []

    def code(self) -> list[int] | None:
        """Returns None if the point is in the sum."""
        found: list[int] = []
        stack = [(self._P.root, self._Q.root)] if self._P.hulls and self._Q.hulls else []
        while stack:
            A, B = stack.pop()
            normal = self._separating(A, B)
            if normal is not None:
                found.append(self._numbers.setdefault(normal, len(self._numbers)))
                continue
            of_P, of_Q = self._P.children[A], self._Q.children[B]
            if not of_P and not of_Q:
                return None
            s, w = self._factors
            larger = not of_Q or s * self._P.extents[A] >= w * self._Q.extents[B]
            if of_P and larger:
                found.append(SPLIT_P)
                stack += [(child, B) for child in reversed(of_P)]
            else:
                found.append(SPLIT_Q)
                stack += [(A, child) for child in reversed(of_Q)]
        return found

    def normals(self) -> list[list[int]]:
        """Returns the normals the code names, by number."""
        return [list(normal) for normal in self._numbers]

    def _separating(self, A: int, B: int) -> Vector | None:
        (s, w), (x, y) = self._factors, self._point
        for n in (*self._recent, *self._P.sides[A], *self._Q.sides[B]):
            if n[0] * x + n[1] * y > s * self._P.most(A, n) + w * self._Q.most(B, n):
                self._recent = [n, *(other for other in self._recent if other != n)][:RECENT]
                return n
        return None
