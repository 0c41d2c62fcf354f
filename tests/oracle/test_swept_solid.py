"""The swept solid: its vertices' heights are scales at which the sum's boundary changes."""

from __future__ import annotations

from fractions import Fraction

import pytest
from minkref import _core
from minkref.fuzz.cgal.executables import OracleNotFoundError
from minkref.fuzz.cgal.swept_solid import SweptSolid
from minkref.fuzz.plane.families.random_pairs import random_pair
from thoroughness import draws

UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]
LOW, HIGH = "101/1009", "1009/101"  # no events of small integer operands


@pytest.fixture(scope="module")
def solid():
    try:
        with SweptSolid() as found:
            yield found
    except OracleNotFoundError as error:
        pytest.skip(str(error))


def scales(answer):
    assert answer.status == "result", answer.reason
    return sorted({vertex.s for vertex in answer.vertices})


def test_a_solid_of_two_squares_has_no_vertex_between_its_ends(solid, polygon):
    assert scales(solid.vertices(polygon(UNIT), polygon(UNIT), "1/2", "3")) == []


def test_a_hole_that_dies_in_a_point_leaves_a_vertex_at_its_scale(solid, polygon):
    """Three edges become concurrent; no pair of them begins or ceases to meet."""
    P = polygon([(-3, -2), (4, -1), (1, 3)])
    Q = polygon([(-40, -40), (40, -40), (40, 40), (-40, 40)], [(0, 20), (17, -11), (-19, -9)])
    (vertex,) = solid.vertices(P, Q, "1", "5").vertices
    assert (vertex.s, vertex.x, vertex.y) == (
        Fraction(541, 186), Fraction(-59, 186), Fraction(-107, 93),
    )  # fmt: skip


def test_a_hole_that_closes_to_a_segment_leaves_its_two_ends(solid, polygon):
    """Q's 3 x 1 hole shrinks to (3 - s) x (1 - s): at s = 1 a segment from (2, 2) to (4, 2)
    remains."""
    Q = polygon([(0, 0), (5, 0), (5, 3), (0, 3)], [(1, 1), (1, 2), (4, 2), (4, 1)])
    answer = solid.vertices(polygon(UNIT), Q, "1/2", "5")
    assert {(v.s, v.x, v.y) for v in answer.vertices} == {(1, 2, 2), (1, 4, 2)}


def test_a_notch_that_closes_and_rings_that_touch(solid, polygon):
    """Two squares of one operand touch at a corner: P no longer slides between them for s > 0; the
    fork's notch, 1 wide, is closed from s = 1 on."""
    fork = polygon([(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)])
    assert scales(solid.vertices(polygon(UNIT), fork, "1/2", "5")) == [1]
    touching = {"polygons": polygon(UNIT)["polygons"] + polygon(
        [(1, 1), (2, 1), (2, 2), (1, 2)])["polygons"]}  # fmt: skip
    assert scales(solid.vertices(polygon(UNIT), touching, "1/2", "5")) == []


@pytest.mark.parametrize(
    ("P", "reason"),
    [
        ({"polygons": []}, "no area"),
        ({"polygons": [{"outer": [["0", "0"], ["1", "1"]]}]}, "no area"),
        ({"polygons": [{"outer": [[str(i), str(i * i)] for i in range(40)]}]}, "38 pairs"),
    ],
)
def test_what_it_leaves_out_it_says(solid, polygon, P, reason):
    answer = solid.vertices(P, polygon([(0, 0), (1, 0), (0, 1)]), "1", "2")
    assert answer.status == "skipped" and reason in answer.reason


@pytest.mark.parametrize(("low", "high"), [("2", "1"), ("1", "1"), ("-1", "1"), ("x", "1")])
def test_scales_that_are_no_window_are_refused(solid, polygon, low, high):
    assert solid.vertices(polygon(UNIT), polygon(UNIT), low, high).status == "errored"


def test_the_boundary_events_are_the_heights_of_its_vertices(solid):
    """`minkref events --kind boundary` against the swept solid, on small random pairs."""
    compared = with_holes = heights = 0
    count = draws(8, 40)
    for index in range(count):
        pair = random_pair(11, index)
        answer = solid.vertices(pair.P, pair.Q, LOW, HIGH)
        if answer.status == "skipped":
            continue
        P, Q = _core.PolygonSet.from_json(pair.P), _core.PolygonSet.from_json(pair.Q)
        events = _core.DynamicSum(P, Q, LOW, HIGH).boundary_events()
        assert scales(answer) == sorted({Fraction(s) for s, *_ in events}), pair
        compared += 1
        heights += len(scales(answer))
        with_holes += P.ring_count + Q.ring_count > 2
    assert compared >= 3 * count / 8 and heights > count / 2 and with_holes > 3 * count / 40
