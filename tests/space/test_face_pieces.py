"""Pieces of a face: neighbours divide a face in the same way, whichever way it runs."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import pairwise

import pytest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Whole, cross, dot, minus
from minkref.fuzz.space import membership
from minkref.fuzz.space.face_pieces import Polygon, inside, pieces, polygon_of
from minkref.fuzz.space.hull import convex_hull
from minkref.fuzz.space.membership import Surface
from minkref.fuzz.space.sides import both_sides

PLACES = 4


def overlapping(dice: random.Random, bodies: int, size: int) -> Polyhedron:
    """Hulls of four to six points on a small grid: faces that cross, are coplanar, or stand on each
    other by an edge or a vertex."""
    result = Polyhedron((), ())
    for _ in range(bodies):
        while True:
            points = [
                tuple(Fraction(dice.randrange(size)) for _ in range(3))
                for _ in range(dice.randrange(4, 7))
            ]
            try:
                hull = convex_hull([(x, y, z) for x, y, z in points])
            except ValueError:
                continue
            if len(hull.faces) >= 4:
                break
        result = result.with_faces_of(hull)
    return result


def area(polygon: Polygon, n: Whole) -> Fraction:
    """Twice the area, times the normal's length."""
    points: list[Point] = [
        (Fraction(x, w), Fraction(y, w), Fraction(z, w)) for x, y, z, w in polygon
    ]
    total = Fraction(0)
    for a, b in pairwise(points[1:]):
        total += dot(n, cross(minus(a, points[0]), minus(b, points[0])))
    return total


@pytest.mark.parametrize("few", [4, 64])
@pytest.mark.parametrize(("seed", "size"), [(1, 3), (2, 4), (3, 6), (4, 40)])
def test_the_winding_number_is_one_on_each_side_of_a_piece(
    seed: int, size: int, few: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also tests near planes alone as the bound for steps beside a face, as large surfaces use
    them."""
    monkeypatch.setattr(membership, "FEW", few)
    dice = random.Random(seed)
    for _ in range(4):
        surface = Surface(overlapping(dice, dice.randrange(2, 6), size))
        for number, triangle in enumerate(surface.triangles):
            n, near = surface.normals[number], [surface.triangles[k] for k in surface.near(number)]
            dice.shuffle(near)
            cut = pieces([polygon_of(triangle)], n, near)
            assert sum(area(piece, n) for piece in cut) == area(polygon_of(triangle), n)
            other_way = pieces([polygon_of(triangle)[::-1]], n, near)
            assert len(other_way) == len(cut)
            for piece in cut:
                assert area(piece, n) > 0
                places = [
                    inside([*piece, *dice.choices(piece, k=dice.randrange(12))])
                    for _ in range(PLACES)
                ]
                beside = [tuple(map(surface.winding, both_sides(surface, p, n))) for p in places]
                assert len(set(beside)) == 1, (seed, triangle, piece)


def test_a_triangle_divides_what_it_meets_and_no_more() -> None:
    """A short triangle through one part of a two-part face leaves the other whole; a triangle that
    stands on the face by an edge divides the face, and by a vertex does not."""
    n = (0, 0, 1)
    face: list[Polygon] = [
        [(0, 0, 0, 1), (8, 0, 0, 1), (8, 8, 0, 1)],
        [(0, 0, 0, 1), (8, 8, 0, 1), (0, 8, 0, 1)],
    ]
    through = ((6, 1, -1), (6, 3, -1), (6, 2, 2))
    assert len(pieces(face, n, [through])) == 3
    on_an_edge = ((6, 1, 0), (6, 3, 0), (6, 2, 2))
    assert len(pieces(face, n, [on_an_edge])) == 3
    on_a_vertex = ((6, 1, 0), (6, 3, 1), (6, 2, 2))
    assert pieces(face, n, [on_a_vertex]) == face
    beside = ((-6, 1, -1), (-6, 3, -1), (-6, 2, 2))
    assert pieces(face, n, [beside]) == face
