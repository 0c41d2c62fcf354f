"""The facets of the convolution of two polyhedra, with ties unbroken: a part level with a facet
counts as below it, so a facet exists if it exists after some small motion (Sec. 3). Under uniform
scaling all scales have the same facets, whose planes move linearly."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from minkref.degeneracies.solids.mesh import Corners, Mesh, SolidEdge
from minkref.degeneracies.space.vectors import direction, product
from minkref.fuzz.geometry.space import Point, Whole, cross, dot

Feature = tuple[Corners, Corners]  # corners in P, corners in Q


@dataclass(frozen=True)
class ConvolutionFacet:
    """The sum of two features, by their corners. The facet's plane `n · x = offset(s)` bounds the
    sum from above. Faces run as in the mesh."""

    P: Corners
    Q: Corners
    normal: Whole
    level: tuple[Fraction, Fraction]  # n · p and n · q
    is_strict: bool  # without ties

    @property
    def feature(self) -> Feature:
        return self.P, self.Q

    def offset(self, s: Fraction) -> Fraction:
        return s * self.level[0] + self.level[1]

    def is_level_with(self, x: Point, s: Fraction) -> bool:
        """Whether the point lies in the facet's plane."""
        return product(self.normal, x) == self.offset(s)

    @property
    def key(self) -> tuple[Whole, Fraction, Fraction]:
        """A key that facets share if coplanar at all scales."""
        return self.normal, *self.level


@dataclass(frozen=True)
class Convolution:
    P: Mesh
    Q: Mesh

    @cached_property
    def facets(self) -> list[ConvolutionFacet]:
        return [*self._faces_on_vertices(), *self._vertices_on_faces(), *self._edges_on_edges()]

    @cached_property
    def strict(self) -> dict[Feature, ConvolutionFacet]:
        """The facets without ties, by their features."""
        return {facet.feature: facet for facet in self.facets if facet.is_strict}

    def corners(self, facet: ConvolutionFacet, s: Fraction) -> list[Point]:
        """Returns a ring; for a parallelogram, in either direction."""
        P, Q = self.P.given.vertices, self.Q.given.vertices
        if len(facet.P) == len(facet.Q) == 2:
            (a, b), (c, d) = facet.P, facet.Q
            pairs = [(a, c), (b, c), (b, d), (a, d)]
        else:
            pairs = [(p, q) for p in facet.P for q in facet.Q]
        return [sum_at(P[p], Q[q], s) for p, q in pairs]

    def _faces_on_vertices(self) -> Iterator[ConvolutionFacet]:
        for face, n in zip(self.P.given.faces, self.P.normals, strict=True):
            for vertex, strict in _below(self.Q, n):
                yield self._facet(face, (vertex,), n, strict)

    def _vertices_on_faces(self) -> Iterator[ConvolutionFacet]:
        for face, n in zip(self.Q.given.faces, self.Q.normals, strict=True):
            for vertex, strict in _below(self.P, n):
                yield self._facet((vertex,), face, n, strict)

    def _edges_on_edges(self) -> Iterator[ConvolutionFacet]:
        for e in self.P.edges:
            for f in self.Q.edges:
                found = compatible(self.P, e, self.Q, f)
                if found:
                    yield self._facet(e.ends, f.ends, *found)

    def _facet(self, p: Corners, q: Corners, n: Whole, strict: bool) -> ConvolutionFacet:
        level = product(n, self.P.given.vertices[p[0]]), product(n, self.Q.given.vertices[q[0]])
        return ConvolutionFacet(p, q, n, level, strict)


def compatible(P: Mesh, e: SolidEdge, Q: Mesh, f: SolidEdge) -> tuple[Whole, bool] | None:
    """Returns the outward normal of the facet of two edges, and whether the facet has no tie; None
    for parallel edges, or without a facet."""
    across = cross(e.along, f.along)
    if not (e.is_convex and f.is_convex) or across == (0, 0, 0):
        return None
    signs = (
        dot(P.normals[e.left], f.along),
        -dot(P.normals[e.right], f.along),
        -dot(Q.normals[f.left], e.along),
        dot(Q.normals[f.right], e.along),
    )
    strict = 0 not in signs
    if min(signs) >= 0:
        return direction(across), strict
    if max(signs) <= 0:
        return direction((-across[0], -across[1], -across[2])), strict
    return None


def sum_at(p: Point, q: Point, s: Fraction) -> Point:
    x, y, z = (s * a + b for a, b in zip(p, q, strict=True))
    return x, y, z


def _below(mesh: Mesh, n: Whole) -> Iterator[tuple[int, bool]]:
    """Yields vertices whose edges all run down from n, or level, and whether none runs level."""
    for vertex, ways in enumerate(mesh.ways):
        highest = max((dot(n, way) for way in ways), default=-1)  # a point is below all
        if highest <= 0:
            yield vertex, highest < 0
