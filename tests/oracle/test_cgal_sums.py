"""CGAL's sums arrive exactly as CGAL made them, right or wrong."""

from __future__ import annotations

import json
from fractions import Fraction

import pytest
from minkref.fuzz.cgal.oracle import METHOD_GROUPS, METHODS_WITH_HOLES, cgal_version
from minkref.fuzz.geometry.plane import meet

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
KNOWN_FAULTY = ("5.5.1", "6.0.1")


def box(left, low, right, high):
    return [(left, low), (right, low), (right, high), (left, high)]


def hole(left, low, right, high):
    return box(left, low, right, high)[::-1]


def rings(answer):
    """Outer ring and holes, without collinear vertices, from the smallest vertex on."""
    assert answer.status == "result", answer
    (polygon,) = json.loads(answer.rings_json)["polygons"]
    return [merged(ring) for ring in (polygon["outer"], *polygon["holes"])]


def merged(ring):
    points = [(Fraction(x), Fraction(y)) for x, y in ring]
    kept = [
        b
        for a, b, c in zip(points[-1:] + points[:-1], points, points[1:] + points[:1], strict=True)
        if (b[0] - a[0]) * (c[1] - b[1]) != (b[1] - a[1]) * (c[0] - b[0])
    ]
    start = kept.index(min(kept))
    return kept[start:] + kept[:start]


@pytest.mark.parametrize("method", METHOD_GROUPS)
def test_a_square_of_a_third_and_a_triangle_give_their_exact_pentagon(oracle, polygon, method):
    third = Fraction(1, 3)
    P = polygon(box(0, 0, third, third))
    Q = polygon([(0, 0), (Fraction(1, 7), 0), (0, Fraction(1, 7))])
    far = third + Fraction(1, 7)
    expected = [(0, 0), (far, 0), (far, third), (third, far), (0, far)]
    assert rings(oracle(method).sum(P, Q)) == [expected]


@pytest.mark.parametrize("method", METHOD_GROUPS)
def test_numbers_of_hundreds_of_digits_are_not_rounded(oracle, polygon, method):
    big, tiny = 7**300, Fraction(1, 3**300)
    P = polygon(box(big, -big, big + tiny, -big + 1))
    assert rings(oracle(method).sum(P, polygon(SQUARE))) == [
        box(big, -big, big + tiny + 1, -big + 2)
    ]


def test_numbers_beyond_the_range_of_doubles_pass_the_border(oracle, polygon):
    big = 10**320
    P = polygon(box(0, 0, big, big))
    assert rings(oracle("full").sum(P, polygon(SQUARE))) == [box(0, 0, big + 1, big + 1)]


@pytest.mark.parametrize("method", METHOD_GROUPS)
def test_non_convex_operands_leave_a_hole(oracle, polygon, method):
    # A 10 x 10 frame with a slot 1 wide, closed again by a 2 x 2 square.
    frame = [(0, 0), (10, 0), (10, 10), (6, 10), (6, 9), (9, 9), (9, 1), (1, 1), (1, 9), (5, 9)]
    P = polygon([*frame, (5, 10), (0, 10)])
    outer, inner = rings(oracle(method).sum(P, polygon(box(0, 0, 2, 2))))
    assert outer == box(0, 0, 12, 12)
    assert inner == hole(3, 3, 9, 9)[3:] + hole(3, 3, 9, 9)[:3]


@pytest.mark.parametrize("method", METHODS_WITH_HOLES)
@pytest.mark.parametrize("raw", [False, True])
def test_a_hole_shrinks_by_the_other_operand(oracle, polygon, method, raw):
    P = polygon(box(0, 0, 30, 30), hole(10, 10, 20, 20))
    for pair in ((P, polygon(SQUARE)), (polygon(SQUARE), P)):
        outer, inner = rings(oracle(method, raw=raw).sum(*pair))
        assert outer == box(0, 0, 31, 31)
        assert set(inner) == set(hole(11, 11, 20, 20))


@pytest.mark.parametrize("method", ["reduced", "vertical", "triangulation"])
def test_the_hole_that_cgal_5_5_loses(oracle, lost_hole, method):
    P, Q = lost_hole
    x = (Fraction(37, 5), Fraction(14))
    numbers = [
        [[(Fraction(u), Fraction(v)) for u, v in ring] for ring in (p["outer"], *p["holes"])]
        for p in (P["polygons"][0], Q["polygons"][0])
    ]
    reflected = [[(x[0] - u, x[1] - v) for u, v in ring] for ring in numbers[1]]
    assert not meet([numbers[0]], [reflected]), "x is outside the sum by definition"
    holes = rings(oracle(method).sum(P, Q))[1:]
    lost = method == "reduced" and cgal_version(method).startswith("5.5")
    assert len(holes) == (0 if lost else 1)


