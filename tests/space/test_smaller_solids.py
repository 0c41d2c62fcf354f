"""Steps that shrink a case of general solids, and their ends."""

from __future__ import annotations

import json
from fractions import Fraction

import pytest
from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.run import naming
from minkref.fuzz.shrink.shrinker import shrink
from minkref.fuzz.space.exact_sum import core_polyhedron
from minkref.fuzz.space.families import GENERAL, drawn_pair
from minkref.fuzz.space.generators.convex import box, cube
from minkref.fuzz.space.hull import is_convex
from minkref.fuzz.space.small_case import SolidCase, smaller_in_space
from minkref.fuzz.space.smaller_solids import convex_parts, drawn_together, fewer_shells, is_valid
from thoroughness import draws

SEED = 4


def point(x: int, y: int, z: int) -> Point:
    return Fraction(x), Fraction(y), Fraction(z)


@pytest.mark.parametrize("family", [name for name, _ in GENERAL.values()])
def test_candidates_are_valid_and_smaller(family: str) -> None:
    pair = drawn_pair(family, SEED, 1)
    case = SolidCase(pair.P, pair.Q, pair.scale)
    count = 0
    for candidate in smaller_in_space(case):
        assert candidate.size < case.size
        for solid in candidate.operands:
            assert solid.fault() is None
            if not solid.is_thin:
                core_polyhedron(solid).validate()
        count += 1
        if count == draws(10, 40):
            break
    assert count


def test_shells_are_taken_away_one_by_one() -> None:
    outer, hole = box(point(0, 0, 0), point(9, 9, 9)), cube(point(1, 1, 1), Fraction(1))
    other = cube(point(5, 5, 5), Fraction(2))
    solid = outer.with_faces_of(hole.turned_inside_out()).with_faces_of(other.turned_inside_out())
    volumes = sorted(part.volume for part in fewer_shells(solid) if is_valid(part))
    assert volumes == [721, 728, 729]
    pieces = list(convex_parts(solid))
    assert len(pieces) > 3 and all(map(is_convex, pieces))


def test_an_edge_drawn_together_keeps_what_is_left_closed() -> None:
    solid = box(point(0, 0, 0), point(2, 3, 4))
    valid = [part for part in drawn_together(solid) if is_valid(part)]
    assert valid and all(len(part.vertices) == 7 for part in valid)


def test_a_surface_that_crosses_itself_is_no_candidate() -> None:
    one = cube(point(0, 0, 0), Fraction(2))
    crossing = one.with_faces_of(one.translated(point(1, 1, 1)))
    assert crossing.fault() is None and not is_valid(crossing)
    with pytest.raises(_core.BadInput):
        core_polyhedron(crossing).validate()


def test_a_fault_of_dents_ends_at_a_tetrahedron_and_few_vertices() -> None:
    """The fault: P is not convex."""
    pair = drawn_pair("space-mixed", SEED, 3)
    P = pair.P if not is_convex(pair.P) else pair.Q
    case = SolidCase(P, pair.Q, pair.scale)

    def still(candidate: SolidCase) -> bool:
        return not candidate.P.is_thin and not is_convex(candidate.P)

    assert still(case)
    made = shrink(case, smaller_in_space, still, 2000)
    assert len(made.case.Q.vertices) == 4 and len(made.case.P.vertices) <= 9, made.case.literal
    assert made.complete and made.case.size < case.size


def test_a_segment_stays_valid() -> None:
    assert is_valid(Polyhedron((point(0, 0, 0), point(1, 0, 0)), ()))
    assert not is_valid(Polyhedron((point(0, 0, 0), point(0, 0, 0)), ()))


def test_a_surface_that_touches_itself_is_no_candidate_and_needs_a_target_that_takes_it() -> None:
    """A notch's edge lies along a side's diagonal: the side's triangulation decides whether the
    mesh is a manifold."""
    vertices = ((2, 2, 0), (0, 2, 0), (2, 0, 1), (2, 2, 1), (0, 2, 1), (1, 1, 1))
    faces = ((1, 0, 2), (0, 3, 2), (5, 1, 3), (2, 3, 1), (0, 1, 4, 3), (4, 1, 5), (4, 5, 3))
    solid = Polyhedron(tuple(point(*vertex) for vertex in vertices), faces)
    assert solid.fault() is None and not is_valid(solid)
    document = {"P": solid.document(), "Q": cube(point(0, 0, 0), Fraction(1)).document()}
    case = naming.load(CaseName(json.dumps(document), "named"))
    assert "touching" in case.needs
    pair = drawn_pair("space-cup", SEED, 1)
    plain = {"P": pair.P.document(), "Q": pair.Q.document()}
    assert "touching" not in naming.load(CaseName(json.dumps(plain), "named")).needs
