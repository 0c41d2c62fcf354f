"""Finds faces that bound a result, although no face of the sum can lie there."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Whole
from minkref.fuzz.space.covered_faces import CoveredFaces
from minkref.fuzz.space.face_pieces import Polygon, Triangle, inside, pieces
from minkref.fuzz.space.membership import Surface
from minkref.fuzz.space.sides import both_sides

PLACES = 3  # tried per piece of a face that bounds the set
# The sum's boundary may pass between the two points; then they move closer.
SHRINKS = (Fraction(1), Fraction(1, 1 << 8), Fraction(1, 1 << 24), Fraction(1, 1 << 60))


class TooMany(Exception):
    """The triangles cut each other into more pieces than can be looked at."""


def changes(
    whole: Polyhedron,
    result: Polyhedron,
    surface: Surface,
    stray: Sequence[int],
    most: int,
    off_boundary: Callable[[Triangle, list[Polygon]], list[Polygon]] | None = None,
) -> Iterator[tuple[Point, Point]]:
    """Yields pairs of points on both sides of these triangles of `result`, one point inside the set
    with positive winding number and one outside, some for each piece of a triangle that separates
    inside from outside. Without pairs, no triangle bounds the set anywhere. `whole` is the result
    with opposite faces; `off_boundary` returns the parts of a triangle that need examination.
    TooMany beyond `most` pieces."""
    covered = CoveredFaces(whole)
    left = {}
    for number in stray:
        parts = covered.left(result.triangles[number])
        if off_boundary is not None:
            parts = off_boundary(surface.triangles[number], parts)
        if parts:
            left[number] = parts
    unit = surface.denominator
    for number, parts in left.items():
        yield from _change(surface, inside(parts[0], unit), surface.normals[number])
    count = 0
    for number, parts in left.items():
        near = [surface.triangles[k] for k in surface.near(number)]
        cut = pieces(parts, surface.normals[number], near)
        count += len(cut)
        if count > most:
            raise TooMany(f"triangles off the boundary of the sum have more than {most:,} pieces")
        for piece in cut:
            dice = random.Random(number)
            for _ in range(PLACES):
                place = inside(piece + [dice.choice(piece) for _ in range(2)], unit)
                points = list(_change(surface, place, surface.normals[number]))
                yield from points
                if not points:  # nor at another place in the piece
                    break


def _change(surface: Surface, place: Point, n: Whole) -> Iterator[tuple[Point, Point]]:
    outer, inner = both_sides(surface, place, n)
    above, below = surface.winding(outer), surface.winding(inner)
    if ((above or 0) > 0) != ((below or 0) > 0):
        for shrink in SHRINKS:
            yield _towards(place, outer, shrink), _towards(place, inner, shrink)


def _towards(a: Point, b: Point, t: Fraction) -> Point:
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]))
