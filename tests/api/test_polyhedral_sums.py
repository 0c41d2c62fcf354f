"""Sums of general polyhedra through Python."""

from __future__ import annotations

import copy
from fractions import Fraction
from typing import Any

import minkref
import pytest

RING = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


def prism(ring: list[Any], height: Any = 1) -> minkref.Polyhedron:
    n = len(ring)
    corners = [(x, y, z) for z in (0, height) for x, y in ring]
    walls = [[k, (k + 1) % n, n + (k + 1) % n, n + k] for k in range(n)]
    return minkref.Polyhedron(corners, [list(reversed(range(n))), list(range(n, 2 * n)), *walls])


ANGLE, CUBE = prism(RING), prism(SQUARE)


def test_a_sum_is_a_value() -> None:
    found = minkref.polyhedral_sum(ANGLE, CUBE, 2)
    again = minkref.polyhedral_sum(ANGLE.scaled(("2", "2", "2")), CUBE, route="definition")
    assert found == again and hash(found) == hash(again)
    assert copy.deepcopy(found) == found != minkref.polyhedral_sum(ANGLE, CUBE)
    assert found.volume() == str((25 - 4) * 3)
    assert (found.planes, found.is_empty, found.convex()) == (8, False, None)
    assert repr(found) == "<PolyhedralSet: faces in 8 planes>"


def test_the_number_of_threads_changes_nothing() -> None:
    found = [minkref.polyhedral_sum(ANGLE, ANGLE, "3/7", threads=n) for n in (1, 2, 5)]
    assert found[0] == found[1] == found[2]
    assert minkref.polyhedral_sum(ANGLE, ANGLE, "3/7", "definition") == found[0]


def test_a_convex_sum_is_that_of_the_convex_route() -> None:
    bodies = minkref.ConvexPolyhedron(CUBE), minkref.ConvexPolyhedron(prism(RING[:3], "1/3"))
    scaling = (Fraction(1, 2), 3, "0.75")
    expected = minkref.convex_sum(*bodies, scaling).surface
    found = minkref.polyhedral_sum(*bodies, scaling)
    convex = found.convex()
    assert convex is not None and convex.surface().canonical_json() == expected.canonical_json()
    assert found == minkref.PolyhedralSet(expected)


def test_planes_segments_points_and_nothing() -> None:
    flat = minkref.Polyhedron([(x, y, 0) for x, y in RING], [list(range(6))])
    assert minkref.polyhedral_sum(flat, CUBE).volume() == "8"
    segment = minkref.Polyhedron([(0, 0, 0), (0, 0, 1)], [])
    assert minkref.polyhedral_sum(segment, ANGLE).volume() == "6"
    point = minkref.Polyhedron([(1, 2, 3)], [])
    assert minkref.polyhedral_sum(ANGLE, point) != minkref.PolyhedralSet(ANGLE)
    moved = ANGLE.translated(("1", "2", "3"))
    assert minkref.polyhedral_sum(ANGLE, point) == minkref.PolyhedralSet(moved)
    assert minkref.polyhedral_sum(ANGLE, minkref.Polyhedron([], [])).is_empty


def test_what_is_no_operand_is_refused() -> None:
    flat = minkref.Polyhedron([(x, y, 0) for x, y in RING], [list(range(6))])
    with pytest.raises(minkref.BadInput) as error:
        minkref.polyhedral_sum(flat, flat)
    assert error.value.code == "degenerate-operands"
    with pytest.raises(minkref.BadInput) as error:
        minkref.polyhedral_sum(flat, CUBE, route="definition")
    assert error.value.code == "open-mesh"
    with pytest.raises(minkref.BadInput) as error:
        minkref.polyhedral_sum(CUBE, CUBE, (1, 0, 1))
    assert error.value.code == "bad-scale"
    with pytest.raises(minkref.Refusal, match="no route"):
        minkref.polyhedral_sum(CUBE, CUBE, route="traversal")
    inside_out = minkref.Polyhedron(CUBE.points(), [ring[::-1] for ring in CUBE.rings()])
    for wrong in (inside_out, minkref.Polyhedron(CUBE.points(), CUBE.rings()[1:])):
        with pytest.raises(minkref.BadInput):
            minkref.polyhedral_sum(CUBE, wrong)
        with pytest.raises(minkref.BadInput):
            minkref.PolyhedralSet(wrong)
