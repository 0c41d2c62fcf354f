"""Targets that list events, update, or reject invalid input."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import inf, nextafter

import pytest
from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import bits_of, unit_for
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.invalid.family import KINDS
from minkref.fuzz.invalid.invalid_case import InvalidCase
from minkref.fuzz.invalid.invalid_judgement import judge_invalid
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.event_judgement import judge_events, window
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.run import naming
from minkref.fuzz.targets.answer import Answer, answered
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import GOOD, Reason, Verdict
from named_cases import named

EXACT = Declaration("exact")
FLOATS = Declaration("floats", arithmetic="float64", relative=Fraction(1, 10**9))
FRAME = (
    '{"P":{"polygons":[{"outer":[[0,0],[9,0],[9,9],[0,9]],"holes":[[[3,3],[3,6],[6,6],[6,3]]]}]},'
    '"Q":{"polygons":[{"outer":[[0,0],[2,0],[2,2],[0,2]]}]},"scale":"1"}'
)
CLOSES = Fraction(2, 3)  # the hole of 3 s is as wide as Q


def events_of(case: Case) -> list[Fraction]:
    moving = _core.DynamicSum(case.P, case.Q, *window(case))
    return sorted({Fraction(row[0]) for row in moving.topology_events()})


def test_events_of_the_reference_pass() -> None:
    for text in (FRAME, "holes:3:2", "comb:3:1", "nested:3:4"):
        case = named(text)
        assert judge_events(case, "t", events_of(case), EXACT).verdict is Verdict.PASS


def test_missed_event_has_the_place_where_it_happens_as_witness() -> None:
    case = named(FRAME)
    assert events_of(case) == [CLOSES]
    outcome = judge_events(case, "t", [], EXACT)
    assert outcome.reasons == (Reason.EVENT_MISSED,)
    assert outcome.witness is not None and outcome.witness.scale == str(CLOSES)
    assert holds(case.P_json, case.Q_json, str(CLOSES), outcome.witness)


def test_invented_event_is_wrong() -> None:
    outcome = judge_events(named(FRAME), "t", [CLOSES, Fraction(1)], EXACT)
    assert outcome.reasons == (Reason.EVENT_INVENTED,)
    assert "nearest is at 2/3" in outcome.message
    assert outcome.witness is not None


def test_rounded_events_are_within_a_relative_tolerance() -> None:
    case = named(FRAME)
    near = Fraction(float(CLOSES))
    assert judge_events(case, "t", [near], FLOATS).verdict is Verdict.PASS_WITHIN
    assert judge_events(case, "t", [near], EXACT).verdict is Verdict.WRONG
    far = CLOSES + Fraction(1, 10**6)
    assert judge_events(case, "t", [far], FLOATS).verdict is Verdict.WRONG


def test_rounded_events_are_within_an_absolute_tolerance() -> None:
    case = named(FRAME)
    absolute = Declaration("floats", arithmetic="float64", absolute=Fraction(1, 10**6))
    near, far = CLOSES + Fraction(1, 10**7), CLOSES + Fraction(1, 10**5)
    assert judge_events(case, "t", [near], absolute).verdict is Verdict.PASS_WITHIN
    assert judge_events(case, "t", [far], absolute).verdict is Verdict.WRONG


def test_a_scale_rounded_to_a_double_up_or_down_is_right_without_a_tolerance() -> None:
    case = named(FRAME)
    doubles = Declaration("floats", arithmetic="float64", numbers="double")
    near = float(CLOSES)
    assert Fraction(near) < CLOSES
    for listed in (near, nextafter(near, inf)):
        outcome = judge_events(case, "t", [Fraction(listed)], doubles)
        assert outcome.verdict is Verdict.PASS_WITHIN
    for listed in (nextafter(near, 0.0), nextafter(nextafter(near, inf), inf)):
        outcome = judge_events(case, "t", [Fraction(listed)], doubles)
        assert outcome.verdict is Verdict.WRONG


def test_an_event_at_the_end_of_the_window_may_be_rounded_past_it() -> None:
    """And an event just behind the end may be rounded into the window."""
    text = FRAME.replace('"scale":"1"', '"scale":"{}"')
    at_end = named(text.replace("{}", str(CLOSES / 2)))
    assert window(at_end)[1] == str(CLOSES)
    past = CLOSES + Fraction(1, 10**10)
    assert judge_events(at_end, "t", [past], FLOATS).verdict is Verdict.PASS_WITHIN
    assert judge_events(at_end, "t", [], FLOATS).verdict in (Verdict.PASS, Verdict.PASS_WITHIN)
    behind = named(text.replace("{}", str((CLOSES - Fraction(1, 10**10)) / 2)))
    end = Fraction(window(behind)[1])
    assert end < CLOSES
    assert judge_events(behind, "t", [end], FLOATS).verdict is Verdict.PASS_WITHIN
    assert judge_events(behind, "t", [end], EXACT).verdict is Verdict.WRONG


@pytest.mark.parametrize("index", range(len(KINDS)))
def test_invalid_input_must_be_refused(index: int) -> None:
    case = naming.load(CaseName(f"invalid:1:{index}", "test"))
    assert isinstance(case, InvalidCase)
    assert case.refusal, "the reference refuses it"
    refused = Answer(verdict=Verdict.WRONG, message="self-intersecting")
    assert judge_invalid(case, "t", refused).verdict is Verdict.PASS
    outcome = judge_invalid(case, "t", answered('{"polygons":[]}', 0.0))
    assert outcome.reasons == (Reason.ACCEPTED_INVALID,)
    assert case.kind in outcome.message
    for broken in (Verdict.CRASHED, Verdict.ERRORED):
        assert judge_invalid(case, "t", Answer(verdict=broken)).verdict is broken


def test_update_starts_at_another_scale_and_names_the_same_pair() -> None:
    case = named("update(holes:3:2)")
    assert case.law is not None and case.law[0] == "update"
    base = case.law[1]
    assert (base.P_json, base.Q_json) == (case.P_json, case.Q_json)
    assert base.scale != case.scale


@pytest.mark.parametrize(
    ("numbers", "bits"),
    [
        ((), 0),
        (("0",), 0),
        (("1", "-1"), 1),
        (("6", "4"), 2),
        (("1/4", "3"), 4),
        (("1048576", "1"), 21),
        (("1/3",), None),
        (("1/1024", "1/512"), 2),
    ],
)
def test_bits_of_a_grid(numbers: tuple[str, ...], bits: int | None) -> None:
    assert bits_of([Fraction(number) for number in numbers]) == bits


def test_a_case_on_a_grid_needs_no_more_bits() -> None:
    found = 0
    for family in ("rational", "star", "magnitude", "thin"):
        for index in range(4):
            try:
                case = named(f"grid:24({family}:3:{index})")
            except NoCase:  # rounded it is no operand
                continue
            found += 1
            assert (bits_of(case.coordinates) or 0) <= 25
            assert case.scale == "1"
    assert found > 8
    assert unit_for(Fraction(5), 3) == 1
    assert unit_for(Fraction(5), 4) == Fraction(1, 2)


def frame_at(scale: Fraction) -> Case:
    return replace(named(FRAME), scale=str(scale))


DOUBLES = Declaration("doubles", arithmetic="float64", numbers="double")


@pytest.mark.parametrize("arithmetic", ["float64", "exact"])
def test_the_double_next_to_an_event_is_right_whatever_the_arithmetic(arithmetic: str) -> None:
    """An exact target that speaks doubles cannot say 2/3."""
    declared = replace(DOUBLES, arithmetic=arithmetic)
    near = float(CLOSES)
    for listed in {near, nextafter(near, inf if near < CLOSES else 0.0)}:
        assert judge_events(named(FRAME), "t", [Fraction(listed)], declared).verdict in GOOD
    far = Fraction(nextafter(nextafter(near, inf), inf))
    assert judge_events(named(FRAME), "t", [far], declared).verdict is Verdict.WRONG


def test_a_scale_rounded_over_the_end_of_the_window_is_right() -> None:
    """The event lies just beyond the end, and the double next to it is that next to the end."""
    for beyond in (Fraction(1, 10**20), -Fraction(1, 10**20)):
        for case in (frame_at((CLOSES - beyond) / 2), frame_at((CLOSES + beyond) * 2)):
            rounded = [Fraction(float(CLOSES))]
            for claimed in ([], rounded):
                outcome = judge_events(case, "t", claimed, DOUBLES)
                assert outcome.verdict in GOOD, (case.scale, claimed, outcome.message)


def test_a_tolerance_as_large_as_the_window_says_nothing() -> None:
    """Any scale would do within the tolerance: such a list is not called right."""
    wide = Declaration("wide", arithmetic="integer-grid", absolute=Fraction(4))
    for claimed in ([], [Fraction(1)]):
        outcome = judge_events(named(FRAME), "t", claimed, wide)
        assert outcome.verdict is Verdict.SKIPPED and "tolerance" in outcome.message
    narrow = replace(wide, absolute=Fraction(1, 100))
    near = [CLOSES + Fraction(1, 100)]
    assert judge_events(named(FRAME), "t", near, narrow).verdict is Verdict.PASS_WITHIN
    assert judge_events(named(FRAME), "t", [], narrow).verdict is Verdict.WRONG
