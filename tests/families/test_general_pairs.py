"""Pairs of general polyhedra: valid, seeded, with the promised sizes."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction

import pytest
from minkref import _core
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.cells import surface_of
from minkref.fuzz.space.general_pairs import FAMILIES, OF_PARTS, general_pair
from minkref.fuzz.space.generators.machined import cup, gear, plate, square_ring, u_solid
from minkref.fuzz.space.generators.mapped import determinant, mapped, random_matrix, unimodular
from minkref.fuzz.space.generators.tube import knot_tube, lattice_torus
from minkref.fuzz.space.self_crossing import self_crossing

SEED = 8241
EACH = 6


def core(solid: Polyhedron) -> _core.Polyhedron:
    points = [(str(x), str(y), str(z)) for x, y, z in solid.vertices]
    return _core.Polyhedron(points, [list(face) for face in solid.faces])


@pytest.mark.parametrize("place", range(len(FAMILIES) + len(OF_PARTS)))
def test_pairs_are_valid_and_seeded(place: int) -> None:
    families = [*FAMILIES, *OF_PARTS]
    sizes = []
    for turn in range(EACH):
        index = place + turn * len(families)
        pair = general_pair(SEED, index)
        assert pair == general_pair(SEED, index)
        assert pair.name == f"{families[place]}:{SEED}:{index}"
        assert pair.scale > 0
        for solid in (pair.P, pair.Q, *pair.parts):
            if solid.is_thin:
                continue
            assert solid.fault() is None, pair.name
            assert self_crossing(solid) is None, pair.name
            assert solid.volume > 0, pair.name
            core(solid).validate()
            sizes.append(len(solid.faces))
    assert max(sizes) <= 110 and sum(sizes) / len(sizes) <= 60, sizes


def test_parts_and_cells_are_the_operands() -> None:
    seen: Counter[str] = Counter()
    for index in range(4 * (len(FAMILIES) + len(OF_PARTS))):
        pair = general_pair(SEED, index)
        if pair.parts:
            assert sum(part.volume for part in pair.parts) == pair.P.volume
            seen["parts"] += 1
        if pair.cells:
            size = abs(determinant(pair.cells.matrix))
            assert pair.P == mapped(pair.cells.matrix, surface_of(pair.cells.P))
            assert pair.P.volume == size * len(pair.cells.P)
            assert pair.Q.volume == size * len(pair.cells.Q)
            seen["cells"] += 1
    assert seen == {"parts": 4, "cells": 4}


def test_sizes_of_solids() -> None:
    dice = random.Random(SEED)
    ring = square_ring(3, 2, (1, 2, 3, 1), 2)
    assert (len(ring.faces), ring.volume) == (16, 2 * (6 * 6 - 3 * 2))
    body = cup(3, 2, 4, (1, 2, 3, 1), 2)
    assert (len(body.faces), body.volume) == (14, 6 * 6 * 6 - 3 * 2 * 4)
    assert plate(1, 2, 3).volume == 6
    assert len(u_solid(dice, 2, 3).faces) == 10
    assert len(gear(dice, 4, 12, 3).faces) == 18
    assert len(lattice_torus(5, 3, 2).faces) == 15
    assert determinant(unimodular(dice, 3)) in (-1, 1)
    assert determinant(random_matrix(dice, 2)) != 0


def test_a_knot_of_many_faces() -> None:
    tube = knot_tube(random.Random(SEED), 2, 5, 160, 3, 1000)
    assert len(tube.faces) == 960
    assert tube.fault() is None and self_crossing(tube) is None
    assert max(abs(number) for vertex in tube.vertices for number in vertex) > 1000
    with pytest.raises(ValueError, match="crosses itself"):
        knot_tube(random.Random(SEED), 3, 7, 6, 3, 100)


def at(x: int, y: int, z: int) -> Point:
    return Fraction(x), Fraction(y), Fraction(z)


@pytest.mark.parametrize(
    ("shift", "crosses"),
    [
        (at(0, 0, 5), False),
        (at(1, 1, 1), True),  # edges through faces
        (at(2, 0, 0), True),  # a common face
        (at(2, 2, 0), True),  # a common edge
        (at(2, 2, 2), True),  # a common corner
        (at(2, 1, 1), True),  # faces that overlap in a plane
    ],
)
def test_two_cubes_that_touch_or_cross(shift: Point, crosses: bool) -> None:
    one = plate(2, 2, 2)
    both = one.with_faces_of(one.translated(shift))
    assert both.fault() is None
    assert (self_crossing(both) is not None) == crosses


def test_a_face_folded_onto_its_neighbour() -> None:
    """A pyramid whose tip has sunk into its base has overlapping faces; a tip below the base makes
    no crossing."""
    base = [at(0, 0, 0), at(6, 0, 0), at(6, 6, 0), at(0, 6, 0)]
    faces = ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (3, 2, 1, 0))
    for height, crosses in ((4, False), (0, True), (-4, False)):
        pyramid = Polyhedron((*base, at(3, 3, height)), faces)
        assert (self_crossing(pyramid) is not None) == crosses
