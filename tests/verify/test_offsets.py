"""The verb `offset`: right adapters pass, each planted fault is proven, witnesses can be checked,
the judge is checked, cases shrink, declarations are kept."""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
from minkref import _core
from minkref.cli.cli import run as command
from minkref.errors import Refusal
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import bits_of
from minkref.fuzz.geometry.region import region_of_polygons
from minkref.fuzz.geometry.surds import Surd, between, sign_of_sum
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.cover import uncovered
from minkref.fuzz.offsets.curves import form_of
from minkref.fuzz.offsets.distance import Distances
from minkref.fuzz.offsets.distance_check import holds
from minkref.fuzz.offsets.event_window import event_within
from minkref.fuzz.offsets.judgement import judge_offset, some_point
from minkref.fuzz.offsets.offset_cases import FAMILIES, GENERAL, GRID, KINDS
from minkref.fuzz.offsets.small_offset import SmallOffset, smaller_offsets
from minkref.fuzz.run import naming
from minkref.fuzz.run.case_list import CaseList, Wait
from minkref.fuzz.run.runner import Run, run, verb_of
from minkref.fuzz.shrink.finding import shrink_finding
from minkref.fuzz.targets.answer import Answer, Limits
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.fuzz.verdicts.verdict import GOOD, Outcome, Reason, Verdict
from offset_adapter import FAULTS, answer_to
from thoroughness import draws

Outcomes = Callable[..., list[Outcome]]
ADAPTER = Path(__file__).parent / "offset_adapter.py"
SEED = 5
NEAR = Declaration(
    "t", arithmetic="polygons", relative=Fraction(1, 10**12), of_radius=Fraction(22, 10**4)
)
FRAME = '{"polygons":[{"outer":[[0,0],[4,0],[4,4],[0,4]],"holes":[[[1,1],[1,3],[3,3],[3,1]]]}]}'


def target(way: str) -> str:
    return f"cmd:{sys.executable} {ADAPTER} {way}"


def literal(text: str, radius: str) -> str:
    return json.dumps({"offset": json.loads(text), "radius": radius})


def asked(text: str) -> AskedOffset:
    case = naming.load(CaseName(text, "test"))
    assert isinstance(case, AskedOffset)
    return case


def names(family: str, count: int) -> tuple[str, ...]:
    return tuple(f"{family}:{SEED}:{k}" for k in range(count))


def judged(case: AskedOffset, way: str) -> Outcome:
    request = {"P": json.loads(case.P_json), "radius": str(case.radius)}
    polygons = answer_to(way, request)["polygons"]
    rings = [[each["outer"], *each.get("holes", [])] for each in polygons]
    (outcome,) = judge_offset(case, way, Answer(region_of_polygons(rings, True), declaration=NEAR))
    return outcome


def verified(way: str, *cases: str) -> Run:
    return run(
        CaseList(SEED, None, named=cases, models=False),
        [target(way)], ALL_TARGETS, {}, Baseline(), Limits(seconds=60), 1,
    )  # fmt: skip


@pytest.mark.parametrize("way", ["polygon", "pieces", "curves"])
def test_a_right_adapter_is_never_accused(way: str, outcomes: Outcomes) -> None:
    """The adapter by pieces shares nothing with the sum of a set and a polygon."""
    print("seed", SEED)
    count = draws(6, 90) if way == "pieces" else draws(12, 240)
    said = outcomes(target(way), *(name for family in FAMILIES for name in names(family, count)))
    right = Verdict.PASS if way == "curves" else Verdict.PASS_WITHIN
    assert {outcome.verdict for outcome in said} == {right}, said


def test_an_adapter_in_doubles_is_never_accused(outcomes: Outcomes) -> None:
    print("seed", SEED)
    said = outcomes(target("doubles"), *names("offsets" + GRID, draws(12, 240)))
    assert {outcome.verdict for outcome in said} <= set(GOOD), said


