"""The sum of general polyhedra by convex pieces, through Python."""

from __future__ import annotations

import hashlib
from fractions import Fraction

import pytest
from minkref import _core

ONE = ("1", "1", "1")
BOX_FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


def box(low: tuple[int, int, int], high: tuple[int, int, int]) -> _core.Polyhedron:
    corners = [
        tuple((low, high)[bit][k] for k, bit in enumerate(bits))
        for bits in ((x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1))
    ]
    return _core.Polyhedron(corners, BOX_FACES)


def hollow(outer: _core.Polyhedron, inner: _core.Polyhedron) -> _core.Polyhedron:
    """Outer without inner, which lies inside it."""
    first = outer.vertices
    faces = [[v + first for v in reversed(ring)] for ring in inner.rings()]
    return _core.Polyhedron(outer.points() + inner.points(), outer.rings() + faces)


def test_a_cavity_shrinks_and_is_filled() -> None:
    shell, cube = (
        hollow(box((0, 0, 0), (3, 3, 3)), box((1, 1, 1), (2, 2, 2))),
        box((0,) * 3, (1,) * 3),
    )
    shell.validate()
    assert len(_core.convex_pieces(shell)) == 6
    for scale in (Fraction(1), Fraction(3, 2), Fraction(7, 3)):
        found = _core.definition_sum_in_space(shell, cube, (str(scale),) * 3)
        cavity = max(scale - 1, Fraction(0))
        assert Fraction(found.volume()) == (3 * scale + 1) ** 3 - cavity**3
        assert found.planes == (12 if cavity else 6)


def test_the_canonical_text_of_a_cube() -> None:
    cube = box((0, 0, 0), (1, 1, 1))
    found = _core.definition_sum_in_space(cube, cube, ("1/2", "1", "2"))
    text = found.canonical_json()
    assert text.startswith(
        '{"planes":[{"normal":["-1","0","0"],"offset":"0","region":{"polygons":[{"holes":[],'
        '"outer":[["0","0"],["2","0"],["2","3"],["0","3"]]}]}},'
    )
    other = _core.definition_sum_in_space(cube, cube.scaled(("1/2", "1", "2")), ONE)
    assert found == other and hash(found) == hash(other)
    assert (
        hashlib.sha256(text.encode()).digest()
        == hashlib.sha256(other.canonical_json().encode()).digest()
    )
    assert found != _core.definition_sum_in_space(cube, cube, ONE)


def test_points_and_segments_and_what_is_refused() -> None:
    cube = box((0, 0, 0), (1, 1, 1))
    point, nothing = _core.Polyhedron([(1, 2, 3)], []), _core.Polyhedron([], [])
    segment = _core.Polyhedron([(0, 0, 0), (1, 1, 1)], [])
    assert _core.definition_sum_in_space(cube, point, ONE).volume() == "1"
    assert _core.definition_sum_in_space(cube, segment, ONE).volume() == "4"
    assert _core.definition_sum_in_space(cube, nothing, ONE).is_empty
    with pytest.raises(_core.BadInput) as refusal:
        _core.definition_sum_in_space(point, segment, ONE)
    assert refusal.value.code == "degenerate-operands"
    with pytest.raises(_core.BadInput) as refusal:
        _core.definition_sum_in_space(cube, cube, ("1", "0", "1"))
    assert refusal.value.code == "bad-scale"
