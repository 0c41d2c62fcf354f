"""The exact distance of a point from a solid's triangles: what a sum with a ball is, by its
definition."""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, cross, dot, minus
from minkref.fuzz.space.membership import Surface


class BallDistance:
    """A solid, a segment or a point, for many questions. Exact. O(n) each."""

    def __init__(self, solid: Polyhedron) -> None:
        self._inside = Surface(solid)
        self._ends = solid.vertices
        self._triangles = [[solid.vertices[k] for k in triple] for triple in solid.triangles]

    def squared(self, x: Point) -> Fraction:
        """The squared distance of a point from the solid; 0 for a point of the solid. The sum with
        a ball of radius R has the points for which this is at most R²."""
        if not self._triangles:
            return _to_segment(x, self._ends[0], self._ends[-1])
        if self._inside.contains(x):
            return Fraction(0)
        return self.squared_from_surface(x)

    def squared_from_surface(self, x: Point) -> Fraction:
        """The squared distance of a point from the solid's boundary. The erosion by a ball of
        radius R has the points inside the solid for which this is at least R²."""
        return min(_to_triangle(x, *corners) for corners in self._triangles)

    def contains(self, x: Point) -> bool:
        return bool(self._triangles) and self._inside.contains(x)


def _to_triangle(x: Point, a: Point, b: Point, c: Point) -> Fraction:
    normal = cross(minus(b, a), minus(c, a))
    sides = ((a, b), (b, c), (c, a))
    if all(dot(cross(minus(q, p), normal), minus(x, p)) <= 0 for p, q in sides):
        return dot(minus(x, a), normal) ** 2 / dot(normal, normal)
    return min(_to_segment(x, p, q) for p, q in sides)


def _to_segment(x: Point, a: Point, b: Point) -> Fraction:
    along, from_a = minus(b, a), minus(x, a)
    length = dot(along, along) or Fraction(1)
    t = min(max(dot(from_a, along) / length, Fraction(0)), Fraction(1))
    rest = minus(from_a, (t * along[0], t * along[1], t * along[2]))
    return dot(rest, rest)