@pytest.mark.parametrize("way", FAULTS)
def test_a_planted_fault_is_proven(way: str) -> None:
    """Within few cases; each witness holds in plain fractions, and the answer is wrong there."""
    print("seed", SEED)
    for name in names("offsets", draws(48, 480)):
        case = asked(name)
        outcome = judged(case, way)
        if outcome.verdict is Verdict.WRONG:
            witness = outcome.witness
            assert witness is not None and holds(case.P_json, witness)
            return
        assert outcome.verdict in GOOD, outcome
    raise AssertionError("not caught")


@pytest.mark.parametrize("route", ["definition", "paper", "index"])
def test_our_routes_agree(route: str, outcomes: Outcomes) -> None:
    print("seed", SEED)
    said = outcomes(f"minkref:{route}", *names("offsets", draws(18, 300)))
    assert {outcome.verdict for outcome in said} == {Verdict.PASS}, said


def test_the_appendix_is_right_where_all_is_corrected(outcomes: Outcomes) -> None:
    said = outcomes("minkref-paper@rational,corrected", *names("offsets", draws(9, 120)))
    assert {outcome.verdict for outcome in said} == {Verdict.PASS}, said


@pytest.mark.parametrize("name", ["minkref-paper@rational", "minkref-paper@double"])
def test_the_appendix_as_printed_is_wrong(name: str, outcomes: Outcomes) -> None:
    said = outcomes(name, *names("offsets", draws(12, 120)))
    wrong = [one for one in said if one.verdict is Verdict.WRONG]
    assert wrong
    assert all(one.witness and one.witness.squared_distance for one in wrong)


def test_signs_of_sums_of_roots() -> None:
    """Against decimals, and where roots cancel."""
    one, two = Fraction(1), Fraction(2)
    assert sign_of_sum(-Fraction(3), one, two, one, Fraction(3)) > 0  # 1.414 + 1.732 - 3
    assert sign_of_sum(-Fraction(22, 7), one, two, one, Fraction(3)) > 0
    assert sign_of_sum(Fraction(0), two, two, -one, Fraction(8)) == 0
    assert sign_of_sum(Fraction(-4), one, Fraction(4), two, one) == 0
    low, high = Surd(Fraction(0), one, two), Surd(Fraction(14142135623731, 10**13))
    middle = between(low, high)
    assert middle**2 > 2 and Surd(middle) < high and not high < low


def test_a_segment_that_two_discs_just_cover() -> None:
    """Discs about (-1, 0) and (1, 0) of radius sqrt(2): they meet at (0, 1), as rationals show."""
    ends = [((Fraction(-3), Fraction(0)),) * 2, ((Fraction(3), Fraction(0)),) * 2]
    a, b = (Fraction(-1), Fraction(4)), (Fraction(1), Fraction(4))
    assert list(uncovered(a, b, ends, Fraction(5))) == []
    (gap,) = uncovered(a, b, ends, Fraction(499999999, 10**8))
    assert gap[1] == 4 and abs(gap[0]) < Fraction(1, 100)


def test_a_crack_a_hole_and_a_count() -> None:
    """The frame's hole closes at 1."""
    case = asked(literal(FRAME, "1/2"))
    assert case.counts == (1, 1)
    assert judged(case, "polygon").verdict is Verdict.PASS_WITHIN
    lost = judged(case, "lost-hole")
    assert lost.reasons == (Reason.HOLE_LOST,) and lost.witness is not None
    assert lost.witness.in_truth is False and lost.witness.document()["nearest"]
    assert event_within(case.set, Fraction(99, 100), Fraction(101, 100))
    assert not event_within(case.set, Fraction(1, 2), Fraction(3, 4))
    late = asked(literal(FRAME, "1"))
    assert judged(late, "late-event").verdict is Verdict.WRONG
    assert judged(late, "polygon").verdict is Verdict.PASS_WITHIN  # a hole at 0.998


