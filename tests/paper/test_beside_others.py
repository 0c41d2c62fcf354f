"""The paper's programs beside CGAL's sums and computer algebra's events: each difference has its
fault settled by the definition."""

from __future__ import annotations

import pytest
from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.geometry.region import region_of_sum
from minkref.fuzz.judges.beside import ABSENT, AGREE, GAVE_UP, OURS, THEIRS, Beside, least_bits
from minkref.fuzz.judges.plane.paper_algebra import (
    INVENTED,
    MISPLACED,
    MISSED,
    RIGHT,
    by_algebra,
    compared,
    listed,
)
from minkref.fuzz.judges.plane.paper_cgal import beside_in_plane, plane_answer
from minkref.fuzz.judges.space.paper_nef import beside_in_space
from minkref.fuzz.libraries.paper.program_name import read_name
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run.naming import load, load_in_plane
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.convex_sum import reference_sum

EXACT = read_name("minkref-paper@rational,corrected")
PRINTED = read_name("minkref-paper@mpfr:200")
FAMILIES = ("random", "passing", "touching", "rational")
MOST_EDGES = 40


def case_of(text: str) -> Case:
    return load_in_plane(CaseName(text, "test"))


def beside(name: str, case: Case, cgal: Case | None) -> str:
    """The kind of the one comparison: with the exact sum of another case as CGAL's answer."""
    found, program = Beside(), read_name(f"minkref-paper@{name}")
    theirs = None
    if cgal is not None:
        theirs = region_of_sum(_core.minkowski_sum(cgal.P, cgal.Q, cgal.scale))
    beside_in_plane(program, case, plane_answer(program, case), theirs, found)
    (kind,) = found.counts
    if kind in (OURS, THEIRS):
        assert case.name.text in found.shown[kind] and " at (" in found.shown[kind]
    return kind


def test_agreement_and_whose_fault_a_difference_is() -> None:
    case, other = case_of("random:1:3"), case_of("random:1:4")
    assert beside("rational,corrected", case, case) == AGREE
    assert beside("mpfr:200,static", case, case) == AGREE
    assert beside("mpfr:200", case, case) == OURS
    assert beside("rational,corrected", case, other) == THEIRS
    assert beside("interval,corrected", case_of("touching:61:1"), case) == GAVE_UP
    assert beside("rational,corrected", case, None) == ABSENT


def test_repairs_of_convex_sums_beside_another_sum() -> None:
    case = load(CaseName("space-convex:5:2", "test"))
    assert isinstance(case, SpaceCase)
    truth = reference_sum(case.pair.P, case.pair.Q, case.pair.scale)
    found = Beside()
    beside_in_space(EXACT, case, truth, found)
    beside_in_space(PRINTED, case, truth, found)
    beside_in_space(EXACT, case, case.pair.P, found)
    beside_in_space(EXACT, case, None, found)
    assert found.counts == {AGREE: 1, OURS: 1, THEIRS: 1, ABSENT: 1}


@pytest.mark.parametrize("family", FAMILIES)
def test_corrected_and_rational_the_events_are_those_of_computer_algebra(family: str) -> None:
    seen = 0
    for index in range(6):
        case = case_of(f"{family}:61:{index}")
        truth = by_algebra(case.P, case.Q, MOST_EDGES)
        if truth is None:
            continue
        assert listed(case.P, case.Q, EXACT) == truth.scales, index
        seen += len(truth.scales)
    assert seen > 0


def test_printed_events_are_missed_invented_and_misplaced() -> None:
    case = case_of("touching:61:1")
    truth = by_algebra(case.P, case.Q, MOST_EDGES)
    assert truth is not None
    counts = compared(truth, listed(case.P, case.Q, PRINTED), PRINTED.relative)
    assert counts[MISSED] > 0 and counts[INVENTED] > 0
    assert counts[RIGHT] + counts[MISPLACED] + counts[MISSED] == len(truth.scales)


def test_the_least_bits_are_those_from_which_on_all_are_right() -> None:
    assert least_bits({24: True, 53: False, 100: True, 200: True}) == 100
    assert least_bits({24: True, 53: True}) == 24
    assert least_bits({24: True, 53: False}) is None