def test_the_full_convolution_of_an_antenna_crashes(oracle, polygon):
    version = cgal_version("full")
    if version not in KNOWN_FAULTY:
        pytest.skip(f"known of CGAL {', '.join(KNOWN_FAULTY)}; this is {version}")
    P = polygon([(1, 2), (0, 1), (2, 0), (3, 0), (3, 3), (0, 2)])
    Q = polygon([(3, 3), (2, 2), (0, 2), (2, 1)])
    adder = oracle("full")
    answer = adder.sum(P, Q)
    assert (answer.status, answer.signal) == ("crashed", "SIGSEGV")
    assert rings(adder.sum(polygon(SQUARE), polygon(SQUARE))) == [box(0, 0, 2, 2)]


@pytest.mark.parametrize("method", METHODS_WITH_HOLES)
def test_cgal_loses_a_hole_where_its_boxes_of_doubles_are_rounded(oracle, polygon, method):
    version = cgal_version(method)
    if version not in KNOWN_FAULTY:
        pytest.skip(f"known of CGAL {', '.join(KNOWN_FAULTY)}; this is {version}")
    P = polygon(box(0, 0, 30, 30), hole(10, 10, 20, 20))
    far = 2**60 + 1  # no double
    answer = oracle(method).sum(P, polygon(box(far, 0, far + 1, 1)))
    assert answer.removed_holes == 0
    assert rings(answer) == [box(far, 0, far + 31, 31)], "right has the hole of 9 x 9 as well"


TWO = {"polygons": [{"outer": [["0", "0"], ["1", "0"], ["0", "1"]], "holes": []}] * 2}
POINT = {"polygons": [{"outer": [["0", "0"]], "holes": []}]}
SEGMENT = {"polygons": [{"outer": [["0", "0"], ["1", "0"]], "holes": []}]}


@pytest.mark.parametrize("method", METHOD_GROUPS)
@pytest.mark.parametrize(
    ("operand", "reason"),
    [
        ({"polygons": []}, "empty set"),
        (TWO, "2 polygons"),
        (POINT, "a point"),
        (SEGMENT, "a segment"),
    ],
    ids=["empty", "two", "point", "segment"],
)
def test_an_operand_that_cgal_does_not_take_is_skipped(oracle, polygon, method, operand, reason):
    adder = oracle(method)
    for name, pair in (("P", (operand, polygon(SQUARE))), ("Q", (polygon(SQUARE), operand))):
        answer = adder.sum(*pair)
        assert answer.status == "skipped"
        assert answer.reason.startswith(f"{name}: ") and reason in answer.reason


@pytest.mark.parametrize("method", sorted(set(METHOD_GROUPS) - set(METHODS_WITH_HOLES)))
def test_a_method_without_holes_skips_them_even_where_they_vanish(oracle, polygon, method):
    P = polygon(box(0, 0, 9, 9), hole(4, 4, 5, 5))
    answer = oracle(method).sum(P, polygon(box(0, 0, 5, 5)))
    assert answer.status == "skipped" and "holes" in answer.reason


@pytest.mark.parametrize(
    ("holes", "which"),
    [
        ([[(0, 0), (2, 4), (4, 2)]], "rings 0 and 1"),  # a vertex on a vertex
        ([[(0, 5), (2, 6), (2, 4)]], "rings 0 and 1"),  # a vertex on an edge
        ([hole(1, 1, 4, 4), hole(4, 2, 6, 3)], "rings 1 and 2"),  # along an edge
        ([hole(1, 1, 4, 4), hole(6, 1, 8, 4), [(2, 5), (7, 6), (7, 4)]], "rings 2 and 3"),
    ],
    ids=["vertices", "vertex and edge", "edges", "holes"],
)
def test_rings_that_touch_are_skipped(oracle, polygon, holes, which):
    P = polygon(box(0, 0, 10, 10), *holes)
    answer = oracle("reduced").sum(P, polygon(SQUARE))
    assert answer.status == "skipped" and which in answer.reason


def test_rings_a_hair_apart_are_not_skipped(oracle, polygon):
    hair = Fraction(1, 10**40)
    P = polygon(box(0, 0, 10, 10), hole(hair, 4, 6, 6))
    assert oracle("reduced").sum(P, polygon(SQUARE)).status == "result"


def test_a_ring_that_visits_a_vertex_twice_is_skipped(oracle, polygon):
    bow = [(0, 0), (2, 0), (1, 1), (2, 2), (0, 2), (1, 1)]
    answer = oracle("reduced").sum(polygon(bow), polygon(SQUARE))
    assert answer.status == "skipped" and "ring 0 repeats a vertex" in answer.reason


@pytest.mark.parametrize(
    ("outer", "holes", "reason"),
    [
        (hole(0, 0, 9, 9), [], "ring 0 is clockwise"),
        (box(0, 0, 9, 9), [box(2, 2, 5, 5)], "ring 1 is counter-clockwise"),
        ([(0, 0), (1, 1), (2, 2)], [], "ring 0 has no area"),
    ],
)
def test_a_ring_turned_the_wrong_way_is_refused(oracle, polygon, outer, holes, reason):
    answer = oracle("reduced").sum(polygon(outer, *holes), polygon(SQUARE))
    assert answer.status == "errored" and reason in answer.reason
