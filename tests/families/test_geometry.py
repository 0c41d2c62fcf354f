"""The plain geometry of fuzz/geometry stands alone, and answers as the definitions do."""

from __future__ import annotations

import ast
import sys
from fractions import Fraction
from pathlib import Path
from random import Random

import pytest
from minkref.fuzz.geometry import plane, space

SQUARE = plane.box(0, 0, 4, 4)
FRAME = [SQUARE, plane.box(1, 1, 2, 2)[::-1]]
TEXT = (
    '{"polygons":[{"outer":[["0","0"],["1/2","0"],["0","3"]],"holes":[]},'
    '{"outer":[["5","5"],["9","5"],["9","9"],["5","9"]],'
    '"holes":[[["6","6"],["6","7"],["7","7"]]]}]}'
)


@pytest.mark.parametrize("module", [plane, space], ids=["plane", "space"])
def test_it_imports_the_standard_library_alone(module: object) -> None:
    tree = ast.parse(Path(str(module.__file__)).read_text(encoding="utf-8"))  # type: ignore[attr-defined]
    for node in ast.walk(tree):
        names = [each.name for each in node.names] if isinstance(node, ast.Import) else []
        names += [node.module or "."] if isinstance(node, ast.ImportFrom) else []
        assert all(name.split(".")[0] in sys.stdlib_module_names for name in names), names


def test_a_text_is_read_scaled_and_then_moved() -> None:
    shape = plane.read_shape(TEXT, Fraction(2), (Fraction(1), Fraction(-1)))
    assert shape[0] == [[(1, -1), (2, -1), (1, 5)]]
    assert [len(ring) for ring in shape[1]] == [4, 3]
    assert plane.written_rings(TEXT)[2] == [["6", "6"], ["6", "7"], ["7", "7"]]
    assert plane.fraction_rings(TEXT, 2)[0] == [(0, 0), (1, 0), (0, 6)]


def test_the_product_of_vectors_has_the_sign_of_the_turn() -> None:
    dice = Random(8)
    for _ in range(200):
        a, b, c = ((dice.randint(-3, 3), dice.randint(-3, 3)) for _ in range(3))
        area = plane.cross(plane.minus(b, a), plane.minus(c, b))
        assert area == plane.doubled_area([a, b, c])
        assert (area > 0) - (area < 0) == plane.turn(a, b, c)
    assert plane.plus((1, 2), (3, -5)) == (4, -3)
    assert plane.dot((1, 2), (3, -5)) == -7


@pytest.mark.parametrize(
    ("point", "within"),
    [((Fraction(1, 2), 2), True), ((2, 2), False), ((1, 2), True), ((4, 4), True), ((5, 4), False)],
    ids=["between", "in the hole", "on the hole", "at a corner", "outside"],
)
def test_a_frame_is_closed_and_its_hole_open(point: plane.Point, within: bool) -> None:
    assert plane.contains([FRAME], point) is within


def test_areas_have_the_sense_of_the_ring() -> None:
    assert plane.doubled_area(SQUARE) == 32
    assert plane.doubled_area(SQUARE[::-1]) == -32
    assert plane.doubled_area([(0, 0), (Fraction(1, 3), 0), (0, 1)]) == Fraction(1, 3)


def test_lines_of_whole_numbers_cross_in_fractions() -> None:
    seed = 7
    dice = Random(seed)
    for _ in range(200):
        a, b, c, d = ((dice.randint(-9, 9), dice.randint(-9, 9)) for _ in range(4))
        if (b[0] - a[0]) * (d[1] - c[1]) == (b[1] - a[1]) * (d[0] - c[0]):
            continue
        x = plane.crossing(a, b, c, d)
        assert plane.turn(a, b, x) == plane.turn(c, d, x) == 0, (seed, a, b, c, d)
        assert all(isinstance(number, Fraction) for number in x), (seed, a, b, c, d)


def test_segments_meet_on_a_lattice_where_the_boundaries_say_so() -> None:
    """Compares all pairs of segments and points on a four by four lattice with the crossing of
    lines."""
    nodes = [(x, y) for x in range(4) for y in range(4)]
    segments = [(a, b) for a in nodes for b in nodes if a <= b]
    for a, b in segments[::3]:
        for c, d in segments:
            assert plane.segments_meet(a, b, c, d) == _share_a_point(a, b, c, d), (a, b, c, d)


def _share_a_point(a: plane.Point, b: plane.Point, c: plane.Point, d: plane.Point) -> bool:
    u, v = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1])
    if u[0] * v[1] != u[1] * v[0]:
        at = plane.crossing(a, b, c, d)
        return plane.in_box(a, b, at) and plane.in_box(c, d, at)
    ends = [(p, a, b) for p in (c, d)] + [(p, c, d) for p in (a, b)]
    return any(plane.turn(q, r, p) == 0 and plane.in_box(q, r, p) for p, q, r in ends)
