"""Polygonal tori with rational vertices."""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.generators.circle import circle


def torus(around: int, section: int, radius: Fraction, thickness: Fraction) -> Polyhedron:
    """A torus about the z axis: `around` segments with a polygon of `section` corners, its centre
    at distance `radius`. `thickness` is the radius of the section's circle, less than `radius`.
    Faces are planar trapezoids."""
    ring, profile = circle(around), circle(section)
    vertices: list[Point] = []
    for cx, cy in ring:
        for a, b in profile:
            distance = radius + thickness * a
            vertices.append((distance * cx, distance * cy, thickness * b))
    faces = []
    for i in range(around):
        for j in range(section):
            here, there = i * section, (i + 1) % around * section
            k = (j + 1) % section
            faces.append((here + j, there + j, there + k, here + k))
    return Polyhedron(tuple(vertices), tuple(faces))
