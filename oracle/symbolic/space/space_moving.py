"""Moving edges and facets in space, under uniform scaling. docs/definitions.md, In space."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from ..rational import Rational, rationals
from ..solutions import all_solutions, compiled

Vector = tuple[Rational, ...]
Plane = tuple[Rational, ...]
"""n, k, l: the points x with n . x = k s + l."""


def minus(a: Vector, b: Vector) -> Vector:
    return tuple(x - y for x, y in zip(a, b, strict=True))


def dot(a: Vector, b: Vector) -> Rational:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def vector(values: Any) -> Vector:
    found = rationals(values)
    if len(found) != 3:
        raise ValueError("a point in space has three coordinates")
    return found


@dataclass(frozen=True, slots=True)
class SpaceVertex:
    """The point s p + q."""

    p: Vector
    q: Vector

    def at(self, s: Rational) -> Vector:
        return tuple(s * x + y for x, y in zip(self.p, self.q, strict=True))


@dataclass(frozen=True, slots=True)
class SpaceSegment:
    """The segment between two moving vertices with a common parent (`kind` S: one vertex of Q, T:
    one vertex of P), or an ee-facet's diagonal (`kind` D: no common parent). Raises ValueError for
    another kind, or if kind and vertices disagree."""

    kind: str
    start: SpaceVertex
    end: SpaceVertex

    def __post_init__(self) -> None:
        same = (self.start.q == self.end.q, self.start.p == self.end.p)
        if same != {"S": (True, False), "T": (False, True), "D": (False, False)}.get(self.kind):
            raise ValueError(f"{self.kind!r} is not the kind of an edge between these vertices")

    def at(self, s: Rational) -> tuple[Vector, Vector]:
        return self.start.at(s), self.end.at(s)

    @property
    def data(self) -> Vector:
        """The coordinates as the derivation orders them."""
        first, last = self.start, self.end
        if self.kind == "S":
            return (*first.p, *last.p, *first.q)
        if self.kind == "T":
            return (*first.p, *first.q, *last.q)
        return (*first.p, *last.p, *first.q, *last.q)

    def direction(self) -> Vector:
        """Return the parent edge's direction for an S- or T-edge."""
        if self.kind == "D":
            raise ValueError("a diagonal turns as s changes")
        a, b = (self.start.p, self.end.p) if self.kind == "S" else (self.start.q, self.end.q)
        return minus(b, a)

    def projections(self) -> list[Vector]:
        """Return the projections' data on the planes yz, zx, xy; they may have length zero."""
        triples = (self.data[0:3], self.data[3:6], self.data[6:9])
        return [
            tuple(x for point in triples for x in (point[i], point[j]))
            for i, j in ((1, 2), (2, 0), (0, 1))
        ]


@dataclass(frozen=True, slots=True)
class MovingFacet:
    """A facet of the convolution: `kind` fv (corners of P's facet, one vertex of Q), vf (one vertex
    of P, corners of Q's facet) or ee (two ends each). Facets are planar and simple, their first
    three corners not collinear."""

    kind: str
    P: tuple[Vector, ...]
    Q: tuple[Vector, ...]

    def __post_init__(self) -> None:
        least = {"fv": (3, 1), "vf": (1, 3), "ee": (2, 2)}.get(self.kind)
        if least is None or len(self.P) < least[0] or len(self.Q) < least[1]:
            raise ValueError("a facet is fv, vf or ee, with the parents of its kind")
        normal = self.plane()[:3]
        if not any(normal):
            raise ValueError("the facet has no plane")
        for corner in self.vertices():
            if any(
                dot(normal, minus(corner.at(s), self.corners(s)[0])) for s in map(Rational, (1, 2))
            ):
                raise ValueError("the corners of the facet do not lie in one plane")

    def vertices(self) -> list[SpaceVertex]:
        """List the vertices around the facet."""
        if self.kind == "ee":
            (a, b), (c, d) = self.P, self.Q
            return [SpaceVertex(p, q) for p, q in ((a, c), (b, c), (b, d), (a, d))]
        return [SpaceVertex(p, q) for p in self.P for q in self.Q]

    def corners(self, s: Rational) -> list[Vector]:
        return [vertex.at(s) for vertex in self.vertices()]

    def edges(self) -> list[SpaceSegment]:
        """List the sides: S-edges and T-edges, never diagonals."""
        around = self.vertices()
        sides = zip(around, [*around[1:], around[0]], strict=True)
        return [SpaceSegment("S" if a.q == b.q else "T", a, b) for a, b in sides]

    def plane(self) -> Plane:
        """Evaluate the derived solution, which is the same for all corners of a planar facet.
        Exact."""
        corners = (*self.P[:3], *self.Q[:3])
        found: Plane = plane_function(self.kind)(*(x for corner in corners for x in corner))
        return found


@cache
def plane_function(kind: str) -> Any:
    found = all_solutions()[f"plane {kind}"]
    arguments = [f"a{i}" for i in range(12)]
    return compiled((*found["normal"], found["slope"], found["constant"]), arguments)


def facet(kind: str, P: Sequence[Any], Q: Sequence[Any]) -> MovingFacet:
    return MovingFacet(kind, tuple(map(vector, P)), tuple(map(vector, Q)))
