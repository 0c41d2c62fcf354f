"""Finds the part of a face that lies within an exact sum's boundary."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import (
    Whole,
    cross,
    denominator_of,
    dot,
    minus,
    normal,
    primitive,
    whole,
)
from minkref.fuzz.space.face_pieces import Plane, Polygon, Triangle, halves, heights, polygon_of


@dataclass(frozen=True)
class Patch:
    """A convex face of the sum in its plane: the plane's points below all `sides`."""

    sides: tuple[Plane, ...]


class SumFaces:
    """`left` returns the parts of coplanar polygons off the sum's boundary. Lengths count parts of
    a unit, `unit` parts each. Exact."""

    def __init__(self, sum: Polyhedron, unit: int) -> None:
        self._unit = unit
        self._patches: dict[tuple[Whole, Fraction], list[Patch]] = defaultdict(list)
        for face in sum.faces:
            n, offset, patch = self._patch(sum, face)
            self._patches[n, offset].append(patch)

    def left(self, triangle: Triangle, parts: list[Polygon]) -> list[Polygon]:
        """Returns the pieces of `parts` off the boundary; the triangle's corners use the unit."""
        n = primitive(normal(*triangle))
        offset = Fraction(dot(n, triangle[0]), self._unit)
        opposite = (-n[0], -n[1], -n[2])
        for patch in (*self._at(n, offset), *self._at(opposite, -offset)):
            parts = [piece for part in parts for piece in _less(part, patch)]
            if not parts:
                break
        return parts

    def hold(self, triangle: Triangle) -> bool:
        """Whether the boundary contains the whole triangle."""
        return not self.left(triangle, [polygon_of(triangle)])

    def _at(self, n: Whole, offset: Fraction) -> list[Patch]:
        return self._patches.get((n, offset), [])

    def _patch(self, sum: Polyhedron, face: Face) -> tuple[Whole, Fraction, Patch]:
        ring = [sum.vertices[k] for k in face]
        unit = denominator_of(ring)
        corners = [whole(point, unit) for point in ring]
        n = primitive(normal(*corners[:3]))
        sides = []
        for a, b in zip(corners, corners[1:] + corners[:1], strict=True):
            outward = cross(minus(b, a), n)
            # outward x = d for x in lengths of 1 / unit: both sides times the factor that clears
            # the units.
            m = (outward[0] * unit, outward[1] * unit, outward[2] * unit)
            sides.append((m, dot(outward, a) * self._unit))
        return n, Fraction(dot(n, corners[0]), unit), Patch(tuple(sides))


def _less(part: Polygon, patch: Patch) -> list[Polygon]:
    """A convex polygon without the patch, in convex pieces."""
    whole_part, gone = part, []
    for side in patch.sides:
        above = heights(part, side)
        if max(above) <= 0:
            continue
        if min(above) >= 0:
            return [whole_part]
        part, outside = halves(part, above)
        gone.append(outside)
    return gone
