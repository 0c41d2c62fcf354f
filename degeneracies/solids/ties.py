"""The degeneracies of a case, as predicates of few vertices, exact: anyone can compute these
again from the case alone."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from minkref.degeneracies.solids.convolution import Convolution, ConvolutionFacet, Feature, sum_at
from minkref.degeneracies.solids.mesh import Corners, Mesh
from minkref.degeneracies.space.vectors import direction
from minkref.fuzz.geometry.space import Whole, cross, dot


@dataclass(frozen=True)
class Tie:
    """Features of P and Q, each by the vertices of its corners, for which a predicate is zero.

    - parallel-facets, opposite-facets: a face and a face; the cross product of their normals
    - facet-and-edge, edge-and-facet: the product of the normal and the edge
    - parallel-edges: the cross product of the edges
    - coplanar: facets of the convolution with one normal; the offset of one less that of the first
    - facing: two with opposite normals; how wide the gap between them is
    - one-line: three facets or more; the rank of their planes less two
    - one-point: four facets; the determinant of their planes
    - vertices-meet: sums of vertices; how far they are from the first
    - three-facets: a side of facets of the convolution (an edge and a vertex), and three of those
      facets; nothing is zero; none of them has a tie
    - flat-vertex: a vertex of one operand; none for the other. Its faces lie in one plane, or in
      two that meet along a line through it"""

    what: str
    features: tuple[Feature, ...]


class Predicates:
    """The values of ties at a case's scales."""

    def __init__(self, P: Mesh, Q: Mesh, facets: Convolution) -> None:
        self._P, self._Q, self._facets = P, Q, facets
        self._by_feature = {facet.feature: facet for facet in facets.facets}
        self._of: dict[str, Callable[[tuple[Feature, ...], Fraction], int]] = {
            "parallel-facets": self._parallel,
            "opposite-facets": self._parallel,
            "parallel-edges": self._parallel,
            "facet-and-edge": self._level,
            "edge-and-facet": self._level,
            "coplanar": self._coplanar,
            "facing": self._facing,
            "one-line": self._one_line,
            "one-point": self._one_point,
            "vertices-meet": self._meet,
            "three-facets": self._untied,
            "flat-vertex": self._flat,
        }

    def value(self, tie: Tie, s: Fraction) -> int:
        """The sign of the predicate; for a predicate without sign, 1 if not zero."""
        return self._of[tie.what](tie.features, s)

    def _direction(self, mesh: Mesh, corners: Corners) -> Whole:
        """The normal of a face, or the way along an edge from its lesser vertex."""
        if len(corners) == 2:
            a, b = (mesh.given.vertices[k] for k in corners)
            return direction(y - x for x, y in zip(a, b, strict=True))
        number = mesh.given.faces.index(corners)
        return mesh.normals[number]

    def _parallel(self, features: tuple[Feature, ...], s: Fraction) -> int:
        ((p, q),) = features
        across = cross(self._direction(self._P, p), self._direction(self._Q, q))
        return int(across != (0, 0, 0))

    def _level(self, features: tuple[Feature, ...], s: Fraction) -> int:
        ((p, q),) = features
        return sign(dot(self._direction(self._P, p), self._direction(self._Q, q)))

    def _planes(self, features: Iterable[Feature]) -> list[ConvolutionFacet]:
        return [self._by_feature[feature] for feature in features]

    def _coplanar(self, features: tuple[Feature, ...], s: Fraction) -> int:
        first, *others = self._planes(features)
        steps = [sign(other.offset(s) - first.offset(s)) for other in others]
        return next((step for step in steps if step), 0)

    def _facing(self, features: tuple[Feature, ...], s: Fraction) -> int:
        one, other = self._planes(features)
        return sign(-one.offset(s) - other.offset(s))

    def _one_line(self, features: tuple[Feature, ...], s: Fraction) -> int:
        return int(rank([(*f.normal, f.offset(s)) for f in self._planes(features)]) > 2)

    def _one_point(self, features: tuple[Feature, ...], s: Fraction) -> int:
        return sign(determinant([(*f.normal, f.offset(s)) for f in self._planes(features)]))

    def _meet(self, features: tuple[Feature, ...], s: Fraction) -> int:
        P, Q = self._P.given.vertices, self._Q.given.vertices
        return int(len({sum_at(P[p], Q[q], s) for (p,), (q,) in features}) > 1)

    def _untied(self, features: tuple[Feature, ...], s: Fraction) -> int:
        _, *facets = features
        return int(not all(facet in self._facets.strict for facet in facets))

    def _flat(self, features: tuple[Feature, ...], s: Fraction) -> int:
        ((p, q),) = features
        return int(not (self._P.is_flat(p[0]) if p else self._Q.is_flat(q[0])))


def rank(rows: Sequence[Sequence[Fraction | int]]) -> int:
    left = [[Fraction(value) for value in row] for row in rows]
    found = 0
    for column in range(4):
        pivot = next((row for row in left if row[column]), None)
        if pivot is None:
            continue
        found += 1
        left.remove(pivot)
        left = [
            [a - b * row[column] / pivot[column] for a, b in zip(row, pivot, strict=True)]
            for row in left
        ]
    return found


def determinant(rows: Sequence[Sequence[Fraction | int]]) -> Fraction:
    """The determinant of four planes, along the last column."""
    total = Fraction(0)
    for k, row in enumerate(rows):
        a, b, c = (other[:3] for j, other in enumerate(rows) if j != k)
        (x, y, z), (u, v, w), (p, q, r) = a, b, c
        minor = x * (v * r - w * q) - y * (u * r - w * p) + z * (u * q - v * p)
        total += (-1) ** (k + 1) * row[3] * minor
    return total


def sign(value: Fraction | int) -> int:
    return (value > 0) - (value < 0)
