"""The slow engine in space: points, whole sums, claims, polycubes under a matrix."""

from __future__ import annotations

import json
import random
from dataclasses import replace
from fractions import Fraction

import pytest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.cells import surface_of
from minkref.fuzz.space.generators.polycube import random_polycube
from minkref.fuzz.space.pairs import space_pair
from minkref.oracle.slow import (
    CellSum,
    Exposed,
    InputError,
    Solid,
    SolidSum,
    exposed_from_json,
    of_faces,
    open_lines,
    solid_faults,
    solid_from_json,
    uniform,
    whole_sum,
)
from minkref.oracle.slow.operand import Polygon
from minkref.oracle.slow.space.solid_cells import IDENTITY, Matrix
from thoroughness import THOROUGH

SEED = 71205
ONE = Fraction(1)
FRAME = frozenset((x, y, 0) for x in range(3) for y in range(3) if (x, y) != (1, 1))
BOX = frozenset((x, y, z) for x in range(3) for y in range(3) for z in range(3))
MATRICES: list[Matrix] = [
    IDENTITY,
    ((2, 1, 0), (-1, 3, 1), (0, 1, 2)),
    ((0, 1, 0), (1, 0, 0), (0, 0, 1)),  # a mirror image
    ((-3, 1, 2), (1, 1, -1), (2, 5, 1)),
]


def solid(polyhedron: Polyhedron) -> Solid:
    return solid_from_json(polyhedron.document())


def under(matrix: Matrix, polyhedron: Polyhedron, mirrored: bool) -> Polyhedron:
    points = []
    for v in polyhedron.vertices:
        x, y, z = (sum(a * b for a, b in zip(row, v, strict=True)) for row in matrix)
        points.append((Fraction(x), Fraction(y), Fraction(z)))
    image = Polyhedron(tuple(points), polyhedron.faces)
    return image.turned_inside_out() if mirrored else image


def at(x: object, y: object, z: object) -> tuple[Fraction, Fraction, Fraction]:
    return Fraction(str(x)), Fraction(str(y)), Fraction(str(z))


def test_points_of_a_cube_in_a_frame_that_it_fits() -> None:
    """Frame + cube is a plate. Contact alone covers the hole's axis: the closed sum contains it,
    but the sum of the interiors does not."""
    cube = surface_of({(0, 0, 0)})
    truth = SolidSum(solid(surface_of(FRAME)), solid(cube), uniform(ONE))
    assert truth.holds(at(2, 2, 1))
    assert not truth.holds(at(2, 2, 1), interiors=True)
    assert truth.holds(at(2, 2, 1), [(1, 0, 0)], interiors=True)
    assert truth.holds(at(4, 4, 2)) and not truth.holds(at(4, 4, 2), interiors=True)
    assert truth.holds(at(4, 4, 2), [(-1, 0, 0)])
    assert not truth.holds(at(4, 4, 2), [(-1, 0, 0), (0, 0, 1)])
    assert not truth.holds(at("4.0001", 2, 1))


def test_thin_operands() -> None:
    l_solid = surface_of({(0, 0, 0), (1, 0, 0), (0, 1, 0)})
    point = Polyhedron((at(5, "1/2", -1),), ())
    moved = of_faces(solid(l_solid.translated(at(5, "1/2", -1))).faces)
    assert whole_sum(SolidSum(solid(l_solid), solid(point), uniform(ONE))).text() == moved.text()
    assert whole_sum(SolidSum(solid(point), solid(l_solid), uniform(ONE))).text() == moved.text()
    segment = Polyhedron((at(0, 0, 0), at(0, 0, 2)), ())
    taller = {(x, y, z) for x, y in ((0, 0), (1, 0), (0, 1)) for z in range(3)}
    found = whole_sum(SolidSum(solid(l_solid), solid(segment), uniform(ONE)))
    assert found.text() == of_faces(solid(surface_of(taller)).faces).text()
    with pytest.raises(InputError):
        SolidSum(solid(point), solid(segment), uniform(ONE))


