"""Fits anywhere and traps in space: proofs that are checked here, prisms as the plane has them."""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

import minkref
import pytest
from minkref.fuzz.geometry.space import Point, cross, dot, minus

SEED = 8182
CONTACTS = ("allowed", "forbidden")
Mesh = tuple[list[Any], list[list[int]]]


def prism(outline: Sequence[tuple[Any, Any]], low: Any, high: Any) -> Mesh:
    n = len(outline)
    points = [(Fraction(x), Fraction(y), Fraction(z)) for z in (low, high) for x, y in outline]
    sides = [[k, (k + 1) % n, (k + 1) % n + n, k + n] for k in range(n)]
    return points, [list(range(n - 1, -1, -1)), *sides, list(range(n, 2 * n))]


def box(*sizes: Any) -> Mesh:
    x, y, z = (Fraction(size) / 2 for size in sizes)
    return prism([(-x, -y), (x, -y), (x, y), (-x, y)], -z, z)


def together(*solids: Mesh) -> minkref.Polyhedron:
    points: list[Any] = []
    faces: list[list[int]] = []
    for more, rings in solids:
        faces += [[k + len(points) for k in ring] for ring in rings]
        points += more
    return minkref.Polyhedron(points, faces)


def sheared(mesh: Mesh, dice: random.Random) -> Mesh:
    """Convex bodies stay convex; no face stays parallel to another body's."""
    a, b, c = (Fraction(dice.randint(-3, 3), 4) for _ in range(3))
    points, faces = mesh
    return [(x + a * y + b * z, y + c * z, z + a * y / 2) for x, y, z in points], faces


def octahedron(*sizes: int) -> Mesh:
    points = [
        tuple(Fraction(sign * size) if axis == k else Fraction(0) for axis in range(3))
        for k, size in enumerate(sizes)
        for sign in (1, -1)
    ]
    faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
    return points, faces


def plane_of(points: Sequence[Point], face: Sequence[int]) -> tuple[Point, Fraction]:
    """Twice the area vector, and the offset."""
    first = points[face[0]]
    normal: Point = (Fraction(0), Fraction(0), Fraction(0))
    for a, b in pairwise(face[1:]):
        x = cross(minus(points[a], first), minus(points[b], first))
        normal = (normal[0] + x[0], normal[1] + x[1], normal[2] + x[2])
    return normal, dot(normal, first)


def texts(found: Any) -> list[str]:
    return [str(one) for one in found.ranges]


@pytest.mark.parametrize("contact", CONTACTS)
def test_the_weights_prove_the_largest_fit_into_a_convex_container(contact: str) -> None:
    """The part lies inside at its place, and the weighted conditions sum up to s <= largest."""
    dice = random.Random(SEED)
    notched = prism([(-2, -2), (2, -2), (2, 2), (1, 2), (0, 0), (-1, 2), (-2, 2)], -1, 1)
    for index in range(12):
        sizes = [dice.randint(3, 9) for _ in range(3)]
        outer = sheared(dice.choice((box, octahedron))(*sizes), dice)
        inner = sheared(dice.choice((box(1, 2, 3), octahedron(1, 2, 1), notched)), dice)
        found = minkref.largest_fit(together(inner), together(outer), contact=contact)
        told = f"seed {SEED}, case {index}"
        s, place = found.largest, found.place
        assert s is not None and place is not None, told
        assert (s in found) == (contact == "allowed"), told
        points, faces = outer
        for face in faces:
            n, offset = plane_of(points, face)
            for v in inner[0]:
                assert dot(n, place) + s * dot(n, v) <= offset, told
        total, bound, left = Fraction(0), Fraction(0), [Fraction(0)] * 3
        for support in found.supports:
            n, offset = plane_of(points, faces[support.face])
            assert support.weight > 0
            assert dot(n, inner[0][support.vertex]) == max(dot(n, v) for v in inner[0]), told
            left = [a + support.weight * b for a, b in zip(left, n, strict=True)]
            total += support.weight * dot(n, inner[0][support.vertex])
            bound += support.weight * offset
        assert (left, total, bound) == ([0, 0, 0], 1, s), told


def test_a_cube_in_a_box_is_stopped_by_the_narrowest_side() -> None:
    found = minkref.largest_fit(together(box(1, 1, 1)), together(box(8, 4, 6)))
    assert texts(found) == ["(0, 4]"]
    normals = [plane_of(*_face(box(8, 4, 6), one.face))[0] for one in found.supports]
    assert len(normals) == 2 and all(n[0] == n[2] == 0 for n in normals)


def _face(mesh: Mesh, number: int) -> tuple[list[Any], list[int]]:
    return mesh[0], mesh[1][number]


def test_a_needle_fits_along_the_diagonal_it_has() -> None:
    """A segment of direction (1, 1, 1), in a cube: its length in each direction is the cube's."""
    needle = minkref.Polyhedron([(0, 0, 0), (1, 1, 1)], [])
    assert texts(minkref.largest_fit(needle, together(box(4, 4, 4)))) == ["(0, 4]"]


