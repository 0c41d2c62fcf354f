"""Sums with a ball, before a judge that shares nothing with them: the exact distance of a point to
a solid's triangles. And where points lie in sets in space."""

from __future__ import annotations

import copy
import pickle
from fractions import Fraction
from itertools import product

import minkref
import pytest
from minkref.fuzz.judges.space.ball_sums import ball_trial
from thoroughness import draws

SEED = 5
Point = tuple[Fraction, ...]
RADII = ("1", "sqrt:2", "1/3", "7")
TOLERANCES = (Fraction(1), Fraction(1, 4), Fraction(1, 10), Fraction(1, 30))


def frame() -> minkref.Polyhedron:
    """The box [0, 6]² x [0, 2] with a hole [2, 4]²."""
    rings = ([(0, 0), (6, 0), (6, 6), (0, 6)], [(2, 2), (4, 2), (4, 4), (2, 4)])
    corners = [(x, y, z) for ring in rings for z in (0, 2) for x, y in ring]
    faces = []
    for k in range(4):
        m = (k + 1) % 4
        faces += [[k, m, 4 + m, 4 + k], [8 + m, 8 + k, 12 + k, 12 + m]]
        faces += [[4 + k, 4 + m, 12 + m, 12 + k], [m, k, 8 + k, 8 + m]]
    return minkref.Polyhedron(corners, faces)


def in_frame(x: Point) -> bool:
    flat = all(0 <= c <= 6 for c in x[:2]) and 0 <= x[2] <= 2
    return flat and not all(2 < c < 4 for c in x[:2])


SKEW = minkref.Polyhedron(
    [("0", "0", "0"), ("3", "1/2", "0"), ("1/3", "2", "1/5"), ("1", "1", "5/2")],
    [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
)


def less(a: Point, b: Point) -> Point:
    return tuple(x - y for x, y in zip(a, b, strict=True))


def dot(a: Point, b: Point) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True)), Fraction(0))


def cross(a: Point, b: Point) -> Point:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def ball(radius: str) -> minkref.Ball:
    root = radius.removeprefix("sqrt:")
    return minkref.Ball(radius) if root == radius else minkref.Ball(squared_radius=root)


def roots_are_near(a: Fraction, b: Fraction, T: Fraction) -> bool:
    """Tell whether root(a) <= root(b) + T."""
    rest = a - b - T * T
    return rest <= 0 or rest * rest <= 4 * b * T * T


@pytest.mark.parametrize("radius", RADII)
def test_polyhedra_lie_inside_a_ball_and_around_it_as_near_as_promised(radius: str) -> None:
    square = ball(radius).squared_radius
    for share in TOLERANCES:
        T = share * Fraction(round(1000 * float(square) ** 0.5), 1000)
        for around in (False, True):
            body = ball(radius).around(T) if around else ball(radius).inside(T)
            points = [tuple(map(Fraction, p)) for p in body.surface().points()]
            far = [dot(p, p) for p in points]
            near = []
            for a, b, c, *_ in body.surface().rings():
                n = cross(less(points[b], points[a]), less(points[c], points[a]))
                assert dot(n, points[a]) > 0
                near.append(dot(n, points[a]) ** 2 / dot(n, n))
            if around:
                assert min(near) >= square
                assert all(roots_are_near(f, square, T) for f in far)
            else:
                assert max(far) <= square
                assert all(roots_are_near(square, n, T) for n in near)
            assert body.surface().faces <= 12 / share + 20


def test_sums_with_a_ball_lie_between_their_sets() -> None:
    """Solids of each family of any shape, at points that the distance from the solid decides."""
    print(f"seed {SEED}")
    trials = [ball_trial(SEED, index, 12) for index in range(draws(14, 42))]
    assert [fault for trial in trials for fault in trial.faults] == []
    places = [sum(trial.places[k] for trial in trials) for k in range(3)]
    assert all(places), "points inside, between both sets, and outside"


