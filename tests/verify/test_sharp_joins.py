"""The verb `offset` with sharp corners: what is judged before moved sides meet, and after."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable
from fractions import Fraction

import pytest
from minkref.errors import Refusal
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.geometry.region import region_of_polygons
from minkref.fuzz.libraries.catalogue import absence
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.join_check import moves_simply, rings_of
from minkref.fuzz.offsets.join_pieces import JoinPieces
from minkref.fuzz.offsets.judgement import judge_offset
from minkref.fuzz.offsets.manner import MITRE, Manner
from minkref.fuzz.offsets.question import OFFSETS
from minkref.fuzz.offsets.sharp_cases import FAMILIES
from minkref.fuzz.offsets.sharp_front import front_of, is_free
from minkref.fuzz.run import naming
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict
from thoroughness import draws

Outcomes = Callable[..., list[Outcome]]
SEED = 5
ROUNDED = Declaration("t", arithmetic="polygons", relative=Fraction(1, 10**9))
SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
SLOT = [(0, 0), (8, 0), (8, 6), (5, 6), (5, 2), (3, 2), (3, 6), (0, 6)]


def asked(text: str) -> AskedOffset:
    case = naming.load(CaseName(text, "test"))
    assert isinstance(case, AskedOffset)
    return case


def literal(ring: object, radius: str = "1", **more: object) -> str:
    given = ring if isinstance(ring, dict) else {"polygons": [{"outer": ring, "holes": []}]}
    return json.dumps({"offset": given, "radius": radius, "join": "sharp", **more})


def said_of(case: AskedOffset, polygons: object) -> Outcome:
    answer = Answer(region_of_polygons(polygons, True), declaration=ROUNDED)
    return judge_offset(case, "t", answer)[0]


@pytest.mark.parametrize("family", FAMILIES)
def test_cases_have_names_that_reproduce_them(family: str) -> None:
    print("seed", SEED)
    drawn: Counter[str] = Counter()
    for k in range(16):
        case = asked(f"{family}:{SEED}:{k}")
        drawn[case.position.split(",")[0]] += 1
        assert asked(case.literal).literal == case.literal
        assert ("inset-sharp" in case.needs) == case.inward == bool(k % 2)
        assert "join-sharp" in case.needs and not {"offset", "inset"} & case.needs
        assert any(step.size < OFFSETS.small_case(case.literal).size
                   for step in OFFSETS.smaller(OFFSETS.small_case(case.literal)))  # fmt: skip
    assert set(drawn) == {"grown", "eroded"}


def test_families_are_those_that_a_target_takes() -> None:
    assert OFFSETS.families_for({"join-sharp"}) == tuple(FAMILIES)
    assert not set(FAMILIES) & set(OFFSETS.families_for({"offset", "join-mitre"}))


def test_a_square_keeps_its_corners() -> None:
    """Known by hand, also that of a frame's hole."""
    grown = [(-1, -1), (5, -1), (5, 5), (-1, 5)]
    bevelled = [(0, -1), (4, -1), (5, 0), (5, 4), (4, 5), (0, 5), (-1, 4), (-1, 0)]
    case = asked(literal(SQUARE))
    assert said_of(case, [[grown]]).verdict is Verdict.PASS_WITHIN
    assert said_of(case, [[bevelled]]).reasons == (Reason.MISSING,)
    assert said_of(case, [[[(-2, -2), (5, -1), (5, 5), (-1, 5)]]]).reasons == (Reason.EXTRA,)
    hole = [(1, 1), (1, 3), (3, 3), (3, 1)]
    frame = {"polygons": [{"outer": SQUARE, "holes": [hole]}]}
    eroded = asked(literal(frame, "-1/4"))
    quarter, other = Fraction(1, 4), Fraction(15, 4)
    thin = [(quarter, quarter), (other, quarter), (other, other), (quarter, other)]
    low, high = Fraction(3, 4), Fraction(13, 4)
    wide = [(low, low), (low, high), (high, high), (high, low)]
    assert said_of(eroded, [[thin, wide]]).verdict is Verdict.PASS_WITHIN
    assert said_of(eroded, [[thin, hole]]).reasons == (Reason.EXTRA,)
    assert said_of(eroded, [[thin, [(0.5, 0.5), (0.5, 3.5), (3.5, 3.5), (3.5, 0.5)]]]).reasons == (
        Reason.MISSING,
    )


