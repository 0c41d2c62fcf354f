"""Convex polyhedra with integer vertices; compatible features are found by supports alone, without
the Gaussian map. Exact."""

from __future__ import annotations

import random
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Whole, cross, dot, minus, normal, primitive
from minkref.fuzz.space.hull import convex_hull

__all__ = [
    "ONE",
    "Body",
    "Edge",
    "Pairs",
    "Whole",
    "compatible_pairs",
    "cross",
    "dot",
    "drawn_body",
    "drawn_scaling",
    "edge_pairs",
    "facet_pairs",
    "hull",
    "minus",
    "random_body",
    "scaled",
    "scaled_normal",
    "support",
]

ONE: Whole = (1, 1, 1)
Edge = tuple[int, int]
Supports = tuple[frozenset[int], ...]


@dataclass(frozen=True)
class Body:
    """Facets run counter-clockwise seen from outside."""

    points: tuple[Whole, ...]
    facets: tuple[tuple[int, ...], ...]

    @cached_property
    def normals(self) -> tuple[Whole, ...]:
        """Outward facet normals of varying length."""
        return tuple(
            primitive(normal(*(self.points[k] for k in facet[:3]))) for facet in self.facets
        )

    @cached_property
    def edges(self) -> dict[Edge, tuple[int, int]]:
        """From the lesser to the greater vertex: the facets on both sides."""
        left = {
            edge: number
            for number, facet in enumerate(self.facets)
            for edge in pairwise((*facet, facet[0]))
        }
        return {(i, j): (left[i, j], left[j, i]) for i, j in sorted(left) if i < j}

    @cached_property
    def neighbours(self) -> tuple[tuple[int, ...], ...]:
        found: list[list[int]] = [[] for _ in self.points]
        for i, j in self.edges:
            found[i].append(j)
            found[j].append(i)
        return tuple(map(tuple, found))

    def along(self, edge: Edge) -> Whole:
        return minus(self.points[edge[1]], self.points[edge[0]])

    @cached_property
    def polyhedron(self) -> Polyhedron:
        return Polyhedron(tuple(map(_exact, self.points)), self.facets)


def _exact(point: Sequence[int]) -> tuple[Fraction, Fraction, Fraction]:
    x, y, z = map(Fraction, point)
    return x, y, z


def hull(points: Sequence[Whole]) -> Body:
    """Convex hull whose vertices keep the order of `points`. Raises ValueError if a point is not a
    vertex."""
    found = convex_hull(map(_exact, points))
    name = {_exact(point): number for number, point in enumerate(points)}
    if len(found.vertices) != len(points):
        raise ValueError("a point is no vertex")
    place = [name[vertex] for vertex in found.vertices]
    return Body(tuple(points), tuple(tuple(place[k] for k in face) for face in found.faces))


def scaled(s: Whole, point: Whole) -> Whole:
    return s[0] * point[0], s[1] * point[1], s[2] * point[2]


def scaled_normal(s: Whole, n: Whole) -> Whole:
    """A facet normal of the scaled body: n times the cofactors of the scaling."""
    return s[1] * s[2] * n[0], s[2] * s[0] * n[1], s[0] * s[1] * n[2]


def support(points: Iterable[Whole], n: Whole) -> frozenset[int]:
    """The vertices farthest along the direction n."""
    heights = [dot(n, point) for point in points]
    most = max(heights)
    return frozenset(k for k, height in enumerate(heights) if height == most)


@dataclass(frozen=True)
class Pairs:
    """Compatible features of the scaled P and Q: per facet of P, Q's vertices; per facet of Q, P's
    vertices; and edge pairs."""

    fv: Supports
    vf: Supports
    ee: frozenset[tuple[Edge, Edge]]

    @property
    def unique(self) -> bool:
        """Each facet has a single vertex."""
        return all(len(each) == 1 for each in (*self.fv, *self.vf))


def facet_pairs(P: Body, Q: Body, s: Whole) -> tuple[Supports, Supports]:
    """For each facet, the other body's vertices farthest along the facet normal."""
    big = [scaled(s, point) for point in P.points]
    return (
        tuple(support(Q.points, scaled_normal(s, n)) for n in P.normals),
        tuple(support(big, n) for n in Q.normals),
    )


def edge_pairs(P: Body, Q: Body, s: Whole) -> frozenset[tuple[Edge, Edge]]:
    """Compatible edge pairs: along some direction orthogonal to both edges, exactly these two are
    farthest. Parallel edges are never compatible."""
    big = [scaled(s, point) for point in P.points]
    found = set()
    for e in P.edges:
        for g in Q.edges:
            n = cross(scaled(s, P.along(e)), Q.along(g))
            for way in (n, minus((0, 0, 0), n)) if any(n) else ():
                if support(big, way) == set(e) and support(Q.points, way) == set(g):
                    found.add((e, g))
    return frozenset(found)


def compatible_pairs(P: Body, Q: Body, s: Whole = ONE) -> Pairs:
    return Pairs(*facet_pairs(P, Q, s), edge_pairs(P, Q, s))


def random_body(dice: random.Random, count: int, size: int = 9) -> Body:
    """With `count` vertices, four to six or so, all facets triangles."""
    while True:
        points = [
            (dice.randint(-size, size), dice.randint(-size, size), dice.randint(-size, size))
            for _ in range(count)
        ]
        try:
            found = hull(points)
        except ValueError:
            continue
        if all(len(facet) == 3 for facet in found.facets):
            return found


def drawn_body(dice: random.Random) -> Body:
    return random_body(dice, dice.randint(4, 6))


def drawn_scaling(dice: random.Random, most: int = 9) -> Whole:
    return dice.randint(1, most), dice.randint(1, most), dice.randint(1, most)