ROOMS = [(0, 0), (4, 0), (4, 1), (5, 1), (5, 0), (9, 0), (9, 4), (5, 4), (5, 2), (4, 2), (4, 4),
         (0, 4)]  # fmt: skip
ELL = [(0, 0), (7, 0), (7, 3), (3, 3), (3, 8), (0, 8)]
STEPS = [(0, 0), (6, 0), (6, 2), (5, 2), (5, 4), (3, 4), (3, 5), (0, 5)]
SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
KITE = [(-1, 0), (0, -2), (2, 0), (0, 1)]


@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize(("part", "container"), [(SQUARE, ROOMS), (KITE, ELL), (SQUARE, STEPS)])
def test_prisms_fit_as_their_sections_do(
    part: list[Any], container: list[Any], contact: str
) -> None:
    """The plane has another way: an index of the sum of polygons."""
    expected = minkref.largest_fit(
        minkref.PolygonSet(part), minkref.PolygonSet(container), contact=contact
    )
    found = minkref.largest_fit(
        together(prism(part, -1, 1)), together(prism(container, 0, 40)), contact=contact
    )
    assert found.ranges == expected.ranges
    assert found.place is not None and found.largest is not None
    there = minkref.largest_fit(
        together(prism(part, -1, 1)), together(prism(container, 0, 40)), at=found.place
    )
    assert there.largest == found.largest
    [bound] = found.bounds
    assert (bound.event, bound.ends, bound.scale) == ("death", True, found.largest)


#: [0, 8] x [0, 8] with a door of width 2 in the right wall.
ROOM = [(-1, -1), (9, -1), (9, 3), (8, 3), (8, 0), (0, 0), (0, 8), (8, 8), (8, 5), (9, 5), (9, 9),
        (-1, 9)]  # fmt: skip
LID = [(-1, -1), (9, -1), (9, 9), (-1, 9)]


def room() -> minkref.Polyhedron:
    """Walls between a floor and a ceiling, with a slit of 1/2 above and below the walls."""
    half = Fraction(1, 2)
    return together(prism(ROOM, 0, 8), prism(LID, -1, -half), prism(LID, 8 + half, 10))


@pytest.mark.parametrize(("contact", "expected"), [("allowed", "(1, 4]"), ("forbidden", "[1, 4)")])
def test_a_cube_is_trapped_in_a_room_as_a_square_is(contact: str, expected: str) -> None:
    cube = together(prism(SQUARE, -1, 1))
    found = minkref.trapped_scales(cube, room(), (4, 4, 4), contact)
    assert texts(found) == [expected]
    plane = minkref.trapped_scales(
        minkref.PolygonSet(SQUARE), minkref.PolygonSet(ROOM), (4, 4), contact
    )
    assert found.ranges == plane.ranges
    assert [(one.event, one.ends) for one in found.bounds] == [("split", False), ("contact", True)]
    assert {holds for _, holds in found.proofs} == {True, False}
    window = minkref.trapped_scales(cube, room(), (4, 4, 4), contact, 2, 3)
    assert texts(window) == ["[2, 3]"]


def test_a_trapped_part_is_held_on_each_way_out() -> None:
    cube = together(prism(SQUARE, -1, 1))
    trapped = minkref.trapped_scales(cube, room(), (4, 4, 4))
    for way in ([(4, 4, 4), (40, 4, 4)], [(4, 4, 4), (4, 4, 40)]):
        held = minkref.held_scales(cube, room(), way)
        for one in trapped.ranges:
            middle = (one.low + (one.high or one.low)) / 2
            assert middle in held and one.high in held


def test_a_closed_room_traps_all_that_fits() -> None:
    inner = box(6, 6, 6)
    shell = together(box(10, 10, 10), (inner[0], [face[::-1] for face in inner[1]]))
    cube = together(prism(SQUARE, -1, 1))
    assert texts(minkref.trapped_scales(cube, shell, (1, 0, 0))) == ["(0, 2]"]
    assert texts(minkref.trapped_scales(cube, shell, (9, 0, 0))) == []
    assert texts(minkref.trapped_scales(cube, shell, (4, 0, 0))) == []


def test_what_cannot_be_answered_is_refused() -> None:
    cross_section = [(-3, -3), (3, -3), (3, 3), (2, 3), (2, -2), (-2, -2), (-2, 3), (-3, 3)]
    cup = together(prism(cross_section, -1, 1))
    ell = together(prism(ELL, 0, 40))
    with pytest.raises(minkref.BadInput, match="sees all of it") as refused:
        minkref.largest_fit(cup, ell)
    assert refused.value.code == "not-star-shaped"
    with pytest.raises(minkref.BadInput, match="strictly below"):
        minkref.trapped_scales(cup, room(), (4, 4, 4))
    with pytest.raises(minkref.Refusal, match="anywhere"):
        minkref.largest_fit(cup, ell, between=[(0, 0, 0), (1, 1, 1)])  # type: ignore[call-overload]
    assert minkref.largest_fit(cup, together(box(6, 6, 6))).largest == 1