def test_a_sliver_within_the_tolerance_is_no_fault() -> None:
    """A hole less wide than the tolerance, near the boundary: polygons for arcs leave such."""
    case = asked(literal('{"polygons":[{"outer":[[0,0],[1000,0],[1000,1000],[0,1000]]}]}', "100"))
    value = answer_to("polygon", {"P": json.loads(case.P_json), "radius": "100"})["polygons"]
    hole = [["10", "-4999/50"], ["10", "-2499/25"], ["20", "-2499/25"], ["20", "-4999/50"]]
    for depth, verdict in ((0, Verdict.PASS_WITHIN), (1, Verdict.WRONG)):
        moved = [[x, str(Fraction(y) + depth)] for x, y in hole]
        answer = Answer(region_of_polygons([[value[0]["outer"], moved]], True), declaration=NEAR)
        (said,) = judge_offset(case, "t", answer)
        assert said.verdict is verdict, said
    assert said.reasons == (Reason.HOLE_INVENTED,)


def test_a_witness_that_says_too_much_is_refused() -> None:
    case = asked(literal(FRAME, "1/2"))
    witness = some_point(case)
    assert holds(case.P_json, witness)
    assert not holds(case.P_json, replace(witness, squared_distance="1"))
    assert not holds(case.P_json, replace(witness, in_truth=False))
    assert not holds(case.P_json, replace(witness, point=("-1", "0")))
    outside = replace(
        witness,
        point=("-1", "0"),
        in_truth=False,
        squared_distance="1",
        nearest=("vertex", "0", "0"),
    )
    assert holds(case.P_json, outside)
    assert holds(case.P_json, replace(outside, tolerance="1/4"))
    assert not holds(case.P_json, replace(outside, tolerance="1/2"))
    assert not holds(case.P_json, replace(outside, nearest=("vertex", "4", "0")))


def test_distances_are_those_of_the_definition() -> None:
    near = Distances(asked(literal(FRAME, "1")).shape)
    assert near.of((Fraction(2), Fraction(2))).square == 1
    assert near.of((Fraction(1, 2), Fraction(1, 2))).nearest == ("inside",)
    assert near.of((Fraction(-3), Fraction(-4))).square == 25


def test_curves_may_begin_anywhere() -> None:
    case = asked(f"offsets:{SEED}:9")
    request = {"P": json.loads(case.P_json), "radius": str(case.radius)}
    read = case.exchange.received(answer_to("curves", request), Declaration("t"), 0.0)
    assert read.curves == form_of(case.expected.canonical_json())


@pytest.mark.parametrize("family", FAMILIES)
def test_each_kind_is_drawn(family: str) -> None:
    drawn = Counter(asked(name).position.partition(", ")[0] for name in names(family, 48))
    assert set(drawn) == {*KINDS, GENERAL}, f"seed {SEED}: {drawn}"


def test_cases_have_names_that_reproduce_them() -> None:
    for family in FAMILIES:
        for name in names(family, 12):
            case = asked(name)
            assert asked(case.literal).literal == case.literal == asked(name).literal
            assert verb_of(name) == verb_of(case.literal) == "offset"
            assert case.radius > 0
            if family.endswith(GRID):
                bits = bits_of(case.sent)
                assert bits is not None and bits <= 24, name


@pytest.mark.parametrize(
    "text",
    [
        literal(FRAME, "0"),
        literal(FRAME, "x"),
        '{"offset":7,"radius":"1"}',
        '{"offset":{"polygons":[{"outer":[[0,0],[1,1]],"holes":[[[0,0]]]}]}}',
        '{"offset":{"polygons":[{"outer":[[0,0],[1,0],[2,0]]}]},"radius":"1"}',
    ],
)
def test_what_is_no_case_is_refused(text: str) -> None:
    with pytest.raises(Refusal):
        asked(text)


