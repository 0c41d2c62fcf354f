"""Unions with a known answer: the digest is that of the reference, plain fractions prove the set,
the area agrees, the witness holds, and `verify` has them as cases."""

from __future__ import annotations

from fractions import Fraction

import pytest
from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.geometry.plane import Shape, doubled_area
from minkref.fuzz.geometry.region import Region
from minkref.fuzz.plane.exact_shapes import shape_of
from minkref.fuzz.run import naming
from minkref.fuzz.unions.asked_union import AskedUnion
from minkref.fuzz.unions.known import FAMILY, KnownUnion, known_unions
from minkref.fuzz.unions.question import UNIONS
from minkref.fuzz.unions.side_check import wrong_side
from minkref.fuzz.unions.union_witness import UnionOf

KNOWN = known_unions()


def area(shape: Shape) -> Fraction:
    """Holes run the other way, and count less than nothing."""
    return Fraction(sum(doubled_area(ring) for polygon in shape for ring in polygon)) / 2


@pytest.mark.parametrize("known", KNOWN, ids=lambda known: known.title)
def test_what_is_said_of_a_union_holds(known: KnownUnion) -> None:
    for each in known.sets:
        each.validate(known.title)
    found = Region(*_core.combined("union", list(known.sets)))
    assert (found.digest, found.components, found.holes) == (
        known.digest, known.components, known.holes,
    )  # fmt: skip
    shapes = [shape_of(each) for each in known.sets if each.is_region]
    assert wrong_side(shapes, shape_of(found.set)) is None
    assert area(shape_of(found.set)) == known.area
    assert known.story.endswith(".") and known.title
    assert known.victims or known.witness is None
    if known.witness is not None:
        case = AskedUnion(CaseName(known.title, "known"), known.sets)
        assert UnionOf(case).holds(known.witness)


def test_the_order_of_the_sets_does_not_matter() -> None:
    for known in KNOWN:
        turned = Region(*_core.combined("union", list(known.sets[::-1])))
        assert turned.digest == known.digest


def test_they_are_cases_of_verify() -> None:
    assert next(iter(UNIONS.families)) == FAMILY
    assert len({known.title for known in KNOWN}) == len(KNOWN)
    for index, known in enumerate(KNOWN):
        case = naming.load(CaseName(f"{FAMILY}:1:{index}", "named"))
        assert isinstance(case, AskedUnion) and case.expected.digest == known.digest
    with pytest.raises(NoCase, match="known unions"):
        naming.load(CaseName(f"{FAMILY}:1:{len(KNOWN)}", "named"))
