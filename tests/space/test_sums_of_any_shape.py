"""An exact sum of general polyhedra as the truth: right results pass however they are cut, every
kind of wrong result is found, with a witness."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import pairwise

import pytest
from members import turn
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space import exact_sum as limits
from minkref.fuzz.space.comparison import Comparison, compare
from minkref.fuzz.space.exact_sum import DEFINITION, exposed_sum, polyhedron_of_planes
from minkref.fuzz.space.general_pairs import FAMILIES, OF_PARTS, GeneralPair, general_pair
from minkref.fuzz.space.generators.convex import box, cube
from minkref.fuzz.space.hull import convex_hull
from minkref.fuzz.space.pair import SpacePair, Truth
from minkref.fuzz.space.sites import sites
from minkref.fuzz.space.trapezoids import trapezoids
from minkref.fuzz.space.witness import holds
from minkref.fuzz.verdicts.verdict import Reason
from thoroughness import THOROUGH, draws

SEED = 77
EPS = Fraction(1, 10**9)
COUNT = len(FAMILIES) + len(OF_PARTS)


def in_space(drawn: GeneralPair) -> SpacePair:
    return SpacePair(drawn.P, drawn.Q, drawn.scale, drawn.name)


@cache
def drawn(number: int) -> SpacePair:
    """The pair with the smallest sum among some of the family with this number."""
    pairs = [in_space(general_pair(SEED, number + k * COUNT)) for k in range(draws(2, 3))]
    return min(pairs, key=lambda pair: len(pair.exact.polyhedron.triangles))


def triangles(solid: Polyhedron) -> Polyhedron:
    """The solid's triangles, each with separate vertices."""
    points = [solid.vertices[k] for triple in solid.triangles for k in triple]
    return Polyhedron(tuple(points), tuple((k, k + 1, k + 2) for k in range(0, len(points), 3)))


def fans(solid: Polyhedron) -> Polyhedron:
    """Cuts every face into a fan from an inner point."""
    vertices = list(solid.vertices)
    faces = []
    for face in solid.faces:
        corners = [solid.vertices[k] for k in face]
        x, y, z = (
            sum(((i + 1) * c[k] for i, c in enumerate(corners)), Fraction(0)) for k in range(3)
        )
        whole = sum(range(1, len(face) + 1))
        faces += [(a, b, len(vertices)) for a, b in pairwise((*face, face[0]))]
        vertices.append((x / whole, y / whole, z / whole))
    return Polyhedron(tuple(vertices), tuple(faces))


@pytest.mark.parametrize("number", range(COUNT))
def test_right_results_pass_however_they_are_cut(number: int) -> None:
    pair = drawn(number)
    right = pair.exact.polyhedron
    planes = exposed_sum(pair.P, pair.Q, pair.scale, DEFINITION)
    other = polyhedron_of_planes(planes)
    assert planes.volume() == right.volume == other.volume
    forms = (right, triangles(other), fans(right), right.with_faces_of(fans(right)))
    for form in turn(forms, number % 4, 4):
        answer = compare(pair, form)
        assert (answer.verdict, answer.proven) == ("pass", True), (pair.family, answer)
    if THOROUGH or number % 2:
        assert compare(pair, fans(right), exact=False, tolerance=EPS).verdict == "pass"
    if THOROUGH or number % 2 == 0:
        assert compare(replace(pair, route=DEFINITION), right).proven


def test_a_cell_inside_that_winds_twice_passes() -> None:
    pair = drawn(0)
    right = pair.exact.polyhedron
    n, place = pair.exact.sites[0]
    length = max(abs(k) for k in n)
    x, y, z = (place[k] - Fraction(n[k], 1000 * length) for k in range(3))
    small = cube((x, y, z), Fraction(1, 10**6))
    assert compare(pair, right.with_faces_of(small)).proven
    assert_wrong(pair, right.with_faces_of(small.turned_inside_out()), Reason.MISSING)


def assert_wrong(
    pair: SpacePair, result: Polyhedron, *reasons: Reason, tolerance: Fraction | None = None
) -> Comparison:
    answer = compare(pair, result, tolerance is None, tolerance or Fraction(0))
    assert answer.verdict == "wrong", (pair.family, answer)
    assert answer.witness is not None and holds(pair.P, pair.Q, pair.scale, answer.witness)
    if reasons:
        assert set(answer.reasons) == set(reasons), (pair.family, answer)
    return answer


#: Each family exactly and within a tolerance; each other one, and one of the two in turn, where few
#: are drawn.
WRONG = [
    (number, tolerance)
    for number in range(COUNT)
    for tolerance in (None, EPS)
    if THOROUGH or number % 4 == (1 if tolerance is None else 3)
]


@pytest.mark.parametrize(("number", "tolerance"), WRONG)
def test_wrong_results_are_found(number: int, tolerance: Fraction | None) -> None:
    pair = drawn(number)
    right = pair.exact.polyhedron
    assert_wrong(pair, Polyhedron((), ()), Reason.MISSING, tolerance=tolerance)
    opened = Polyhedron(right.vertices, right.faces[1:])
    assert_wrong(pair, opened, Reason.NOT_CLOSED, tolerance=tolerance)
    assert_wrong(pair, right.turned_inside_out(), tolerance=tolerance)
    x, y, z = right.box[1]
    beyond = cube((x + 1, y, z), Fraction(1, 100))
    assert_wrong(pair, right.with_faces_of(beyond), Reason.EXTRA, tolerance=tolerance)
    offset = (3 * EPS, -3 * EPS, 3 * EPS)
    assert_wrong(pair, right.translated(offset), tolerance=tolerance)
    assert_wrong(pair, with_moved_vertex(right, 20 * EPS), tolerance=tolerance)


