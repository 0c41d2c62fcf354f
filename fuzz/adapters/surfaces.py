"""Surfaces: their planar faces cut into triangles. Standard library only."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

Plane = tuple[Fraction, Fraction]
Triangle = tuple[int, int, int]


def triangles_of(vertices: list[Any], faces: list[list[int]]) -> list[Triangle]:
    """The faces as triangles with the same vertices, each running as its face does: ears are cut
    off, in fractions. No edge of a face gets or loses a vertex: a closed surface stays closed."""
    points = [tuple(Fraction(x) for x in vertex) for vertex in vertices]
    return [triangle for face in faces for triangle in _ears(points, face)]


def _ears(points: list[tuple[Fraction, ...]], face: list[int]) -> list[Triangle]:
    if len(face) == 3:
        return [(face[0], face[1], face[2])]
    flat = dict(zip(face, _projected([points[i] for i in face]), strict=True))
    left, triangles = list(face), []
    while len(left) > 3:
        at = next((k for k in range(len(left)) if _is_ear(flat, left, k)), 0)
        triangles.append((left[at - 1], left[at], left[(at + 1) % len(left)]))
        del left[at]
    return [*triangles, (left[0], left[1], left[2])]


def _projected(ring: list[tuple[Fraction, ...]]) -> list[Plane]:
    """The ring in a coordinate plane, counter-clockwise."""
    areas = [_area([_without(p, axis) for p in ring]) for axis in range(3)]
    axis = max(range(3), key=lambda i: abs(areas[i]))
    flat = [_without(p, axis) for p in ring]
    return flat if areas[axis] > 0 else [(y, x) for x, y in flat]


def _without(p: tuple[Fraction, ...], axis: int) -> Plane:
    return p[(axis + 1) % 3], p[(axis + 2) % 3]


def _area(ring: list[Plane]) -> Fraction:
    pairs = zip(ring[-1:] + ring, ring, strict=False)
    return sum((a[0] * b[1] - b[0] * a[1] for a, b in pairs), Fraction())


def _turn(a: Plane, b: Plane, c: Plane) -> Fraction:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _is_ear(flat: dict[int, Plane], left: list[int], at: int) -> bool:
    """Whether the corner turns left and no other vertex lies within its triangle."""
    corner = [flat[left[at - 1]], flat[left[at]], flat[left[(at + 1) % len(left)]]]
    a, b, c = corner
    if _turn(a, b, c) <= 0:
        return False
    others = (flat[i] for i in left)
    return not any(
        p not in corner and min(_turn(a, b, p), _turn(b, c, p), _turn(c, a, p)) >= 0 for p in others
    )
