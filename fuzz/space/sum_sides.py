"""A result beside the faces of an exact sum: inside of it and outside, and how far off with a
tolerance."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain

from minkref.fuzz.geometry.space import Point, Whole, dot, middle
from minkref.fuzz.space.fault_search import FaultSearch
from minkref.fuzz.space.membership import Surface
from minkref.fuzz.space.sides import both_sides

MOST_FACES = 400  # tests lie beside at most so many faces or triangles
BEYOND = Fraction(17, 16)  # times the tolerance: the least distance for such a test
FARTHER = 16  # times the tolerance
SHARE = Fraction(1, 4096)  # times the sum's size
NEAR_CORNER = 12  # weight of a corner, beside the other corners


def sides_agree(search: FaultSearch) -> bool:
    """Tests next to every connected part inside and outside the sum whether the result is right. If
    so, and if no face bounds the result off the sum's boundary, the result equals the sum. Wrong
    points are tested."""
    truth = search.pair.exact
    both = Surface(search.result.with_faces_of(truth.polyhedron))
    agree = True
    for n, place in truth.sites:
        for point, is_in in zip(both_sides(both, place, n), (False, True), strict=True):
            if ((search.surface.winding(point) or 0) > 0) != is_in:
                agree = False
                search.test(point)
        if len(search.reasons) == 2 or search.refuted:
            break
    search.points += 2 * len(truth.sites)
    return agree


def beside_faces(search: FaultSearch) -> None:
    """Tests points beyond the tolerance on both sides of faces, from the sum and the result, where
    the two differ, until the result is found wrong."""
    truth = search.pair.exact
    known, found = truth.surface, search.surface
    for point in chain(_beside(known, search.tolerance), _beside(found, search.tolerance)):
        search.points += 1
        there, right = found.winding(point), known.winding(point)
        if there is None or right is None or (there > 0) == (right > 0):
            continue
        search.test(point)
        if search.reasons or search.refuted:
            return


def _beside(surface: Surface, tolerance: Fraction) -> Iterator[Point]:
    numbers = range(0, len(surface.triangles), 1 + len(surface.triangles) // MOST_FACES)
    size = max((max(box[1::2]) - min(box[::2]) for box in surface.boxes), default=0)
    near = tolerance * BEYOND
    far = (tolerance * FARTHER, SHARE * size / surface.denominator)
    for number in numbers:
        n = surface.normals[number]
        # Steps along the normal are as long as the plane moves to touch a cube with this half side.
        unit = Fraction(sum(map(abs, n)), dot(n, n))
        centre, *others = _places(surface.triangles[number], surface.denominator)
        for place, steps in ((centre, (near, *far)), *((other, (near,)) for other in others)):
            for step in steps:
                for t in (step * unit, -step * unit):
                    yield (place[0] + t * n[0], place[1] + t * n[1], place[2] + t * n[2])


def _places(triangle: Sequence[Whole], unit: int) -> list[Point]:
    """Returns the triangle's middle, and places near its corners."""
    corners: list[Point] = [
        (Fraction(x, unit), Fraction(y, unit), Fraction(z, unit)) for x, y, z in triangle
    ]
    return [middle(corners), *(middle([*([c] * NEAR_CORNER), *corners]) for c in corners)]
