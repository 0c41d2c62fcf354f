"""The same solid with more vertices and faces than it needs."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from random import Random

from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import Point, area_vector, cross, dot, middle, minus

SHARES = tuple(Fraction(text) for text in ("1/2", "1/3", "3/4"))


def refined(dice: Random, solid: Polyhedron) -> Polyhedron:
    """Puts a vertex inside some edges, and cuts some convex faces into a fan around an inner
    vertex. At least one of both, if a face is convex."""
    vertices = list(solid.vertices)
    faces = list(solid.faces)
    edges = sorted({(min(a, b), max(a, b)) for f in faces for a, b in pairwise((*f, f[0]))})
    for a, b in dice.sample(edges, max(1, len(edges) // 5)):
        t = dice.choice(SHARES)
        x, y, z = (u + t * (v - u) for u, v in zip(vertices[a], vertices[b], strict=True))
        vertices.append((x, y, z))
        faces = [_with_vertex(face, a, b, len(vertices) - 1) for face in faces]
    convex = [k for k, face in enumerate(solid.faces) if _is_convex(solid, face)]
    fans = set(dice.sample(convex, max(1, len(convex) // 2))) if convex else set()
    found: list[Face] = []
    for number, face in enumerate(faces):
        if number not in fans:
            found.append(face)
            continue
        vertices.append(_inside(dice, [vertices[k] for k in solid.faces[number]]))
        found += [(a, b, len(vertices) - 1) for a, b in pairwise((*face, face[0]))]
    return Polyhedron(tuple(vertices), tuple(found))


def _with_vertex(face: Face, a: int, b: int, between: int) -> Face:
    found: list[int] = []
    for u, v in pairwise((*face, face[0])):
        found.append(u)
        if {u, v} == {a, b}:
            found.append(between)
    return tuple(found)


def _is_convex(solid: Polyhedron, face: Face) -> bool:
    points = [solid.wholes[k] for k in face]
    n = area_vector(points)
    ring = zip(points, (*points[1:], points[0]), (*points[2:], *points[:2]), strict=True)
    return all(dot(n, cross(minus(b, a), minus(c, b))) > 0 for a, b, c in ring)


def _inside(dice: Random, ring: list[Point]) -> Point:
    """A point in the middle of the face, or of three corners."""
    return middle(dice.sample(ring, 3) if dice.random() < 0.5 else ring)
