"""Faces cut into triangles."""

from __future__ import annotations

from fractions import Fraction

import pytest
from minkref.fuzz.adapters.surfaces import triangles_of

RINGS = {
    "square": [(0, 0), (2, 0), (2, 2), (0, 2)],
    "L": [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)],
    "vertices on sides": [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)],
    "triangle with a vertex on a side": [(0, 0), (2, 0), (0, 2), (0, 1)],
    "comb": [(0, 0), (7, 0), (7, 5), (6, 1), (5, 5), (4, 1), (3, 5), (2, 1), (1, 5)],
}
PLACES = {
    "from above": lambda x, y: (x, y, 0),
    "from below": lambda x, y: (y, x, 5),
    "upright": lambda x, y: (0, x, y),
    "aslant": lambda x, y: (x, y, x + 3 * y),
}


def twice_area(points: list[tuple[Fraction, Fraction]]) -> Fraction:
    pairs = zip(points[-1:] + points, points, strict=False)
    return sum((a * d - b * c for (a, b), (c, d) in pairs), Fraction())


@pytest.mark.parametrize("ring", RINGS.values(), ids=RINGS)
@pytest.mark.parametrize("place", PLACES, ids=PLACES)
def test_triangles_cover_the_face_and_keep_its_edges(
    ring: list[tuple[int, int]], place: str
) -> None:
    vertices = [list(PLACES[place](x, y)) for x, y in ring]
    triangles = triangles_of(vertices, [list(range(len(ring)))])
    assert len(triangles) == len(ring) - 2
    flat = [(Fraction(x), Fraction(y)) for x, y in ring]
    areas = [twice_area([flat[i] for i in triangle]) for triangle in triangles]
    assert min(areas) > 0
    assert sum(areas) == twice_area(flat)
    edges = [(t[k - 1], t[k]) for t in triangles for k in range(3)]
    assert len(set(edges)) == len(edges)
    outer = {(a, b) for a, b in edges if (b, a) not in edges}
    assert outer == {(k, (k + 1) % len(ring)) for k in range(len(ring))}
