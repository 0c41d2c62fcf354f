"""Laws for sums in space: a pair's known answers hold for its transformed pairs."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from minkref import _core
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.comparison import compare
from minkref.fuzz.space.families import SPACE_FAMILIES, drawn_pair
from minkref.fuzz.space.hull import convex_hull, sum_of_convex
from minkref.fuzz.space.laws import refined, rotations, transformed_pairs
from minkref.fuzz.space.meeting import decide
from minkref.fuzz.space.pair import Truth
from minkref.fuzz.space.pairs import FAMILIES, space_pair
from thoroughness import draws


def places(dice: random.Random, polyhedron: Polyhedron, count: int) -> list[Point]:
    low, high = polyhedron.box
    return [
        tuple(  # type: ignore[misc]
            low[k] + (high[k] - low[k]) * Fraction(dice.randint(-2, 14), 12) for k in range(3)
        )
        for _ in range(count)
    ]


@pytest.mark.parametrize("family", FAMILIES)
def test_operands_are_valid_and_the_same_each_time(family: str) -> None:
    for index in (0, 3, 14, 27, 66):
        pair = space_pair(family, 5, index)
        assert pair.P.fault() is None and pair.Q.fault() is None
        assert all(solid.volume > 0 for solid in (pair.P, pair.Q) if not solid.is_thin)
        assert not (pair.P.is_thin and pair.Q.is_thin)
        assert pair == space_pair(family, 5, index)


@pytest.mark.parametrize(
    "family", ["polycube", "hollow", "prism", "convex", "sphere", "round", "thin", "offset"]
)
def test_sum_of_the_transformed_pair_mapped_back_is_the_sum(family: str) -> None:
    for index in (2, 13, 31)[: draws(1, 3)]:
        pair = space_pair(family, 6, index)
        try:
            total = pair.sum()
        except ValueError:
            continue  # rings of the region touch
        assert total is not None
        for law in transformed_pairs(pair):
            if pair.truth is Truth.HULL:
                image = sum_of_convex(law.pair.P, law.pair.Q, law.pair.scale)
                assert compare(pair, law.back(image)).proven, law.name
            # Backwards: the map takes points of each sum to points of the other.
            there = law.pair.meeting
            here = pair.meeting
            dice = random.Random(index)
            for x in places(dice, total, draws(6, 12)):
                single = Polyhedron((x,), ())
                (image_of_x,) = law.back(single).vertices
                assert there.meets(x) == here.meets(image_of_x), law.name


def test_a_sum_holds_every_sum_of_two_vertices_and_nothing_outside_the_box() -> None:
    for family in ("torus", "star", "polycube"):
        pair = space_pair(family, 1, 20)
        s = pair.meeting.scale
        for p in pair.P.vertices[:6]:
            for q in pair.Q.vertices[:6]:
                x = (s[0] * p[0] + q[0], s[1] * p[1] + q[1], s[2] * p[2] + q[2])
                assert pair.meeting.meets(x)
        high = tuple(s[k] * pair.P.box[1][k] + pair.Q.box[1][k] for k in range(3))
        assert not pair.meeting.meets((high[0] + Fraction(1, 10**9), high[1], high[2]))


def test_decision_gives_points_of_the_operands_that_add_to_the_point() -> None:
    for family in ("torus", "star", "l-prism"):
        pair = space_pair(family, 2, 15)
        s = pair.meeting.scale
        for x in places(random.Random(1), pair.P, 20):
            decision = decide(pair.P, pair.Q, pair.scale, x)
            if decision.contact == "empty":
                assert decision.p is None
                continue
            p, q = decision.p, decision.q
            assert p is not None and q is not None
            assert (s[0] * p[0] + q[0], s[1] * p[1] + q[1], s[2] * p[2] + q[2]) == x


def test_hull_of_a_hull_is_the_hull_and_takes_collinear_coplanar_and_repeated_points() -> None:
    dice = random.Random(3)
    for _ in range(10):
        points = [tuple(Fraction(dice.randint(0, 3)) for _ in range(3)) for _ in range(30)]
        hull = convex_hull(points)  # type: ignore[arg-type]
        assert hull.fault() is None
        assert convex_hull([*hull.vertices, *hull.vertices]) == hull
        assert convex_hull(refined(hull).vertices) == hull


@pytest.mark.parametrize("family", SPACE_FAMILIES)
def test_a_solid_in_smaller_faces_is_the_same_solid(family: str) -> None:
    """Cuts faces with straight corners into fewer triangles than sides: refined pairs of such faces
    used to be open meshes."""
    for index in range(3 if family == "space-found" else draws(3, 12)):
        pair = drawn_pair(family, 77, index)
        for solid in (pair.P, pair.Q):
            if not solid.faces:
                continue
            finer = refined(solid)
            mesh = _core.Polyhedron([tuple(map(str, v)) for v in finer.vertices],
                                    [list(face) for face in finer.faces])  # fmt: skip
            mesh.validate()
            assert finer.volume == solid.volume


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_hull_of_points_in_a_plane_is_refused(axis: int) -> None:
    points = [[Fraction(i), Fraction(i * i), Fraction(7 - i)] for i in range(6)]
    for point in points:
        point[axis] = Fraction(2)
    with pytest.raises(ValueError, match="one plane"):
        convex_hull(tuple(point) for point in points)  # type: ignore[misc]


def test_volume_is_kept_by_rotation_refinement_and_translation_and_scaled_by_scaling() -> None:
    pair = space_pair("star", 4, 12)
    volume = pair.P.volume
    assert len(rotations()) == 24
    assert {rotation.apply(pair.P).volume for rotation in rotations()} == {volume}
    for rotation in rotations():
        assert rotation.inverse().apply(rotation.apply(pair.P)) == pair.P
    assert refined(pair.P).volume == volume
    assert refined(pair.P).fault() is None
    assert pair.P.translated((Fraction(9), Fraction(1, 3), Fraction(-4))).volume == volume
    assert pair.P.scaled((Fraction(2), Fraction(3), Fraction(1, 5))).volume == volume * 6 / 5
    assert pair.P.reflected((Fraction(1), Fraction(0), Fraction(0))).volume == volume
    assert pair.P.turned_inside_out().volume == -volume
    assert Polyhedron.from_json(pair.P.to_json()) == pair.P