def with_moved_vertex(solid: Polyhedron, by: Fraction) -> Polyhedron:
    """Moves the highest vertex of the triangulated solid, and its copies on adjoining faces."""
    top = max(solid.vertices)
    vertices = [(x + by, y, z) if (x, y, z) == top else (x, y, z) for x, y, z in solid.vertices]
    return Polyhedron(tuple(vertices), solid.triangles)


def hollow() -> tuple[SpacePair, Polyhedron, Polyhedron]:
    """A pair whose sum has a cavity, and the sum's two shells."""
    outer = box(point(0, 0, 0), point(6, 5, 7))
    inner = box(point(2, 1, 2), point(5, 4, 4))
    hollowed = outer.with_faces_of(inner.turned_inside_out())
    half = Fraction(1, 2)
    P = cube((Fraction(0), Fraction(0), Fraction(0)), half)
    wedge = Polyhedron((*P.vertices,), P.faces)
    pair = SpacePair(wedge, hollowed, Fraction(1), "hollow")
    whole = box(point(0, 0, 0), (6 + half, 5 + half, 7 + half))
    gap = box((2 + half, 1 + half, 2 + half), point(5, 4, 4))
    return pair, whole, gap


def point(x: int, y: int, z: int) -> Point:
    return Fraction(x), Fraction(y), Fraction(z)


@pytest.mark.parametrize("tolerance", [None, EPS])
def test_cavities_and_shells(tolerance: Fraction | None) -> None:
    pair, outer, gap = hollow()
    right = outer.with_faces_of(gap.turned_inside_out())
    exact = tolerance is None
    assert pair.judged_by is Truth.SUM
    assert compare(pair, right, exact, tolerance or Fraction(0)).proven
    assert_wrong(pair, outer, Reason.EXTRA, tolerance=tolerance)
    assert_wrong(pair, gap, tolerance=tolerance)
    within = cube(point(3, 2, 3), Fraction(1, 4))
    assert_wrong(pair, right.with_faces_of(within), Reason.EXTRA, tolerance=tolerance)
    bubble = cube(point(1, 1, 1), Fraction(1, 8)).turned_inside_out()
    assert_wrong(pair, right.with_faces_of(bubble), Reason.MISSING, tolerance=tolerance)


def test_a_sum_that_takes_too_long_or_is_too_large_is_judged_by_points(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pair, outer, gap = hollow()
    right = outer.with_faces_of(gap.turned_inside_out())
    for name, value, words in (
        ("MOST_TRIANGLES", 10, "more than 10"),
        ("SECONDS", 1e-6, "seconds"),
    ):
        monkeypatch.setattr(limits, name, value)
        limited = replace(pair)
        answer = compare(limited, right)
        assert limited.judged_by is Truth.POINTS
        assert answer.verdict == "pass" and not answer.proven
        assert words in answer.message and "points" in answer.message
        monkeypatch.undo()
    assert compare(replace(pair), right).proven


def test_operands_that_cross_themselves_have_no_exact_sum() -> None:
    one = cube(point(0, 0, 0), Fraction(2))
    crossing = one.with_faces_of(one.translated(point(1, 1, 1)))
    pair = SpacePair(crossing, one, Fraction(1), "crossing")
    assert pair.judged_by is Truth.POINTS and pair.absence is not None


def test_a_claim_about_the_sum_that_a_point_refutes_is_no_finding() -> None:
    """Where our own sum were wrong, the witness would not hold."""
    pair, outer, gap = hollow()
    right = outer.with_faces_of(gap.turned_inside_out())
    for wrong in (outer, right.with_faces_of(cube(point(9, 9, 9), Fraction(1)))):
        spoilt = replace(pair)
        spoilt.__dict__["exact_sum"] = replace(pair.exact, polyhedron=wrong)
        answer = compare(spoilt, right)
        assert answer.verdict == "undecided" and answer.witness is None, answer


def test_trapezoids_cover_a_region_once() -> None:
    def ring(*corners: tuple[int, int]) -> list[tuple[Fraction, Fraction]]:
        return [(Fraction(x), Fraction(y)) for x, y in corners]

    outer = ring((0, 0), (9, 0), (9, 9), (5, 4), (0, 9))
    holes = [ring((1, 1), (1, 2), (3, 2)), ring((3, 2), (5, 3), (6, 1))]
    parts = trapezoids([outer, *holes])

    def area(corners: list[tuple[Fraction, Fraction]]) -> Fraction:
        sides = zip(corners, corners[1:] + corners[:1], strict=True)
        return sum((a[0] * b[1] - b[0] * a[1] for a, b in sides), Fraction(0)) / 2

    assert all(area(part) > 0 and 3 <= len(part) <= 4 for part in parts)
    assert sum(area(part) for part in parts) == area(outer) + sum(area(hole) for hole in holes)


def test_a_face_that_an_edge_rests_on_is_looked_at_on_both_sides_of_it() -> None:
    floor = box(point(0, 0, 0), point(4, 4, 1))
    corners = [point(x, y, z) for x in (0, 4) for y, z in ((2, 1), (3, 3), (1, 3))]
    wedge = convex_hull(corners)
    below = [
        place[1]
        for n, place in sites(floor.with_faces_of(wedge))
        if n == (0, 0, 1) and place[2] == 1
    ]
    assert len(below) == 2 and min(below) < 2 < max(below)
    apart = wedge.translated(point(0, 0, 1))
    assert len(list(sites(floor.with_faces_of(apart)))) == len(floor.faces) + len(wedge.faces)
