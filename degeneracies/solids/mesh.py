"""A polyhedron of any shape by its faces, edges and vertices, as directions: exact."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from minkref import _core
from minkref.degeneracies.space.vectors import crossed, difference, direction
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Whole, area_vector, cross, dot
from minkref.fuzz.judges.space.space_routes import core_polyhedron

Corners = tuple[int, ...]


@dataclass(frozen=True)
class SolidEdge:
    """An edge from its first end to its second; `left` and `right` are the faces beside it. A
    segment has an edge without faces."""

    ends: tuple[int, int]
    along: Whole
    left: int
    right: int
    is_convex: bool  # and not flat


@dataclass(frozen=True)
class Mesh:
    """Faces as given: two faces in one plane stay two, with a flat edge between."""

    given: Polyhedron

    @cached_property
    def surface(self) -> _core.Polyhedron:
        return core_polyhedron(self.given)

    def certify(self, name: str) -> None:
        """Raises _core.BadInput for an invalid operand; a point or a segment is valid."""
        if not self.given.is_thin:
            self.surface.validate(name)

    @cached_property
    def normals(self) -> list[Whole]:
        """The least whole normals of the faces, outwards."""
        points = self.given.wholes
        return [direction(area_vector([points[k] for k in face])) for face in self.given.faces]

    @cached_property
    def edges(self) -> list[SolidEdge]:
        vertices, sides = self.given.vertices, {}
        for number, face in enumerate(self.given.faces):
            for a, b in pairwise((*face, face[0])):
                sides[(a, b)] = number
        found = []
        for (a, b), left in sorted(sides.items()):
            if a < b:
                right, along = sides[(b, a)], direction(difference(vertices[b], vertices[a]))
                turn = dot(cross(self.normals[left], self.normals[right]), along)
                found.append(SolidEdge((a, b), along, left, right, turn > 0))
        return found

    @cached_property
    def ways(self) -> list[list[Whole]]:
        """Lists, for each vertex, the directions of its edges, away from the vertex."""
        points = self.given.vertices
        beside: list[set[int]] = [set() for _ in points]
        for face in self.given.faces:
            for a, b in pairwise((*face, face[0])):
                beside[a].add(b)
                beside[b].add(a)
        if self.given.is_thin and len(points) == 2:
            beside = [{1}, {0}]
        return [
            [direction(difference(points[b], points[a])) for b in sorted(others)]
            for a, others in enumerate(beside)
        ]

    @cached_property
    def faces_at(self) -> dict[int, list[int]]:
        """Lists, for each vertex, the faces around it."""
        found = defaultdict(list)
        for number, face in enumerate(self.given.faces):
            for k in face:
                found[k].append(number)
        return dict(found)

    def is_flat(self, vertex: int) -> bool:
        """Whether the faces at the vertex lie in one plane, or in two that meet along a line
        through the vertex."""
        normals = [self.normals[f] for f in self.faces_at[vertex]]
        first = normals[0]
        second = next((n for n in normals if cross(first, n) != (0, 0, 0)), None)
        if second is None:
            return True
        line = cross(first, second)
        if any(dot(line, n) for n in normals):
            return False
        return any(not any(crossed(line, way)) for way in self.ways[vertex])
