"""A polyhedron: exact vertices, and faces that run counter-clockwise seen from outside."""

from __future__ import annotations

import json
import re
from collections import Counter
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref.fuzz.geometry.face_triangles import face_triangles
from minkref.fuzz.geometry.parts import Parts
from minkref.fuzz.geometry.space import (
    Point,
    Scale,
    Whole,
    area_vector,
    cross,
    denominator_of,
    dot,
    factors,
    whole,
)
from minkref.plane.rings import from_least

_NUMBER = re.compile(r"[+-]?\d+(/\d+)?", re.ASCII)
Face = tuple[int, ...]


@dataclass(frozen=True)
class Polyhedron:
    """As a set: the points with positive winding number, and their closure. An operand without
    faces equals its vertex, or the segment between its two vertices."""

    vertices: tuple[Point, ...]
    faces: tuple[Face, ...]

    @staticmethod
    def from_json(text: str) -> Polyhedron:
        return Polyhedron.from_document(json.loads(text))

    @staticmethod
    def from_document(value: Any) -> Polyhedron:
        """From {"vertices": [[x, y, z], ...], "faces": [[i, j, k, ...], ...]}, numbers as texts
        `n` or `n/d` or as int. Raises ValueError for anything else, an index out of range too;
        what `fault` names is not looked for."""
        if not isinstance(value, dict) or not all(
            isinstance(value.get(key), list | tuple) for key in ("vertices", "faces")
        ):
            raise ValueError("a polyhedron has the lists vertices and faces")
        vertices = tuple(_point(row, k) for k, row in enumerate(value["vertices"]))
        faces = tuple(_face(row, k, len(vertices)) for k, row in enumerate(value["faces"]))
        return Polyhedron(vertices, faces)

    @property
    def is_thin(self) -> bool:
        """A point or a segment."""
        return not self.faces and len(self.vertices) in (1, 2)

    def document(self) -> dict[str, Any]:
        return {
            "vertices": [[str(number) for number in vertex] for vertex in self.vertices],
            "faces": [list(face) for face in self.faces],
        }

    def to_json(self) -> str:
        return json.dumps(self.document(), separators=(",", ":"))

    def scaled(self, scale: Scale) -> Polyhedron:
        """Scaled about the origin. Factors are positive."""
        a, b, c = factors(scale)
        return Polyhedron(tuple((a * x, b * y, c * z) for x, y, z in self.vertices), self.faces)

    def translated(self, shift: Point) -> Polyhedron:
        a, b, c = shift
        return Polyhedron(tuple((x + a, y + b, z + c) for x, y, z in self.vertices), self.faces)

    def reflected(self, point: Point) -> Polyhedron:
        """All `point - q`, with outward normals again."""
        a, b, c = point
        return Polyhedron(
            tuple((a - x, b - y, c - z) for x, y, z in self.vertices),
            tuple(face[::-1] for face in self.faces),
        )

    def turned_inside_out(self) -> Polyhedron:
        return Polyhedron(self.vertices, tuple(face[::-1] for face in self.faces))

    def without_unused_vertices(self) -> Polyhedron:
        """Drops vertices that no face names: the set does not contain them."""
        used = sorted({index for face in self.faces for index in face})
        if len(used) == len(self.vertices):
            return self
        name = {index: place for place, index in enumerate(used)}
        faces = tuple(tuple(name[index] for index in face) for face in self.faces)
        return Polyhedron(tuple(self.vertices[index] for index in used), faces)

    def without_opposite_faces(self) -> Polyhedron:
        """Drops pairs of faces along the same points in opposite directions, as between abutting
        pieces: winding numbers stay."""
        left: dict[tuple[Point, ...], list[int]] = {}
        gone = set()
        for number, face in enumerate(self.faces):
            points = [self.vertices[index] for index in face]
            opposite = left.get(tuple(from_least(points[::-1])))
            if opposite:
                gone |= {number, opposite.pop()}
            else:
                left.setdefault(tuple(from_least(points)), []).append(number)
        if not gone:
            return self
        faces = tuple(face for number, face in enumerate(self.faces) if number not in gone)
        return Polyhedron(self.vertices, faces)

    def with_faces_of(self, other: Polyhedron) -> Polyhedron:
        """Both surfaces together; their winding numbers add."""
        count = len(self.vertices)
        moved = tuple(tuple(k + count for k in face) for face in other.faces)
        return Polyhedron(self.vertices + other.vertices, self.faces + moved)

    @cached_property
    def denominator(self) -> int:
        return denominator_of(self.vertices)

    @cached_property
    def wholes(self) -> tuple[Whole, ...]:
        """The vertices times `denominator`."""
        return tuple(whole(vertex, self.denominator) for vertex in self.vertices)

    @cached_property
    def triangles(self) -> tuple[tuple[int, int, int], ...]:
        """The faces in triangles, as indices; none without area."""
        return tuple(triple for face in self.faces for triple in self.triangles_of(face))

    def triangles_of(self, face: Face) -> list[tuple[int, int, int]]:
        triples = face_triangles([self.wholes[index] for index in face])
        return [(face[i], face[j], face[k]) for i, j, k in triples]

    @cached_property
    def volume(self) -> Fraction:
        """With sign; parts of winding number n count n times."""
        points = self.wholes
        total = sum(dot(points[i], cross(points[j], points[k])) for i, j, k in self.triangles)
        return Fraction(total, 6 * self.denominator**3)

    @cached_property
    def box(self) -> tuple[Point, Point]:
        """Smallest and largest coordinates. ValueError without vertices."""
        if not self.vertices:
            raise ValueError("a polyhedron without vertices has no box")
        columns = list(zip(*self.vertices, strict=True))
        low, high = [min(c) for c in columns], [max(c) for c in columns]
        return (low[0], low[1], low[2]), (high[0], high[1], high[2])

    @cached_property
    def shells(self) -> tuple[int, ...]:
        """For each face, a vertex that represents its connected part of the surface; common
        vertices connect faces."""
        parts = Parts(len(self.vertices))
        for face in self.faces:
            for k in face:
                parts.join(k, face[0])
        return tuple(parts.of(face[0]) for face in self.faces)

    def bad_face(self) -> tuple[int, str] | None:
        """Finds a face that is too short, not planar or without area, and says its fault."""
        for number, face in enumerate(self.faces):
            if len(face) < 3:
                return number, "has fewer than three vertices"
            ring = [self.wholes[index] for index in face]
            if area_vector(ring) == (0, 0, 0):
                return number, "has no area"
            if not _is_planar(ring):
                return number, "is not planar"
        return None

    def bent_face(self) -> int | None:
        """Finds a face that is not planar, ignoring faces without area."""
        rings = ([self.wholes[index] for index in face] for face in self.faces)
        return next((number for number, ring in enumerate(rings) if not _is_planar(ring)), None)

    def fault(self) -> str | None:
        """A sentence that names the obstacle to this being an operand, or None. Self-intersection
        is not tested."""
        if self.is_thin:
            same = len(set(self.vertices)) < len(self.vertices)
            return "the two ends of the segment are the same point" if same else None
        if not self.faces:
            return "there are no faces, and not one vertex or two"
        for number, face in enumerate(self.faces):
            if any(not 0 <= index < len(self.vertices) for index in face):
                return f"face {number} has an index out of range"
        bad = self.bad_face()
        if bad is not None:
            return f"face {bad[0]} {bad[1]}"
        edges = Counter(
            (a, b) for face in self.faces for a, b in zip(face, face[1:] + face[:1], strict=True)
        )
        for (a, b), count in edges.items():
            if count != 1 or edges[(b, a)] != 1:
                return (
                    f"the edge from vertex {a} to vertex {b} occurs {count} times, "
                    f"and {edges[(b, a)]} times the other way"
                )
        split = self._split_vertex()
        return None if split is None else f"the faces at vertex {split} are no single fan"

    def _split_vertex(self) -> int | None:
        """A vertex at which the surface touches itself; its edges have to be paired."""
        onward: dict[int, dict[int, int]] = {}
        for face in self.faces:
            for k, vertex in enumerate(face):
                onward.setdefault(vertex, {})[face[(k + 1) % len(face)]] = face[k - 1]
        for vertex, fan in onward.items():
            start = next(iter(fan))
            seen, at = 1, fan[start]
            while at != start:
                seen, at = seen + 1, fan[at]
            if seen != len(fan):
                return vertex
        return None


def _is_planar(ring: list[Whole]) -> bool:
    vector = area_vector(ring)
    height = dot(vector, ring[0])
    return all(dot(vector, point) == height for point in ring)


def _point(row: Any, place: int) -> Point:
    if not isinstance(row, list | tuple) or len(row) != 3:
        raise ValueError(f"vertex {place} is not three exact numbers")
    x, y, z = (_number(value, place) for value in row)
    return (x, y, z)


def _number(value: Any, place: int) -> Fraction:
    if isinstance(value, int) and not isinstance(value, bool):
        return Fraction(value)
    if isinstance(value, str) and _NUMBER.fullmatch(value):
        try:
            return Fraction(value)
        except ZeroDivisionError:
            pass
    raise ValueError(f"vertex {place} is not three exact numbers")


def _face(row: Any, place: int, count: int) -> Face:
    if not isinstance(row, list | tuple) or any(
        not isinstance(index, int) or isinstance(index, bool) for index in row
    ):
        raise ValueError(f"face {place} is not a list of indices")
    if len(row) < 3:
        raise ValueError(f"face {place} has fewer than three vertices")
    if any(not 0 <= index < count for index in row):
        raise ValueError(f"face {place} has an index out of range")
    return tuple(row)
