"""Polygon sets with fewer holes or more vertices, and their hulls. Exact."""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.geometry.plane import Point, Ring, Shape, hull


def quarter_turn(point: Point) -> Point:
    """Turns by 90 degrees about the origin."""
    return (-point[1], point[0])


def without_holes(shape: Shape) -> Shape:
    """Returns the outer ring of a single polygon; several polygons, which may lie in holes of each
    other, stay unchanged."""
    return [shape[0][:1]] if len(shape) == 1 else shape


def refined(shape: Shape) -> Shape:
    """Puts a vertex at a third of every other edge, in each ring with three or more vertices."""
    return [[_refined(ring) for ring in polygon] for polygon in shape]


def _refined(ring: Ring) -> Ring:
    if len(ring) < 3:
        return ring
    made = []
    for k, (x, y) in enumerate(ring):
        made.append((x, y))
        if k % 2 == 0:
            u, v = ring[(k + 1) % len(ring)]
            made.append((Fraction(2 * x + u) / 3, Fraction(2 * y + v) / 3))
    return made


def hull_of(shape: Shape) -> Shape:
    """The convex hull, counter-clockwise, without collinear vertices; nothing for nothing."""
    points = {point for outer, *_ in shape for point in outer}
    return shape if len(points) < 2 else [[hull(points)]]
