"""Where the faces of a result bound it, although no face of the sum can lie there."""

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

PLACES = 3  # tried in a piece of a face that bounds the set
# The boundary of the sum may pass between the two points; then they are moved closer.
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
    """Pairs of points on both sides of these triangles of `result`, one in the set of positive
    winding number and one not, some for each piece of a triangle that parts the set from the rest.
    If there are none, none of the triangles bounds the set anywhere. `whole` is the result with
    its opposite faces; `off_boundary` leaves of a triangle and parts of it what has to be looked
    at. TooMany where that is more than `most` pieces."""
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
                if not points:  # nor at any other place of the piece
                    break


def _change(surface: Surface, place: Point, n: Whole) -> Iterator[tuple[Point, Point]]:
    outer, inner = both_sides(surface, place, n)
    above, below = surface.winding(outer), surface.winding(inner)
    if ((above or 0) > 0) != ((below or 0) > 0):
        for shrink in SHRINKS:
            yield _towards(place, outer, shrink), _towards(place, inner, shrink)


def _towards(a: Point, b: Point, t: Fraction) -> Point:
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]))