def test_bounds_tighten_with_the_tolerance_and_agree() -> None:
    bounds = [minkref.ball_sum(SKEW, minkref.Ball(1), T).volume for T in TOLERANCES]
    assert all(low <= high for low, _ in bounds for _, high in bounds)
    widths = [high - low for low, high in bounds]
    assert widths == sorted(widths, reverse=True)
    points = minkref.ball_sum(minkref.Polyhedron([(1, 2, 3)], []), minkref.Ball(1), "1/10")
    assert points.volume[0] < Fraction(418879, 100000) < points.volume[1], "4/3 pi"


def test_the_sum_moves_with_its_operand_and_scales_it() -> None:
    by = (Fraction(7, 3), Fraction(-1), Fraction(1, 9))
    points = [tuple(Fraction(c) for c in p) for p in SKEW.points()]
    moved = minkref.Polyhedron(
        [tuple(c + d for c, d in zip(p, by, strict=True)) for p in points], SKEW.rings()
    )
    B = minkref.Ball("1/2")
    here, there = (minkref.ball_sum(P, B, "1/8") for P in (SKEW, moved))
    assert here.volume == there.volume
    for p in points:
        for step in product((-1, 0, 1), repeat=3):
            x = tuple(a + Fraction(b, 3) for a, b in zip(p, step, strict=True))
            y = tuple(a + b for a, b in zip(x, by, strict=True))
            assert here.inner.locate(x) == there.inner.locate(y)
            assert here.outer.locate(x) == there.outer.locate(y)
    scaled = minkref.Polyhedron([tuple(2 * c for c in p) for p in points], SKEW.rings())
    assert minkref.ball_sum(SKEW, B, "1/8", 2) == minkref.ball_sum(scaled, B, "1/8")


def test_a_hole_that_the_ball_just_fills_is_told_by_both_sets() -> None:
    open_, closed = (minkref.ball_sum(frame(), minkref.Ball(r), "1/20") for r in ("4/5", "6/5"))
    just = minkref.ball_sum(frame(), minkref.Ball(1), "1/20")
    assert [s.counts()["tunnels"] for s in (open_, just, closed)] == [(1, 1), (1, 0), (0, 0)]
    assert just.counts()["components"] == (1, 1)


def test_places_in_a_solid_with_a_hole() -> None:
    """Points on a lattice with all corners, edges and faces of the frame among them, as a
    PolyhedralSet and by coordinates."""
    solid = minkref.PolyhedralSet(frame())
    for x in product(range(-1, 8), range(-1, 8), range(-1, 4)):
        point = tuple(Fraction(c) for c in x)
        around = [
            in_frame(tuple(c + Fraction(d, 7) for c, d in zip(point, step, strict=True)))
            for step in product((-1, 1), repeat=3)
        ]
        expected = "inside" if all(around) else "boundary" if any(around) else "outside"
        assert solid.locate(point) == expected, point
        assert (x in solid) == (expected != "outside")


def test_equal_solids_are_equal_however_their_faces_are_cut() -> None:
    whole = minkref.PolyhedralSet(frame())
    cut = minkref.PolyhedralSet(frame().cut_into_triangles())
    assert whole == cut and hash(whole) == hash(cut)
    assert whole != minkref.PolyhedralSet(SKEW)


def test_a_ball_is_a_value() -> None:
    B = minkref.Ball("3/2")
    assert B == minkref.Ball(squared_radius="9/4") and hash(B) == hash(copy.copy(B))
    assert repr(B) == "Ball('3/2')" and eval(repr(B), {"Ball": minkref.Ball}) == B
    assert pickle.loads(pickle.dumps(B)) == B
    assert repr(minkref.Ball(squared_radius=2)) == "Ball(squared_radius='2')"


@pytest.mark.parametrize("given", [{"radius": 0}, {"radius": "-1"}, {}, {"squared_radius": "x"}])
def test_no_ball_without_a_radius(given: dict[str, str]) -> None:
    with pytest.raises(minkref.BadInput):
        minkref.Ball(**given)


def test_too_many_facets_are_refused() -> None:
    with pytest.raises(minkref.BadInput, match="more than 20,000 facets"):
        minkref.Ball(1).inside(Fraction(1, 10**6))
