"""The verb `offset` with a radius below 0: polygons near the erosion pass, others are refuted by
points that plain fractions check; what vanishes is right as nothing."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
from minkref import _core
from minkref.disc.disc import Disc
from minkref.disc.polygons import inset_near
from minkref.errors import Refusal
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import bits_of
from minkref.fuzz.geometry.region import region_of_polygons
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.degenerate_insets import KINDS
from minkref.fuzz.offsets.distance_check import holds
from minkref.fuzz.offsets.judgement import judge_offset, some_point
from minkref.fuzz.offsets.offset_cases import GENERAL, GRID, INWARD
from minkref.fuzz.offsets.question import OFFSETS
from minkref.fuzz.offsets.small_offset import SmallOffset, smaller_offsets
from minkref.fuzz.run import naming
from minkref.fuzz.run.runner import verb_of
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict
from minkref.verbs.verify_cases import case_list
from minkref.verbs.verify_request import Cases
from thoroughness import draws

Rings = Sequence[Sequence[Sequence[tuple[Any, Any]]]]
Outcomes = Callable[..., list[Outcome]]
SEED = 5
NEAR = Declaration(
    "t", arithmetic="polygons", relative=Fraction(1, 10**12), of_radius=Fraction(22, 10**4)
)
EXACT = Declaration("t")
ROOMS = (
    '{"polygons":[{"outer":[[0,0],[6,0],[6,2],[8,2],[8,0],[14,0],[14,6],[8,6],[8,4],[6,4],[6,6],'
    '[0,6]]}]}'
)  # fmt: skip
HOLED = '{"polygons":[{"outer":[[0,0],[9,0],[9,9],[0,9]],"holes":[[[4,4],[4,5],[5,5],[5,4]]]}]}'


def asked(text: str) -> AskedOffset:
    case = naming.load(CaseName(text, "test"))
    assert isinstance(case, AskedOffset)
    return case


def inset(text: str, radius: str) -> AskedOffset:
    return asked(json.dumps({"offset": json.loads(text), "radius": radius}))


def names(family: str, count: int) -> tuple[str, ...]:
    return tuple(f"{family}:{SEED}:{k}" for k in range(count))


def judged(case: AskedOffset, rings: Rings) -> Outcome:
    answer = Answer(region_of_polygons(rings, True), declaration=NEAR)
    (outcome,) = judge_offset(case, "t", answer)
    if outcome.witness is not None:
        assert holds(case.P_json, outcome.witness)
    return outcome


def near(case: AskedOffset, factor: Fraction, outside: bool = False) -> Outcome:
    """Judges polygons near the erosion at so many times the radius."""
    radius = abs(case.radius) * factor
    return judged(case, inset_near(case.set, Disc("", radius**2), radius / 1000, outside).rings())


def box(x: int, y: int, wide: int, high: int) -> list[list[tuple[Any, Any]]]:
    return [[(x, y), (x + wide, y), (x + wide, y + high), (x, y + high)]]


@pytest.mark.parametrize("family", INWARD)
def test_polygons_near_the_erosion_pass(family: str) -> None:
    """Polygons at another radius are refuted, unless both leave nothing."""
    print("seed", SEED)
    for name in names(family, draws(12, 240)):
        case = asked(name)
        for outside in (False, True):
            assert near(case, Fraction(1), outside).verdict is Verdict.PASS_WITHIN, name
        for factor, has in (("98/100", "985/1000"), ("102/100", "1003/1000")):
            left = case.by_disc(case.radius * Fraction(has)).components
            wanted = Verdict.WRONG if left else Verdict.PASS_WITHIN
            assert near(case, Fraction(factor)).verdict is wanted, (name, factor)


@pytest.mark.parametrize("route", ["definition", "paper"])
def test_our_routes_agree(route: str, outcomes: Outcomes) -> None:
    print("seed", SEED)
    said = outcomes(f"minkref:{route}", *names("insets", draws(9, 300)))
    assert {outcome.verdict for outcome in said} == {Verdict.PASS}, said


def test_a_target_that_declares_no_inset_is_not_asked(outcomes: Outcomes) -> None:
    (said,) = outcomes("minkref:index", names("insets", 1)[0])
    assert said.verdict is Verdict.SKIPPED
    able = replace(EXACT, capabilities=frozenset(("plane", "offset")))
    for declared, wanted in ((able, set()), (replace(
        able, capabilities=able.capabilities | {"inset"}), set(INWARD))):  # fmt: skip
        assert set(case_list(Cases(), [declared]).offsets) & set(INWARD) == wanted
    assert set(OFFSETS.families) >= set(INWARD)


def test_a_door_a_room_and_a_hole() -> None:
    """A door 2 wide: open at 9/10, shut at 11/10."""
    shut, open_ = inset(ROOMS, "-11/10"), inset(ROOMS, "-9/10")
    assert shut.counts == (2, 0) and open_.counts == (1, 0)
    assert near(shut, Fraction(1)).verdict is Verdict.PASS_WITHIN
    disc = Disc("", shut.radius**2)
    one, other = inset_near(shut.set, disc, Fraction(1, 1000), False).rings()
    lost = judged(shut, [one])
    assert lost.reasons == (Reason.COMPONENT,) and lost.witness is not None
    assert lost.witness.in_truth and lost.witness.radius == "-11/10"
    joined = judged(shut, [one, other, box(5, 3, 4, 1)])
    assert joined.reasons == (Reason.EXTRA,) and not joined.witness.in_truth  # type: ignore[union-attr]
    filled = judged(inset(HOLED, "-1"), [box(1, 1, 7, 7)])
    assert filled.reasons == (Reason.HOLE_LOST,) and filled.witness is not None
    assert filled.witness.squared_distance == "0"


def test_what_vanishes_is_right_as_nothing() -> None:
    """At the inradius a point is left, without interior; beside it a polygon within the
    tolerance."""
    square = '{"polygons":[{"outer":[[0,0],[2,0],[2,2],[0,2]]}]}'
    for radius in ("-1", "-999/1000", "-5"):
        assert judged(inset(square, radius), []).verdict is Verdict.PASS_WITHIN
    lost = judged(inset(square, "-9/10"), [])
    assert lost.reasons == (Reason.MISSING,)
    tiny: list[list[tuple[Any, Any]]] = [[("0.9", "0.9"), ("1.1", "0.9"), ("1", "1.1")]]
    left = judged(inset(square, "-11/10"), [tiny])
    assert left.verdict is Verdict.WRONG and left.witness is not None
    flat = inset('{"polygons":[{"outer":[[0,0],[4,0]]}]}', "-1")
    assert judged(flat, []).verdict is Verdict.PASS
    assert judged(flat, [box(0, 0, 1, 1)]).verdict is Verdict.WRONG


def test_curves_are_those_of_the_erosion() -> None:
    """A point refutes the grown set, and a missing component."""
    case = inset(ROOMS, "-11/10")
    right = Answer(curves=case.form, declaration=EXACT)
    assert [one.verdict for one in judge_offset(case, "t", right)] == [Verdict.PASS]
    value = json.loads(case.form)
    value["components"].pop()
    grown = inset(ROOMS, "11/10").form
    for curves in (json.dumps(value, separators=(",", ":")), grown, '{"components":[]}'):
        (said,) = judge_offset(case, "t", Answer(curves=curves, declaration=EXACT))
        assert said.verdict is Verdict.WRONG and said.witness is not None
        assert holds(case.P_json, said.witness)


def test_a_witness_that_says_too_much_is_refused() -> None:
    case = inset(HOLED, "-1")
    assert holds(case.P_json, some_point(case))
    (said,) = judge_offset(case, "t", Answer(region_of_polygons([], True), declaration=NEAR))
    witness = said.witness
    assert witness is not None and witness.in_truth and holds(case.P_json, witness)
    assert not holds(case.P_json, replace(witness, in_truth=False))
    assert not holds(case.P_json, replace(witness, radius="-4"))
    assert not holds(case.P_json, replace(witness, point=("9/2", "9/2")))
    assert not holds(case.P_json, replace(witness, nearest=("outside",)))


@pytest.mark.parametrize("family", INWARD)
def test_each_kind_is_drawn_and_has_a_name(family: str) -> None:
    drawn: Counter[str] = Counter()
    left = 0
    for name in names(family, 48):
        case = asked(name)
        drawn[case.position.partition(", ")[0]] += 1
        assert case.radius < 0 and case.set.is_region and "inset" in case.needs
        assert verb_of(name) == verb_of(case.literal) == "offset"
        assert asked(case.literal).literal == case.literal
        if family.endswith(GRID):
            bits = bits_of([*case.sent, case.radius])
            assert bits is None or case.radius.denominator < 2**1000
            assert (bits_of(case.sent) or 99) <= 24, name
        left += bool(_core.inset(case.set, str(case.radius**2)).components)
    assert set(drawn) == {*KINDS, GENERAL}, f"seed {SEED}: {drawn}"
    assert left > 24, "most leave something"


def test_steps_are_smaller_and_erode_too() -> None:
    case = SmallOffset.read(asked(f"insets:{SEED}:4").literal)
    steps = list(smaller_offsets(case))
    assert len(steps) > 10
    for step in steps[:: max(len(steps) // 12, 1)]:
        assert step.size < case.size and asked(step.literal).radius == step.radius
        assert step.radius < 0


def test_a_radius_of_0_is_refused() -> None:
    with pytest.raises(Refusal, match="the radius is 0"):
        inset(HOLED, "0")