@pytest.mark.parametrize(
    ("index", "matrix"),
    [(k, MATRICES[m]) for m in range(4) for k in range(4) if THOROUGH or k == m],
)
def test_cells_are_the_whole_sum(matrix: Matrix, index: int) -> None:
    dice = random.Random(f"{SEED} {index}")
    P, Q = random_polycube(dice, 2 + index), random_polycube(dice, 1 + index // 2)
    scale = Fraction(dice.choice(("1", "1/2", "3/2")))
    cells = CellSum(P, Q, scale, matrix)
    mirrored = cells.determinant < 0
    first, second = (solid(under(matrix, surface_of(body), mirrored)) for body in (P, Q))
    truth = SolidSum(first, second, uniform(scale))
    found = whole_sum(truth)
    assert found.text() == cells.exposed().text()
    assert found.volume() == cells.volume()
    assert exposed_from_json(json.loads(found.text())) == found.recast() == found
    assert open_lines(found) == 0
    assert list(solid_faults(truth, found, dice)) == []
    for _ in range(20):
        x, y, z = (Fraction(dice.randint(-8, 24), dice.randint(1, 2)) for _ in range(3))
        assert truth.holds((x, y, z)) == cells.holds((x, y, z))


def test_a_claim_without_its_cavity_is_found() -> None:
    """A hollow box with walls 1 thick plus a cube with side 1/2 has a cavity with side 1/2."""
    hollow, cube = surface_of(BOX - {(1, 1, 1)}), surface_of({(0, 0, 0)})
    found = whole_sum(SolidSum(solid(cube), solid(hollow), uniform(Fraction(1, 2))))
    assert found.volume() == Fraction(7, 2) ** 3 - Fraction(1, 8)
    outside = {key: found.planes[key] for key in found.planes if key[1] in (0, Fraction(7, 2))}
    filled = Exposed(outside)
    assert len(found.planes) == 12 and len(outside) == 6 and open_lines(filled) == 0
    truth = SolidSum(solid(cube), solid(hollow), uniform(Fraction(1, 2)))
    tried = random.Random(SEED)
    assert any(not fault.in_truth for fault in solid_faults(truth, filled, tried, points=400))


def shape(polygons: list[Polygon]) -> list[tuple[int, list[int]]]:
    return [(len(part.outer), [len(hole) for hole in part.holes]) for part in polygons]


@pytest.mark.parametrize(
    ("cells", "wanted"),
    [
        ({(0, 0), (1, 1)}, [(4, []), (4, [])]),
        ({(0, 0), (1, 0), (0, 1), (0, 2), (1, 2), (2, 2), (2, 1)}, [(6, [4])]),
        (FRAME, [(4, [4])]),
    ],
)
def test_sides_that_touch_at_a_corner(
    cells: set[tuple[int, ...]], wanted: list[tuple[int, list[int]]]
) -> None:
    """Rules 1 and 2 of the canonical form: two squares, and a ring whose hole touches its rim."""
    flat = {(c[0], c[1], 0) for c in cells}
    found = of_faces(solid(surface_of(flat)).faces)
    assert shape(found.planes[(0, 0, 1), ONE]) == wanted


def test_wrong_claims_are_found() -> None:
    pair = space_pair("torus", SEED, 3)
    truth = SolidSum(solid(pair.P), solid(pair.Q), uniform(ONE))
    found = whole_sum(truth)
    assert list(solid_faults(truth, found, random.Random(SEED))) == []
    moved = Exposed({(n, d + Fraction(n[0], 50)): found.planes[n, d] for n, d in found.planes})
    plane = next(iter(found.planes))
    for claim in (moved, Exposed({**found.planes, plane: []})):
        faults = list(solid_faults(truth, claim, random.Random(SEED), points=60))
        assert faults or open_lines(claim)
    assert open_lines(Exposed({k: v for k, v in found.planes.items() if k != plane}))


@pytest.mark.parametrize("family", ["torus", "star", "prism", "thin"])
@pytest.mark.parametrize("index", range(3))
def test_points_are_decided_as_by_meeting(family: str, index: int) -> None:
    """The other decision procedure, from fuzz/, does not use convex pieces."""
    pair = space_pair(family, SEED, index)
    pair = replace(pair, scale=Fraction(1 + index, 2))
    truth = SolidSum(solid(pair.P), solid(pair.Q), uniform(Fraction(1 + index, 2)))
    dice = random.Random(f"{SEED} {family} {index}")
    ends = [end for box in truth.boxes for end in box]
    low, high = ([f(end[k] for end in ends) for k in range(3)] for f in (min, max))
    for _ in range(25):
        x, y, z = (
            a + (b - a) * Fraction(dice.randint(0, 12), 12) for a, b in zip(low, high, strict=True)
        )
        contact = pair.meeting.decide((x, y, z)).contact
        assert truth.holds((x, y, z)) == (contact != "empty"), (x, y, z)
        if family != "thin":
            assert truth.holds((x, y, z), interiors=True) == (contact == "overlap"), (x, y, z)
