"""Cases in the plane with a factor for each axis: how they are named, judged, changed and sent."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

import pytest
from minkref import _core
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.judges.plane import slow_points, slow_sums, slow_tight_passages
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.comparison import some_point
from minkref.fuzz.plane.law_judgement import judge_law
from minkref.fuzz.plane.laws import LAWS
from minkref.fuzz.plane.reference import ROUTES, ReferenceTarget
from minkref.fuzz.plane.small_case import PlaneCase, smaller_in_plane
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.targets.declaration import PLANE
from minkref.fuzz.verdicts.verdict import Verdict
from named_cases import named

SOUND = ReferenceTarget("minkref:paper", "paper")
FAMILIES = ("random", "fit", "touching", "degenerate", "rational", "convex")


@pytest.mark.parametrize("family", FAMILIES)
def test_the_slow_engine_agrees(family: str) -> None:
    for number in range(4):
        case = named(f"axes:{number}({family}:11:{number})")
        assert not case.is_uniform
        for judge in (slow_sums.judge, slow_tight_passages.judge, slow_points.judge):
            assert not judge(case).messages
        assert slow_sums.judge(case).compared


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("law", LAWS)
def test_the_reference_keeps_every_law(law: str, family: str) -> None:
    case = named(f"{law}(axes:1({family}:7:3))")
    assert case.law is not None
    base = case.law[1]
    before = None if LAWS[law].constant else SOUND.sum(base)
    outcomes = judge_law(law, "target", base, before, case, SOUND.sum(case), lambda: [])
    assert [o.verdict for o in outcomes] in ([Verdict.PASS], [Verdict.SKIPPED])


@pytest.mark.parametrize("family", ("convex", "random"))
def test_every_route_reaches_the_sum_by_update(family: str) -> None:
    for number in range(4):
        case = named(f"update(axes:{number}({family}:5:{number}))")
        assert case.law is not None
        truth = SOUND.sum(case).region
        for route in ROUTES:
            target = ReferenceTarget(route, route)
            answer = target.sum(case)
            if target.declaration.capabilities != PLANE:
                answer = target.updated_sum(case.law[1], case)
            assert truth is not None
            assert answer.region is not None
            assert answer.region.digest == truth.digest


def test_even_numbers_keep_the_scaled_operand() -> None:
    plain, drawn = named("fit:3:9"), named("axes:2(fit:3:9)")
    assert drawn.P.scaled(drawn.scale) == plain.P.scaled(plain.scale)


def test_a_target_without_the_word_gets_the_scaled_operand() -> None:
    case = named("axes:1(random:1:4)")
    sent = case.taken_by(PLANE)
    assert (sent.scale, sent.P) == ("1", case.P.scaled(case.scale))
    assert case.taken_by(PLANE | {"non-uniform"}) is case


def test_a_witness_is_checked_with_both_factors() -> None:
    square = {"polygons": [{"outer": [[1, 1], [2, 1], [2, 2], [1, 2]]}]}
    case = named(json.dumps({"P": square, "Q": square, "scale": "2,1/3"}))
    witness = some_point(case)
    assert holds(case.P_json, case.Q_json, case.scale, witness)
    exchanged = ",".join(case.scale.split(",")[::-1])
    assert not holds(case.P_json, case.Q_json, exchanged, witness)


def test_mutants_and_probes_stay_sets() -> None:
    for k in range(6):
        for name in (f"mutant:{k}(axes:{k}(random:2:{k}))", f"probe:{k}(axes:{k}(random:2:{k}))"):
            try:
                case = named(name)
            except NoCase:
                continue
            case.P.validate("P")
            assert all(Fraction(factor) > 0 for factor in case.scale.split(","))


def test_events_are_of_uniform_scales() -> None:
    with pytest.raises(NoCase):
        named("events(axes:1(random:1:4))")


def test_a_literal_and_a_file_name_the_same_case(tmp_path: Path) -> None:
    case = named("axes:1(random:1:4)")
    again = named(case.literal)
    assert (again.scale, again.P, again.Q) == (case.scale, case.P, case.Q)
    value = {
        "schema": "case-v1",
        "id": "axes",
        "dimension": 2,
        "P": json.loads(case.P_json),
        "Q": json.loads(case.Q_json),
        "scales": ["3", case.scale.split(",")],
    }
    path = tmp_path / "case.json"
    path.write_text(json.dumps(value), encoding="utf-8")
    assert named(str(path)).scale == "3"
    assert _core.read_file(f"{path}#P") == case.P


def test_shrinking_tries_the_scaled_operand_and_whole_factors() -> None:
    case = named("axes:1(random:1:4)")
    small = PlaneCase.read(case.P_json, case.Q_json, case.scale)
    scales = {candidate.scale for candidate in smaller_in_plane(small)}
    assert Fraction(1) in scales
    assert any(isinstance(scale, tuple) for scale in scales)
    assert isinstance(case, Case)