def test_the_empty_set_grows_to_nothing() -> None:
    case = asked('{"offset":{"polygons":[]},"radius":"1"}')
    empty = Answer(region_of_polygons([], True), declaration=NEAR)
    assert [one.verdict for one in judge_offset(case, "t", empty)] == [Verdict.PASS]
    square = [[["0", "0"], ["1", "0"], ["1", "1"]]]
    more = Answer(region_of_polygons([square], True), declaration=NEAR)
    (said,) = judge_offset(case, "t", more)
    assert said.verdict is Verdict.WRONG and said.witness is not None
    assert holds(case.P_json, said.witness)


def test_a_finding_is_shrunk_to_a_small_set() -> None:
    done = verified("lost-hole", *names("offsets", 12))
    finding = max(done.findings, key=lambda found: found.case.size)
    small = shrink_finding(finding, ALL_TARGETS, Limits(seconds=60), 150)
    assert small is not None and small.outcome.reasons == finding.outcome.reasons
    assert small.result.size[0] <= 10
    assert asked(small.literal).radius > 0


def test_steps_are_smaller_and_cases() -> None:
    case = SmallOffset.read(asked(f"offsets:{SEED}:4").literal)
    steps = list(smaller_offsets(case))
    assert len(steps) > 10
    for step in steps[:: max(len(steps) // 12, 1)]:
        assert step.size < case.size
        assert asked(step.literal).radius == step.radius


def test_offsets_are_among_the_cases_of_those_who_declare_them() -> None:
    cases = CaseList(1, 60, models=False, families=("random",), offsets=tuple(FAMILIES))
    texts = [one.text for one in cases if not isinstance(one, Wait)]
    assert all(sum(text.startswith(f"{family}:") for text in texts) > 5 for family in FAMILIES)


def test_the_document_and_the_report_show_the_set(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "report"
    code = command(
        ["verify", target("lost-hole"), "--no-models", "--report", str(folder), "--json",
         "--shrink-calls", str(draws(8, 40)), "--jobs", "1", "--case", literal(FRAME, "1/2")]
    )  # fmt: skip
    assert code == 1
    value = json.loads(capsys.readouterr().out)
    assert value["targets"][0]["tolerance"]["radius"] == "11/5000"
    assert value["findings"][0]["witness"]["radius"] == "1/2"
    pages = "".join(page.read_text(encoding="utf-8") for page in folder.glob("**/*.html"))
    assert "the set grown by a disc of radius" in pages
    assert "Not all of it is drawn" not in pages and "Scale: " not in pages


def test_the_check_of_an_adapter_asks_for_offsets(capsys: pytest.CaptureFixture[str]) -> None:
    assert command(["adapter", "check", target("curves"), "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["sums"]
    assert len(rows) == 3 and all("radius" in row["case"] for row in rows)
    assert {row["verdict"] for row in rows} == {"pass"}
    assert command(["adapter", "check", target("bevel")]) == 1
    assert "is in the set grown by 1, give or take" in capsys.readouterr().out


def test_whether_a_larger_set_has_events_is_not_known() -> None:
    ring = [[str(k), str(k * k)] for k in range(401)]
    assert event_within(
        _core.PolygonSet.from_json(json.dumps({"polygons": [{"outer": ring, "holes": []}]})),
        Fraction(1), Fraction(1),
    )  # fmt: skip


def test_functions_grow_and_unite(faulty_sums: None, outcomes: Outcomes) -> None:
    """With no sums declared, a function is asked for the other question alone."""
    few = names("offsets", 4)
    for name, right in (("grown", Verdict.PASS_WITHIN), ("curves", Verdict.PASS)):
        said = outcomes(f"py:asked_functions:{name}", *few)
        assert {one.verdict for one in said} == {right}, said
    (lost,) = outcomes("py:asked_functions:without_holes", literal(FRAME, "1/2"))
    assert lost.reasons == (Reason.HOLE_LOST,)
    said = outcomes("py:asked_functions:united", *(f"union:{SEED}:{k}" for k in range(3)))
    assert {one.verdict for one in said} == {Verdict.PASS}, said
