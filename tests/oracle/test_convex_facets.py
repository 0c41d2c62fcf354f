"""The facets of convex sums, from the reference and from computer algebra."""

from __future__ import annotations

import random

import pytest
from minkref import _core
from minkref.fuzz.judges.space.convex_facets import convex_facets
from minkref.fuzz.space.convex_sum import body_of
from minkref.fuzz.space.generators.convex import random_hull
from thoroughness import draws

Corner = tuple[str, str, str]


def of_the_code(
    P: _core.ConvexPolyhedron, Q: _core.ConvexPolyhedron, scaling: Corner
) -> set[tuple[frozenset[int], frozenset[int]]]:
    found = _core.convex_sum(P, Q, scaling).facet_parents
    return {(frozenset(p), frozenset(q)) for p, q in found}


@pytest.mark.parametrize("seed", range(draws(2, 6)))
def test_facets_and_their_parents_are_those_of_the_definition(seed: int) -> None:
    dice = random.Random(seed)
    P, Q = (body_of(random_hull(dice, 5, 2)) for _ in "PQ")
    for scaling in (("1", "1", "1"), ("2", "1", "1/2")):
        wanted = convex_facets(P.surface().points(), Q.surface().points(), scaling)
        assert of_the_code(P, Q, scaling) == wanted


def test_two_cubes_have_six_facets() -> None:
    cube = body_of(random_hull(random.Random(0), 60, 1))
    assert cube.vertices == 8
    corners = cube.surface().points()
    wanted = convex_facets(corners, corners, ("3", "1", "2"))
    assert len(wanted) == 6
    assert of_the_code(cube, cube, ("3", "1", "2")) == wanted
