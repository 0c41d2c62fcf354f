"""Round solids, workshop parts, and pairs made from them: valid, with the promised sizes."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction

import pytest

pytest.importorskip("minkref._core", reason="the extension module is not built")

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.generators.machined import plate
from minkref.fuzz.space.generators.placed import around_origin
from minkref.fuzz.space.generators.round import clutch, geodesic_sphere, triangulated_torus
from minkref.fuzz.space.generators.tube import wide_knot
from minkref.fuzz.space.generators.workshop import (
    bored_plate,
    hollow_block,
    rounded_bracket,
    spur_gear,
)
from minkref.fuzz.space.hull import is_convex
from minkref.fuzz.space.large_pairs import FAMILIES, LEAST, MOST, large_pair
from minkref.fuzz.space.membership import winding_number
from minkref.fuzz.space.self_crossing import self_crossing
from minkref.reports.bench.space_pairs import GROWING, PAIRS, SIZES, TimedPair
from thoroughness import draws

SEED = 5519
ORIGIN = (Fraction(0), Fraction(0), Fraction(0))


def check(solid: Polyhedron) -> None:
    assert solid.fault() is None
    assert self_crossing(solid) is None
    assert solid.volume > 0
    assert solid.denominator == 1
    core_polyhedron(solid).validate()


def tunnels(solid: Polyhedron) -> int:
    """The number of tunnels, all shells together."""
    edges = {
        frozenset(side)
        for face in solid.faces
        for side in zip(face, face[1:] + face[:1], strict=True)
    }
    characteristic = len(solid.vertices) - len(edges) + len(solid.faces)
    return len(set(solid.shells)) - characteristic // 2


@pytest.mark.parametrize(
    ("make", "triangles", "through"),
    [
        (lambda: geodesic_sphere(0, 300), 20, 0),
        (lambda: geodesic_sphere(1, 300), 80, 0),
        (lambda: geodesic_sphere(2, 700), 320, 0),
        (lambda: triangulated_torus(20, 5, 3000, 1000), 200, 1),
        (lambda: clutch(random.Random(SEED), 44, 11, 1000), 352, 1),
        (lambda: wide_knot(2, 3, 31, 4, 1000), 248, 1),
        (lambda: bored_plate(3, 8, 100), 120, 3),
        (lambda: rounded_bracket(8, 0, 120), 128, 3),
        (lambda: rounded_bracket(16, 4, 120), 304, 3),
        (lambda: spur_gear(30, 3600, 1000, 24), 576, 1),
        (lambda: spur_gear(12, 1600, 1000), 188, 0),
        (lambda: hollow_block(1, 300), 92, 0),
    ],
)
def test_solids_are_valid(make: Callable[[], Polyhedron], triangles: int, through: int) -> None:
    solid = make()
    check(solid)
    assert len(solid.triangles) == triangles
    assert tunnels(solid) == through


def test_geodesic_spheres_are_convex_and_a_block_minus_one_is_not() -> None:
    assert all(is_convex(geodesic_sphere(splits, 300)) for splits in (0, 1, 2))
    ball, block = geodesic_sphere(1, 300), hollow_block(1, 300)
    assert block.volume == 1000**3 - ball.volume
    assert len(set(block.shells)) == 2


def test_a_clutch_has_its_teeth_and_no_parallel_faces() -> None:
    solid = clutch(random.Random(SEED), 44, 11, 1000)
    highest = [vertex[2] > 800 for vertex in solid.vertices[2::4]]
    assert sum(a and not b for a, b in zip(highest, highest[1:] + highest[:1], strict=True)) == 11
    with pytest.raises(ValueError, match="44 columns"):
        clutch(random.Random(SEED), 43, 11, 1000)


@pytest.mark.parametrize("solid", [plate(9, 9, 9), triangulated_torus(12, 4, 3000, 1000)])
def test_the_origin_comes_inside(solid: Polyhedron) -> None:
    assert winding_number(solid, ORIGIN) == 0 or solid.box[0] == ORIGIN
    moved = around_origin(solid)
    assert winding_number(moved, ORIGIN) == 1
    assert moved.volume == solid.volume and moved.faces == solid.faces


@pytest.mark.parametrize("place", range(len(FAMILIES)))
def test_large_pairs_are_valid_and_seeded(place: int) -> None:
    for index in (place, place + len(FAMILIES))[: draws(1, 2)]:
        pair = large_pair(SEED, index)
        assert pair == large_pair(SEED, index)
        check(pair.P)
        check(pair.Q)
        assert LEAST <= len(pair.P.triangles) + len(pair.Q.triangles) <= MOST
        assert winding_number(pair.Q, ORIGIN) == 1


@pytest.mark.parametrize("pair", PAIRS, ids=[pair.name for pair in PAIRS])
def test_timed_pairs_are_valid_and_have_the_sizes_of_their_names(pair: TimedPair) -> None:
    P, Q = pair.solids()
    check(P)
    check(Q)
    assert winding_number(Q, ORIGIN) == 1
    for solid, name in zip((P, Q), pair.name.replace(",", "").split(" + "), strict=True):
        number = name.split()[-1]
        if number.isdecimal() and not name.startswith(("gear", "cube")):
            assert len(solid.triangles) == int(number)


@pytest.mark.parametrize("family", GROWING)
def test_growing_pairs_are_valid(family: str) -> None:
    for size in SIZES[family][: draws(2, 4)]:
        for solid in GROWING[family](size):
            check(solid)
