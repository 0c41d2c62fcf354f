"""Triangles of a result that lie within the sum's boundary."""

from __future__ import annotations

from collections.abc import Callable

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Whole, dot
from minkref.fuzz.space.membership import Surface
from minkref.fuzz.space.pair import SpacePair, Truth
from minkref.fuzz.space.sum_faces import SumFaces


def boundary_test(
    pair: SpacePair, surface: Surface, faces: SumFaces | None
) -> Callable[[int], bool]:
    """Returns a test whether a triangle, by its number, lies within the sum's boundary; for cells
    and prisms, within planes that may hold boundary. `faces` belong to an exact sum."""
    if faces is not None:
        return lambda number: faces.hold(surface.triangles[number])
    if pair.truth is Truth.CELLS:
        return _on_grid(surface, pair.cell_sum.unit)
    if pair.truth is Truth.PRISM:
        return lambda number: _is_upright_or_level(surface.normals[number])
    return _on_hull(surface, pair.hull)


def _on_grid(surface: Surface, unit: Point) -> Callable[[int], bool]:
    steps = [number * surface.denominator for number in unit]

    def test(number: int) -> bool:
        n, corner = surface.normals[number], surface.triangles[number][0]
        axes = [k for k in range(3) if n[k]]
        return len(axes) == 1 and (corner[axes[0]] / steps[axes[0]]).denominator == 1

    return test


def _is_upright_or_level(n: Whole) -> bool:
    return n[2] == 0 or (n[0] == 0 and n[1] == 0)


def _on_hull(surface: Surface, hull: Polyhedron) -> Callable[[int], bool]:
    """Returns a test whether the triangle lies within a face of the hull: the hull contains its
    corners, and one of the hull's planes holds them all."""
    planes = []
    for face in hull.faces:
        a, b, c = (hull.wholes[index] for index in face[:3])
        n = (
            (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]),
            (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]),
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]),
        )
        planes.append((n, dot(n, a) * surface.denominator))
    sets: dict[Whole, frozenset[int] | None] = {}

    def of_corner(corner: Whole) -> frozenset[int] | None:
        """The planes that hold a corner; None outside the hull."""
        if corner not in sets:
            sides = [dot(n, corner) * hull.denominator - height for n, height in planes]
            inside = max(sides) <= 0
            sets[corner] = frozenset(k for k, s in enumerate(sides) if s == 0) if inside else None
        return sets[corner]

    def test(number: int) -> bool:
        found = [of_corner(corner) for corner in surface.triangles[number]]
        first, second, third = found
        if first is None or second is None or third is None:
            return False
        return bool(first & second & third)

    return test
