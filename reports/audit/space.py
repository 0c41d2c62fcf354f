"""Facets and edges of a convolution in space, and their common points at one scale: exact, in plain
Python. Only `events_of_facets` calls the symbolic oracle."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

from minkref.fuzz.geometry.space import Point, Whole, cross, dot, minus, normal
from minkref.fuzz.judges.space import paper_space

Vector = Point


def vector(numbers: Sequence[int | Fraction]) -> Vector:
    x, y, z = map(Fraction, numbers)
    return x, y, z


def determinant(a: Vector, b: Vector, c: Vector) -> Fraction:
    return dot(cross(a, b), c)


@dataclass(frozen=True)
class Vertex:
    """s p + q."""

    p: Vector
    q: Vector

    def at(self, s: Fraction) -> Vector:
        return (s * self.p[0] + self.q[0], s * self.p[1] + self.q[1], s * self.p[2] + self.q[2])

    @property
    def numbers(self) -> paper_space.Vertex:
        return self.p, self.q


@dataclass(frozen=True)
class Edge:
    """An S-edge, a T-edge, or (D) a diagonal of an ee-facet."""

    kind: str
    start: Vertex
    end: Vertex

    def at(self, s: Fraction) -> tuple[Vector, Vector]:
        return self.start.at(s), self.end.at(s)

    @property
    def direction(self) -> Vector:
        """Direction of the S-edge's or T-edge's parent."""
        if self.kind == "S":
            return minus(self.end.p, self.start.p)
        return minus(self.end.q, self.start.q)

    @property
    def numbers(self) -> paper_space.Edge:
        return self.kind, self.start.numbers, self.end.numbers


@dataclass(frozen=True)
class Facet:
    """fv: a facet of P at a vertex of Q; vf: a facet of Q at a vertex of P; ee: the parallelogram
    of two edges. Convex."""

    kind: str
    P: tuple[Vector, ...]
    Q: tuple[Vector, ...]

    @property
    def vertices(self) -> list[Vertex]:
        """In order around it."""
        if self.kind == "ee":
            (a, b), (c, d) = self.P, self.Q
            return [Vertex(a, c), Vertex(b, c), Vertex(b, d), Vertex(a, d)]
        return [Vertex(p, q) for p in self.P for q in self.Q]

    @property
    def edges(self) -> list[Edge]:
        around = self.vertices
        return [Edge("S" if a.q == b.q else "T", a, b) for a, b in pairwise([*around, around[0]])]

    def corners(self, s: Fraction) -> list[Vector]:
        return [vertex.at(s) for vertex in self.vertices]

    @property
    def normal(self) -> Vector:
        """The same at all scales, but for its length."""
        return normal(*self.corners(Fraction(1))[:3])

    @property
    def numbers(self) -> paper_space.Facet:
        return self.kind, self.P, self.Q


def facet(kind: str, P: Sequence[Whole], Q: Sequence[Whole]) -> Facet:
    return Facet(kind, tuple(map(vector, P)), tuple(map(vector, Q)))


def s_edge(p0: Whole, p1: Whole, q: Whole) -> Edge:
    return Edge("S", Vertex(vector(p0), vector(q)), Vertex(vector(p1), vector(q)))


def t_edge(q0: Whole, q1: Whole, p: Whole) -> Edge:
    return Edge("T", Vertex(vector(p), vector(q0)), Vertex(vector(p), vector(q1)))


def in_polygon(x: Vector, corners: Sequence[Vector]) -> bool:
    """Whether a point in a convex polygon's plane belongs to the polygon."""
    n = normal(*corners[:3])
    around = pairwise([*corners, corners[0]])
    return all(dot(n, cross(minus(b, a), minus(x, a))) >= 0 for a, b in around)


def segments_meet(a: Vector, b: Vector, c: Vector, d: Vector) -> bool:
    u, v, w = minus(b, a), minus(d, c), minus(c, a)
    n = cross(u, v)
    if any(n):
        t, r = dot(cross(w, v), n), dot(cross(w, u), n)
        return dot(n, w) == 0 and 0 <= t <= dot(n, n) and 0 <= r <= dot(n, n)
    if any(cross(u, w)):
        return False
    ends = sorted((dot(u, w), dot(u, minus(d, a))))
    return ends[0] <= dot(u, u) and ends[1] >= 0


def segment_meets(a: Vector, b: Vector, corners: Sequence[Vector]) -> bool:
    """A segment and a convex polygon."""
    n = normal(*corners[:3])
    below, above = dot(n, minus(a, corners[0])), dot(n, minus(b, corners[0]))
    if below == above == 0:
        return in_polygon(a, corners) or any(
            segments_meet(a, b, c, d) for c, d in pairwise([*corners, corners[0]])
        )
    if below * above > 0:
        return False
    t = below / (below - above)
    d = minus(b, a)
    return in_polygon((a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]), corners)


def polygons_meet(a: Sequence[Vector], b: Sequence[Vector]) -> bool:
    """Whether two convex polygons meet: if so, an edge of one polygon meets the other."""
    return any(
        segment_meets(x, y, other)
        for one, other in ((a, b), (b, a))
        for x, y in pairwise([*one, one[0]])
    )


def drawn(dice: random.Random, kind: str, size: int) -> Facet:
    """A triangle or a parallelogram with small integers, with an area."""
    cut = {"fv": 3, "vf": 1, "ee": 2}[kind]
    while True:
        points = [vector([dice.randint(-size, size) for _ in "xyz"]) for _ in range(4)]
        found = Facet(kind, tuple(points[:cut]), tuple(points[cut:]))
        if any(found.normal):
            return found


def events_of_facets(a: Facet, b: Facet) -> dict[str, list[Fraction]]:
    """All vertex events and edge events of a pair, from the symbolic oracle: scales at which a
    vertex of one facet lies on the other, and scales at which two edges start or stop meeting."""
    found: dict[str, list[Fraction]] = {"vertex": [], "edge": []}
    for one, other in ((a, b), (b, a)):
        for vertex in one.vertices:
            _, s, meet = paper_space.vertex_event(other.numbers, vertex.numbers)
            if s is not None and s > 0 and meet:
                found["vertex"].append(s)
    for x in a.edges:
        for y in b.edges:
            bounds = paper_space.edge_contact(x.numbers, y.numbers)
            found["edge"] += [s for s in bounds or () if s is not None]
    return found
