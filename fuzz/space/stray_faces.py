"""Where the faces of a result bound it, although no face of the sum can lie there."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from fractions import Fraction

from minkref.fuzz.space.face_pieces import middle, pieces
from minkref.fuzz.space.integers import Point, Whole
from minkref.fuzz.space.membership import Surface

PLACES = 3  # tried in a piece of a face
# The boundary of the sum may pass between the two points; then they are moved closer.
SHRINKS = (Fraction(1), Fraction(1, 1 << 8), Fraction(1, 1 << 24), Fraction(1, 1 << 60))


class TooMany(Exception):
    """There are more triangles than can be cut by each other."""


def both_sides(surface: Surface, place: Point, n: Whole) -> tuple[Point, Point]:
    """Two points so near a place on a triangle with normal `n` that nothing of the surface lies
    between: on its outer and on its inner side. Neither is on the surface."""
    dice = random.Random(f"side {place}")
    length = max(abs(number) for number in n)
    spread = 0
    while True:
        x, y, z = (Fraction(number + dice.randint(-spread, spread) * length // 64) for number in n)
        if n[0] * x + n[1] * y + n[2] * z > 0:
            t = surface.clear_step(place, (x, y, z))
            if t is not None:
                return (
                    (place[0] + t * x, place[1] + t * y, place[2] + t * z),
                    (place[0] - t * x, place[1] - t * y, place[2] - t * z),
                )
        length = max(length, 64)
        spread += 1


def changes(surface: Surface, stray: Sequence[int], most: int) -> Iterator[tuple[Point, Point]]:
    """Pairs of points on both sides of these triangles, one in the set of positive winding number
    and one not, some for each piece of a triangle that parts the set from the rest. If there are
    none, none of the triangles bounds the set anywhere. TooMany where more than `most` triangles
    would have to be cut."""
    unit = surface.denominator
    for number in stray:
        a, b, c = surface.triangles[number]
        third = 3 * unit
        place = (
            Fraction(a[0] + b[0] + c[0], third),
            Fraction(a[1] + b[1] + c[1], third),
            Fraction(a[2] + b[2] + c[2], third),
        )
        yield from _change(surface, place, surface.normals[number])
    if len(stray) > most:
        raise TooMany(f"{len(stray)} triangles lie off the boundary of the sum")
    for number in stray:
        box = surface.boxes[number]
        near = [
            other
            for k, other in enumerate(surface.triangles)
            if k != number and _boxes_meet(surface.boxes[k], box)
        ]
        for piece in pieces(surface.triangles[number], near):
            dice = random.Random(number)
            corners = [(x / unit, y / unit, z / unit) for x, y, z in piece]
            for _ in range(PLACES):
                place = middle(corners + [dice.choice(corners) for _ in range(2)])
                yield from _change(surface, place, surface.normals[number])


def _change(surface: Surface, place: Point, n: Whole) -> Iterator[tuple[Point, Point]]:
    outer, inner = both_sides(surface, place, n)
    outside, inside = surface.winding(outer), surface.winding(inner)
    if ((outside or 0) > 0) != ((inside or 0) > 0):
        for shrink in SHRINKS:
            yield _towards(place, outer, shrink), _towards(place, inner, shrink)


def _towards(a: Point, b: Point, t: Fraction) -> Point:
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]))


def _boxes_meet(a: Sequence[int], b: Sequence[int]) -> bool:
    return all(a[k] <= b[k + 1] and b[k] <= a[k + 1] for k in (0, 2, 4))
