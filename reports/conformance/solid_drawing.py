"""Polyhedra as layers of a picture: parallel projection along (1, 1, 1), z upwards."""

from __future__ import annotations

import math

from minkref.exact import approximate
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.reports.drawing import Layer, Segment

MOST_FACES = 1500
_COS = math.sqrt(3) / 2

Place = tuple[float, float, float]


def projected(place: Place) -> tuple[float, float]:
    x, y, z = place
    return (_COS * (y - x), z - (x + y) / 2)


def place_of(numbers: tuple[str, ...]) -> Place | None:
    """The nearest doubles; None if a number exceeds the doubles."""
    x, y, z = (approximate(number) for number in numbers)
    return (x, y, z) if all(math.isfinite(n) for n in (x, y, z)) else None


def solid_layers(solid: Polyhedron, style: str) -> list[Layer] | None:
    """The solid's faces, back to front, each with one of three shades; thin edges for faces that
    look away. None for too many faces, or for coordinates beyond the doubles."""
    if len(solid.faces) > MOST_FACES:
        return None
    places = [place_of(tuple(str(n) for n in vertex)) for vertex in solid.vertices]
    if any(place is None for place in places):
        return None
    known = [place for place in places if place is not None]
    faces = [[known[index] for index in face] for face in solid.faces]
    faces.sort(key=lambda face: sum(sum(place) for place in face) / len(face))
    normals = [_normal(face) for face in faces]
    back = [
        line
        for face, normal in zip(faces, normals, strict=True)
        if sum(normal) < 0
        for line in _outline(face)
    ]
    front = [
        Layer(f"{style} shade{shade(normal)}", [[[projected(place) for place in face]]])
        for face, normal in zip(faces, normals, strict=True)
        if sum(normal) >= 0
    ]
    return [*front, Layer("hidden-edge", segments=back)]


def wire_layer(solid: Polyhedron, style: str) -> Layer | None:
    """Its edges."""
    places = [place_of(tuple(str(n) for n in vertex)) for vertex in solid.vertices]
    if len(solid.faces) > MOST_FACES or any(place is None for place in places):
        return None
    known = [place for place in places if place is not None]
    lines = [line for face in solid.faces for line in _outline([known[index] for index in face])]
    return Layer(style, segments=lines)


def _outline(face: list[Place]) -> list[Segment]:
    flat = [projected(place) for place in face]
    return [(*a, *b) for a, b in zip(flat, flat[1:] + flat[:1], strict=True)]


def _normal(face: list[Place]) -> Place:
    """Newell's normal, not of unit length."""
    total = [0.0, 0.0, 0.0]
    for a, b in zip(face, face[1:] + face[:1], strict=True):
        for k in range(3):
            i, j = (k + 1) % 3, (k + 2) % 3
            total[k] += (a[i] - b[i]) * (a[j] + b[j])
    return (total[0], total[1], total[2])


def shade(normal: Place) -> int:
    """The shade for the axis along which a face mostly looks: z is lightest."""
    return max(range(3), key=lambda k: abs(normal[k]))
