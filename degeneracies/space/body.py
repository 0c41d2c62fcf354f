"""A convex body by its facets, edges and vertices: strictly convex, exact."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations, pairwise

from minkref import _core
from minkref.degeneracies.space.vectors import Vector, crossed, difference, direction, product
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Whole

Corners = tuple[int, ...]  # a face's corners, ascending


@dataclass(frozen=True)
class Facet:
    ring: tuple[int, ...]
    normal: Whole

    @property
    def corners(self) -> Corners:
        return tuple(sorted(self.ring))


@dataclass(frozen=True)
class Edge:
    """`facets`: the two facets beside the edge. `direction` leads from the first end to the
    second."""

    ends: tuple[int, int]
    facets: tuple[int, int]
    direction: Whole


@dataclass(frozen=True)
class Body:
    """`given` may have triangulated facets and flat vertices; the other members describe the body
    without them, with vertices in lexicographic order."""

    given: Polyhedron
    name: str

    @cached_property
    def surface(self) -> _core.Polyhedron:
        """Returns the given body."""
        value = self.given.document()
        return _core.Polyhedron([(x, y, z) for x, y, z in value["vertices"]], value["faces"])

    @cached_property
    def convex(self) -> _core.ConvexPolyhedron:
        return _core.ConvexPolyhedron(self.surface, self.name)

    def certify(self) -> None:
        """Raises _core.BadInput if the body is not convex."""
        _ = self.convex

    @cached_property
    def _clean(self) -> _core.Polyhedron:
        return self.convex.surface()

    @cached_property
    def clean(self) -> Polyhedron:
        """The body with one facet per plane, and no flat vertex."""
        return Polyhedron(tuple(self.vertices), tuple(facet.ring for facet in self.facets))

    @cached_property
    def vertices(self) -> list[Point]:
        return self._clean.points()

    @cached_property
    def numbers(self) -> list[int]:
        """Maps each vertex to its number in the given body."""
        places = {point: k for k, point in enumerate(self.given.vertices)}
        return [places[point] for point in self.vertices]

    @cached_property
    def facets(self) -> list[Facet]:
        return [Facet(tuple(ring), self._normal(ring)) for ring in self._clean.rings()]

    @cached_property
    def edges(self) -> list[Edge]:
        sides = {
            (a, b): f
            for f, facet in enumerate(self.facets)
            for a, b in pairwise((*facet.ring, facet.ring[0]))
        }
        return [
            Edge(
                (a, b),
                (f, sides[(b, a)]),
                direction(difference(self.vertices[b], self.vertices[a])),
            )
            for (a, b), f in sorted(sides.items())
            if a < b
        ]

    @cached_property
    def directions(self) -> dict[Corners, Whole]:
        """The normals of facets, and the directions of edges."""
        found = {facet.corners: facet.normal for facet in self.facets}
        return found | {edge.ends: edge.direction for edge in self.edges}

    @cached_property
    def degree(self) -> int:
        """The most facets at a vertex."""
        corners = [k for facet in self.facets for k in facet.ring]
        return max(corners.count(k) for k in range(len(self.vertices)))

    @cached_property
    def volume(self) -> Fraction:
        return self._clean.sextuple_volume() / 6

    @cached_property
    def diameter(self) -> tuple[Point, Point]:
        """Two vertices at the greatest distance from each other."""
        pairs = combinations(self.vertices, 2)
        return max(pairs, key=lambda pair: _square(difference(*pair)))

    @cached_property
    def square_of_diameter(self) -> Fraction:
        return _square(difference(*self.diameter))

    @cached_property
    def square_of_girth(self) -> Fraction:
        """The square of the greatest distance between a vertex and the diameter's line."""
        a, b = self.diameter
        along = difference(b, a)
        far = max(_square(crossed(along, difference(v, a))) for v in self.vertices)
        return far / _square(along)

    @cached_property
    def square_of_thickness(self) -> Fraction:
        """The square of the least width across a facet."""
        return min(self._square_of_width(facet.normal) for facet in self.facets)

    def _square_of_width(self, across: Whole) -> Fraction:
        heights = [product(across, v) for v in self.vertices]
        return (max(heights) - min(heights)) ** 2 / product(across, across)

    def _normal(self, ring: list[int]) -> Whole:
        a, b, c = (self.vertices[k] for k in ring[:3])  # a strictly convex ring turns at each
        return direction(crossed(difference(b, a), difference(c, a)))


def _square(vector: Vector) -> Fraction:
    return product(vector, vector)
