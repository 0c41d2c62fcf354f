"""Pairs on which libraries for space were wrong: their witnesses hold, our routes agree, and
`verify` has them as cases."""

from __future__ import annotations

import pytest
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.run import naming
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.comparison import compare
from minkref.fuzz.space.exact_sum import DEFINITION, EDGES, exposed_sum, polyhedron_of_planes
from minkref.fuzz.space.families import SPACE_FAMILIES
from minkref.fuzz.space.found import FAMILY, FoundInSpace, found_in_space
from minkref.fuzz.space.pair import Truth
from minkref.fuzz.space.smaller_solids import is_valid
from minkref.fuzz.space.witness import holds

FOUND = found_in_space()


@pytest.mark.parametrize("found", FOUND, ids=lambda found: found.title)
def test_what_is_said_of_a_pair_holds(found: FoundInSpace) -> None:
    pair = found.pair
    assert found.title and found.victims and found.story.endswith(".")
    assert is_valid(pair.P) and is_valid(pair.Q)
    assert holds(pair.P, pair.Q, pair.scale, found.witness)
    texts = {exposed_sum(pair.P, pair.Q, pair.scale, way).text() for way in (EDGES, DEFINITION)}
    assert len(texts) == 1


def test_the_copy_of_an_operand_is_refused() -> None:
    """As Manifold unites it."""
    (pair,) = (found.pair for found in FOUND if "copy" in found.title)
    right = polyhedron_of_planes(exposed_sum(pair.P, pair.Q, pair.scale, EDGES))
    assert compare(pair, right).proven
    assert compare(pair, right.with_faces_of(pair.P)).verdict == "wrong"


def test_they_are_cases_of_verify() -> None:
    assert next(iter(SPACE_FAMILIES)) == FAMILY
    for index in range(len(FOUND)):
        case = naming.load(CaseName(f"{FAMILY}:1:{index}", "named"))
        assert isinstance(case, SpaceCase) and case.pair.truth is Truth.SUM
    with pytest.raises(NoCase, match="found cases"):
        naming.load(CaseName(f"{FAMILY}:1:{len(FOUND)}", "named"))
