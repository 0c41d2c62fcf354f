"""Valid scales in space against static sums at single scales, and the slow engine."""

from __future__ import annotations

from fractions import Fraction

import minkref
import pytest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.motion.space_path_cases import SpacePathCase
from minkref.fuzz.judges.motion.space_path_collisions import StaticSum, by_slow_engine
from minkref.fuzz.space.generators.machined import plate
from minkref.reports.evidence.space_paths.paths import CONTACTS, SEED, judge
from thoroughness import draws

ZERO = Fraction(0)


@pytest.mark.parametrize("index", [3, 11, 12, 0, 6, 9, 21, 33][: draws(3, 8)])
def test_a_random_path_is_as_static_sums_say(index: int) -> None:
    """Takes kinds of paths in turn; 11 and 25 have a thin operand, and 12 is a corridor."""
    found = judge((index, True))
    assert not found["faults"], f"seed {SEED}: {found['faults']}"
    assert found["tally"]["scales"] > 3 and not found["tally"]["refused"]


def unit_at(x: int, y: int, z: int) -> Polyhedron:
    return plate(1, 1, 1).translated((Fraction(x), Fraction(y), Fraction(z)))


@pytest.mark.parametrize("contact", CONTACTS)
def test_judges_know_a_touch(contact: str) -> None:
    """Cubes side by side touch at scale 1, are apart below 1 and overlap above."""
    case = SpacePathCase("touch", unit_at(0, 0, 0), unit_at(1, 0, 0), [(ZERO, ZERO, ZERO)], "")
    for scale, expected in (("1/2", False), ("1", contact == "forbidden"), ("3/2", True)):
        s = Fraction(scale)
        assert StaticSum(case, s, contact).meets(case.path) == expected
        assert by_slow_engine(case, s, contact) == expected


def test_judges_know_a_passage() -> None:
    """A cube fits a slot exactly: its path lies inside the sum, and contact is allowed."""
    slot = unit_at(-1, 0, 0).with_faces_of(unit_at(1, 0, 0))
    way = [(ZERO, Fraction(-2), ZERO), (ZERO, Fraction(2), ZERO)]
    case = SpacePathCase("slot", unit_at(0, 0, 0), slot, way, "")
    assert not StaticSum(case, Fraction(1), "allowed").meets(way)
    assert StaticSum(case, Fraction(1), "forbidden").meets(way)
    assert StaticSum(case, Fraction(9, 8), "allowed").meets(way)


def test_values_in_python() -> None:
    octahedron = minkref.Polyhedron(
        [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)],
        [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]],
    )
    cube = minkref.Polyhedron(
        [(x, y, z) for z in (5, 9) for x, y in ((-4, -4), (4, -4), (4, 4), (-4, 4))],
        [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
    )
    found = minkref.valid_scales(octahedron, cube, [(0, 0, 0), ("1/2", 0, 2)])
    assert [str(one) for one in found.ranges] == ["(0, 3]"]
    assert found.star_shaped and found.largest == 3 and 3 in found and "3.01" not in found
    [bound] = found.bounds
    assert bound.part.kind == "vertex" and bound.part.numbers == (4,)
    assert bound.obstacle.kind == "face" and bound.obstacle.numbers == (0,)
    assert bound.touching == (Fraction(1, 2), Fraction(0), Fraction(5)) and bound.t == 1
    body = minkref.ConvexPolyhedron(cube)
    assert minkref.valid_scales(octahedron, body, [(0, 0, 0)]).largest == 5
    fit = minkref.largest_fit(octahedron, cube, (0, 0, 7), contact="forbidden")
    assert [str(one) for one in fit.ranges] == ["(0, 2)"]
    anywhere = minkref.largest_fit(octahedron, cube)
    assert [str(one) for one in anywhere.ranges] == ["(0, 2]"]
    assert anywhere.place is not None and anywhere.place[2] == 7
    with pytest.raises(minkref.Refusal, match="one place or anywhere"):
        minkref.largest_fit(octahedron, cube, between=[(0, 0, 7), (1, 0, 7)])  # type: ignore[call-overload]
    with pytest.raises(TypeError, match="obstacles has to be a Polyhedron"):
        minkref.valid_scales(octahedron, minkref.PolygonSet([(0, 0), (1, 0), (0, 1)]), [(0, 0, 0)])  # type: ignore[call-overload]
    with pytest.raises(minkref.BadInput):
        minkref.valid_scales(octahedron, cube, [(0, 0, 0)], route="index")