def test_after_a_meeting_only_what_a_disc_sweeps_is_due() -> None:
    """A slot two wide closes at one: its ground is filled, its corners outside may differ."""
    case = asked(literal(SLOT, "2"))
    assert front_of(case).meeting == 1 and not is_free(case, Fraction(0))
    filled = [(-2, -2), (10, -2), (10, 8), (-2, 8)]
    assert said_of(case, [[filled]]).verdict is Verdict.PASS_WITHIN
    assert said_of(case, [[[(-4, -2), (10, -2), (10, 8), (-2, 8)]]]).verdict is Verdict.PASS_WITHIN
    slit = [(3.75, 7), (3.75, 3), (4.25, 3), (4.25, 7)]
    assert said_of(case, [[filled, slit]]).reasons == (Reason.MISSING,)
    eroded = asked(literal(SLOT, "-3/2"))
    assert said_of(eroded, []).verdict is Verdict.PASS_WITHIN
    assert said_of(eroded, [[[(1, 1), (2, 1), (2, 2)]]]).reasons == (Reason.EXTRA,)


def test_moved_rings_bound_the_union_of_mitres() -> None:
    """The pieces of mitred joins, with a limit beyond all corners, unite to the moved rings."""
    print("seed", SEED)
    for k in range(0, draws(12, 120), 2):
        case = asked(f"sharp-joins:{SEED}:{k}")
        if not is_free(case, Fraction(0)):
            continue
        mitres = JoinPieces(case.radius, Manner(MITRE, limit=Fraction(10**6)), True).of(case)
        front = Fraction(front_of(case).at(case.radius).area())
        assert abs(Fraction(mitres.area()) - front) <= front / 2**20, case.literal


def test_the_check_of_a_witness_finds_the_same_meetings() -> None:
    """Only radii next to a meeting count as free in one of them: the finder leaves these out."""
    print("seed", SEED)
    for k in range(draws(12, 120)):
        case = asked(f"sharp-joins:{SEED}:{k}")
        rings = rings_of(json.loads(case.literal), case.inward)
        first = front_of(case).meeting
        for factor in (Fraction(9, 10), Fraction(11, 10)):
            time = abs(case.radius) if first is None else first * factor
            assert moves_simply(rings, time) == front_of(case).is_free(time)


def test_fronts_of_another_radius_are_wrong() -> None:
    print("seed", SEED)
    for k in range(draws(8, 80)):
        case = asked(f"sharp-joins-grid:{SEED}:{k}")
        for factor, right in ((1, True), (Fraction(99, 100), False), (Fraction(101, 100), False)):
            time = abs(case.radius) * factor
            if is_free(case, time / 50) and front_of(case).is_free(time):
                said = said_of(case, front_of(case).at(time).rings())
                assert (said.verdict is Verdict.PASS_WITHIN) == right, (case.literal, said)
                grows = (factor > 1) != case.inward
                assert right or said.reasons == (Reason.EXTRA if grows else Reason.MISSING,)


@pytest.mark.parametrize(
    "text",
    [
        literal({"lines": [[[0, 0], [4, 0]]]}),
        literal(SQUARE, limit="2"),
        literal(SQUARE, "0"),
        literal(SQUARE, cap="flat"),
    ],
)
def test_what_is_no_case_is_refused(text: str) -> None:
    with pytest.raises(Refusal):
        asked(text)


def test_the_straight_skeleton_of_cgal(outcomes: Outcomes) -> None:
    if absence("cgal-skeleton"):
        pytest.skip(str(absence("cgal-skeleton")))
    names = [f"sharp-joins:{SEED}:{k}" for k in range(draws(8, 80))]
    verdicts = {one.verdict for one in outcomes("cgal-skeleton", *names)}
    assert verdicts <= {Verdict.PASS_WITHIN, Verdict.SKIPPED}, verdicts
