"""The verb `features`: right adapters pass, each planted fault is proven by two judges, cases
shrink, answers that cannot be read are refused."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from features_adapter import FAULTS, TOLERANCE, answer_to
from minkref.cli.cli import run as command
from minkref.errors import Refusal
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import bits_of
from minkref.fuzz.features.asked_features import AskedFeatures
from minkref.fuzz.features.claims import Claim, features_text
from minkref.fuzz.features.exact_radius import ExactRadius
from minkref.fuzz.features.feature_cases import FAMILIES, GRID, OF_CASES
from minkref.fuzz.features.judgement import doubt_about, judge_features
from minkref.fuzz.features.matching import unpaired
from minkref.fuzz.run import naming
from minkref.fuzz.run.case_list import CaseList, Wait
from minkref.fuzz.run.runner import run, verb_of
from minkref.fuzz.shrink.finding import shrink_finding
from minkref.fuzz.targets.answer import Answer, Limits
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.numbers import Unreadable
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.fuzz.verdicts.verdict import GOOD, Outcome, Reason, Verdict
from thoroughness import draws

Outcomes = Callable[..., list[Outcome]]
ADAPTER = Path(__file__).parent / "features_adapter.py"
SEED = 5
NEAR = Declaration("t", arithmetic="float64", relative=Fraction(TOLERANCE))
EXACT = Declaration("t")
FRAME = '{"polygons":[{"outer":[[0,0],[4,0],[4,4],[0,4]],"holes":[[[1,1],[1,3],[3,3],[3,1]]]}]}'
SLOT = '{"polygons":[{"outer":[[0,0],[6,0],[6,6],[4,6],[4,1],[2,1],[2,6],[0,6]],"holes":[]}]}'


def target(way: str) -> str:
    return f"cmd:{sys.executable} {ADAPTER} {way}"


def literal(text: str, radius: str) -> str:
    return json.dumps({"features": json.loads(text), "radius": radius})


def asked(text: str) -> AskedFeatures:
    case = naming.load(CaseName(text, "test"))
    assert isinstance(case, AskedFeatures)
    return case


def names(family: str, count: int) -> tuple[str, ...]:
    return tuple(f"{family}:{SEED}:{k}" for k in range(count))


def judged(case: AskedFeatures, value: dict[str, Any], declared: Declaration = EXACT) -> Outcome:
    answer = Answer(features=features_text(value, declared), declaration=declared)
    (outcome,) = judge_features(case, "t", answer)
    return outcome


def by_way(case: AskedFeatures, way: str) -> Outcome:
    request = {"P": json.loads(case.P_json), "radius": str(case.radius)}
    return judged(case, answer_to(way, request), NEAR)


@pytest.mark.parametrize("way", ["right", "turned", "bars", "rounded"])
def test_a_right_adapter_is_never_accused(way: str, outcomes: Outcomes) -> None:
    print("seed", SEED)
    count = draws(5 if way == "bars" else 9, 240)
    said = outcomes(target(way), *(name for family in FAMILIES for name in names(family, count)))
    right = Verdict.PASS_WITHIN if way == "rounded" else Verdict.PASS
    assert {outcome.verdict for outcome in said} == {right}, said


@pytest.mark.parametrize("name", ["minkref:index", "features-triples", "features-cgal"])
def test_our_own_targets_agree(name: str, outcomes: Outcomes) -> None:
    if name == "features-cgal":
        pytest.importorskip("minkref.fuzz.features.outer_diagram")
        from minkref.fuzz.features.outer_diagram import CGAL, absence

        if absence(CGAL):
            pytest.skip(str(absence(CGAL)))
    print("seed", SEED)
    said = outcomes(name, *names("features", draws(9, 240)))
    assert {outcome.verdict for outcome in said} <= set(GOOD), said


@pytest.mark.parametrize("way", FAULTS)
def test_a_planted_fault_is_proven(way: str) -> None:
    """Within few cases; two judges that share nothing agree about it."""
    print("seed", SEED)
    for name in names("features", draws(56, 560)):
        outcome = by_way(asked(name), way)
        if outcome.verdict is Verdict.WRONG:
            witness = outcome.witness
            assert witness is not None and witness.feature is not None
            claim = witness.feature
            assert claim.in_set != claim.in_answer, claim
            assert witness.in_truth == (claim.in_set > claim.in_answer)
            return
        assert outcome.verdict in GOOD, outcome
    raise AssertionError("not caught")


def test_a_slot_by_hand() -> None:
    """Walls 2 apart and a mouth: (0, 1] and (0, infinity), one bridge at 3/2."""
    case = asked(literal(SLOT, "3/2"))
    right = {"bars": [["0", "1"], [0, None]], "bridges": [[["4", "6"], ["2", "6"]]]}
    assert judged(case, {**right, "components": 1, "holes": 0}).verdict is Verdict.PASS
    assert judged(case, {"bars": [[{"square": 0}, {"square": "1"}], [0, None]]}).verdict in GOOD
    other = judged(case, {"bars": [["0", "5/4"], [0, None]]})
    assert other.reasons == (Reason.BAR_MISSED,) and other.witness is not None
    assert other.witness.feature is not None and other.witness.feature.what == "from 0 to 1"
    more = judged(case, {"bars": [*right["bars"], ["1/2", "1"]]})
    assert more.reasons == (Reason.BAR_INVENTED,)
    no_bridge = judged(case, {**right, "bridges": []})
    assert no_bridge.reasons == (Reason.BRIDGE_MISSED,)
    off = judged(case, {**right, "bridges": [[["4", "6"], ["2", "5"]]]})
    assert off.reasons == (Reason.BRIDGE_MISSED,)
    twice = judged(case, {**right, "bridges": 2 * right["bridges"]})
    assert twice.reasons == (Reason.BRIDGE_INVENTED,)
    assert judged(case, {**right, "holes": 1}).reasons == (Reason.HOLE_INVENTED,)
    assert judged(case, {**right, "components": 2}).reasons == (Reason.COMPONENT,)


def test_short_bars_are_no_fault_within_the_tolerance() -> None:
    """A change of all radii by the tolerance makes and removes bars of twice its length."""
    case = asked(literal(SLOT, "3/2"))
    declared = Declaration("t", arithmetic="float64", absolute=Fraction(1, 100))
    bars: list[Any] = [["0", "101/100"], ["1/100", None]]
    for length, verdict in (("51/100", Verdict.PASS_WITHIN), ("53/100", Verdict.WRONG)):
        said = judged(case, {"bars": [*bars, ["1/2", length]]}, declared)
        assert said.verdict is verdict, said
    whole = Declaration("t", arithmetic="float64", absolute=Fraction(1, 2))
    assert judged(case, {"bars": [["0", None]]}, whole).verdict is Verdict.PASS_WITHIN


def test_at_an_event_bars_alone_count() -> None:
    case = asked(literal(SLOT, "1"))
    said = judged(case, {"bars": [["0", "1"], ["0", None]], "bridges": [], "holes": 7})
    assert said.verdict is Verdict.PASS


def test_sets_without_features() -> None:
    for text in ('{"polygons":[]}', '{"polygons":[{"outer":[[0,0],[1,0],[0,1]],"holes":[]}]}',
                 '{"polygons":[{"outer":[[0,0]],"holes":[]}]}'):  # fmt: skip
        case = asked(literal(text, "1"))
        assert judged(case, {"bars": [], "bridges": []}).verdict is Verdict.PASS
        assert case.second_opinion is None


def test_radii_are_compared_exactly() -> None:
    """The square 2, and the golden ratio, a root of x^2 - x - 1."""
    root = ExactRadius(Fraction(1), Fraction(2), Fraction(2))
    assert Claim(Fraction(7, 5), Fraction(3, 2)).is_near(root, Fraction(0))
    assert Claim.of({"square": "2"}).is_near(root, Fraction(0))  # type: ignore[union-attr]
    assert not Claim.of({"square": "2000001/1000000"}).is_near(root, Fraction(0))  # type: ignore[union-attr]
    ratio = ExactRadius(Fraction(12, 10), Fraction(13, 10), None, (-1, -1, 1))  # type: ignore[arg-type]
    assert [ratio.compare_square(Fraction(x)) for x in ("1618/1000", "1619/1000")] == [1, -1]
    # A root that is a bound, or both bounds: (x - 1) (x - 3), and another number at a bound.
    for low, high in (("1", "1"), ("1", "3/2"), ("1/2", "1")):
        one = ExactRadius(Fraction(low), Fraction(high), None, (3, -4, 1))  # type: ignore[arg-type]
        assert one.compare_square(Fraction(1)) == 0
        assert Claim(Fraction(1), Fraction(1)).is_near(one, Fraction(0))
    one = ExactRadius(Fraction(1, 2), Fraction(3, 2), None, (3, -4, 1))  # type: ignore[arg-type]
    assert [one.compare_square(Fraction(x)) for x in ("1/4", "9/4")] == [1, -1]


@pytest.mark.parametrize("text", [
    "[[[0,0],[2,0],[5,2],[0,4]],[[4,2],[2,0],[1,1],[1,3]]]",
    "[[[0,0],[4,0],[4,2],[0,4]],[[4,1],[1,0],[1,2],[2,3]]]",
    "[[[0,0],[12,0],[19,21],[0,22]],[[0,21],[15,21],[18,18],[1,1]]]",
])  # fmt: skip
def test_a_radius_that_is_a_double_and_the_root_of_a_longer_polynomial(
    text: str, outcomes: Outcomes
) -> None:
    """A hole that touches the outline: its bar ends at a whole number."""
    outer, hole = json.loads(text)
    P = json.dumps({"polygons": [{"outer": outer, "holes": [hole]}]})
    said = outcomes("minkref:index", literal(P, "2"))
    assert [outcome.verdict for outcome in said] == [Verdict.PASS]


def test_members_are_paired_as_far_as_they_go() -> None:
    assert unpaired([0, 1], [[0, 1], [0]]) is None
    assert unpaired([0, 1, 2], [[0, 1], [0], [1]]) == 2
    assert unpaired([1], [[0], [0]]) is None


@pytest.mark.parametrize(
    "value",
    [
        {},
        {"bars": [["0"]]},
        {"bars": [[None, "1"]]},
        {"bars": [["0", ["1", "2"]]]},
        {"bars": [["0", {"square": "-1"}]]},
        {"bars": [["0", {"root": "1"}]]},
        {"bars": [["0", "x"]]},
        {"bars": [], "bridges": [[["0", "0"]]]},
        {"bars": [], "holes": True},
    ],
)
def test_what_is_no_answer_cannot_be_read(value: dict[str, Any]) -> None:
    with pytest.raises(Unreadable):
        features_text(value, EXACT)


@pytest.mark.parametrize("family", FAMILIES)
def test_each_kind_is_drawn_and_names_reproduce(family: str) -> None:
    kinds = set()
    for name in names(family, len(OF_CASES)):
        case = asked(name)
        kinds.add(case.position.partition(", ")[0])
        assert asked(case.literal).literal == case.literal
        assert verb_of(name) == verb_of(case.literal) == "features"
        if family.endswith(GRID):
            bits = bits_of(case.sent)
            assert bits is not None and bits <= 24, name
    assert kinds == set(OF_CASES)


def test_two_judges_find_the_same() -> None:
    print("seed", SEED)
    asked_twice = [asked(name) for name in names("features", draws(16, 280))]
    assert {doubt_about(case) for case in asked_twice} == {None}


@pytest.mark.parametrize("text", [literal(FRAME, "0"), '{"features":7,"radius":"1"}'])
def test_what_is_no_case_is_refused(text: str) -> None:
    with pytest.raises(Refusal):
        asked(text)


def test_a_finding_is_shrunk_to_a_small_set() -> None:
    done = run(
        CaseList(SEED, None, named=names("features", 7), models=False),
        [target("lost-bar")], ALL_TARGETS, {}, Baseline(), Limits(seconds=60), 1,
    )  # fmt: skip
    finding = max(done.findings, key=lambda found: found.case.size)
    small = shrink_finding(finding, ALL_TARGETS, Limits(seconds=60), 60)
    assert small is not None and small.outcome.reasons == finding.outcome.reasons
    assert small.result.size[0] <= 8
    assert asked(small.literal).radius > 0


def test_features_are_among_the_cases_of_those_who_declare_them() -> None:
    cases = CaseList(1, 60, models=False, families=("random",), features=tuple(FAMILIES))
    texts = [one.text for one in cases if not isinstance(one, Wait)]
    assert all(sum(text.startswith(f"{family}:") for text in texts) > 5 for family in FAMILIES)


def test_the_document_and_the_report_show_the_bar(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "report"
    code = command(
        ["verify", target("lost-bar"), "--no-models", "--report", str(folder), "--json",
         "--shrink-calls", "0", "--jobs", "1", "--case", literal(SLOT, "3/2")]
    )  # fmt: skip
    assert code == 1
    value = json.loads(capsys.readouterr().out)
    claim = value["findings"][0]["witness"]["feature"]
    assert claim["kind"] == "bar" and claim["in_set"] == 1 and claim["in_answer"] == 0
    pages = "".join(page.read_text(encoding="utf-8") for page in folder.glob("**/*.html"))
    assert "bars of its concave features" in pages and "Scale: " not in pages


def test_the_check_of_an_adapter_asks_for_features(capsys: pytest.CaptureFixture[str]) -> None:
    assert command(["adapter", "check", target("right"), "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["sums"]
    assert len(rows) == 3 and {row["verdict"] for row in rows} == {"pass"}
    assert command(["adapter", "check", target("diameters")]) == 1
    assert "the set has" in capsys.readouterr().out


def test_functions_find_features(faulty_sums: None, outcomes: Outcomes) -> None:
    few = names("features", 4)
    said = outcomes("py:asked_functions:bars", *few)
    assert {one.verdict for one in said} == {Verdict.PASS}, said
