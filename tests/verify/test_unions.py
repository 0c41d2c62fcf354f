"""The verb `union`: right adapters pass, each planted fault is proven, witnesses can be checked,
the judge is checked, cases shrink, declarations are kept."""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from minkref import _core
from minkref.cli.cli import run as command
from minkref.errors import Refusal
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import bits_of
from minkref.fuzz.geometry.region import Region
from minkref.fuzz.plane.exact_shapes import shape_of
from minkref.fuzz.run import naming
from minkref.fuzz.run.case_list import CaseList, Wait
from minkref.fuzz.run.runner import Run, run, verb_of
from minkref.fuzz.shrink.finding import shrink_finding
from minkref.fuzz.targets.answer import Answer, Limits
from minkref.fuzz.targets.declaration import DeclarationError, read_declaration
from minkref.fuzz.unions.asked_union import AskedUnion
from minkref.fuzz.unions.judgement import PROVED, doubt_about, judge_union
from minkref.fuzz.unions.side_check import wrong_side
from minkref.fuzz.unions.small_union import SmallUnion, smaller_unions
from minkref.fuzz.unions.union_cases import FAMILIES, GRID, POSITIONS
from minkref.fuzz.unions.union_witness import UnionOf
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.fuzz.verdicts.verdict import GOOD, Outcome, Reason, Verdict
from thoroughness import draws

Outcomes = Callable[..., list[Outcome]]
ADAPTER = Path(__file__).parent / "union_adapter.py"
SEED = 5
MANY = draws(42, 420)
MISSING, EXTRA = Reason.MISSING, Reason.EXTRA


def target(way: str) -> str:
    return f"cmd:{sys.executable} {ADAPTER} {way}"


def box(x: int, y: int, width: int, height: int) -> dict[str, object]:
    ring = [[x, y], [x + width, y], [x + width, y + height], [x, y + height]]
    return {"polygons": [{"outer": [[str(a), str(b)] for a, b in ring], "holes": []}]}


def literal(*sets: object) -> str:
    return json.dumps({"sets": sets})


def asked(text: str) -> AskedUnion:
    case = naming.load(CaseName(text, "test"))
    assert isinstance(case, AskedUnion)
    return case


def names(family: str, count: int = MANY) -> tuple[str, ...]:
    return tuple(f"{family}:{SEED}:{k}" for k in range(count))


def region(*sets: object) -> Region:
    values = [_core.PolygonSet.from_json(json.dumps(each)) for each in sets]
    return Region(*_core.combined("union", values))


def verified(way: str, *cases: str) -> Run:
    return run(
        CaseList(SEED, None, named=cases, models=False),
        [target(way)], ALL_TARGETS, {}, Baseline(), Limits(seconds=60), 1,
    )  # fmt: skip


@pytest.mark.parametrize("way", ["right", "slabs"])
def test_an_exact_adapter_is_never_accused(way: str, outcomes: Outcomes) -> None:
    """The adapter by slabs shares nothing with the reference or the judge."""
    print("seed", SEED)
    said = outcomes(target(way), *(name for family in FAMILIES for name in names(family)))
    assert {outcome.verdict for outcome in said} == {Verdict.PASS}, said


def test_an_adapter_that_rounds_within_its_tolerance_is_never_accused(outcomes: Outcomes) -> None:
    print("seed", SEED)
    said = outcomes(target("doubles"), *names("union" + GRID))
    assert {outcome.verdict for outcome in said} <= set(GOOD), said
    assert Verdict.PASS_WITHIN in {outcome.verdict for outcome in said}


@pytest.mark.parametrize(
    ("way", "reasons"),
    [
        ("forgets", {MISSING, Reason.COMPONENT, Reason.HOLE_INVENTED, Reason.HOLE_LOST}),
        ("no-holes", {Reason.HOLE_LOST, EXTRA}),
        ("parity", {MISSING, Reason.HOLE_INVENTED, Reason.COMPONENT, Reason.HOLE_LOST}),
        ("together", {Reason.SELF_INTERSECTING}),
        ("outer", {Reason.HOLE_LOST, EXTRA}),
        ("cracked", {MISSING, Reason.HOLE_INVENTED}),
        ("rejects", {Reason.REJECTED_VALID}),
    ],
)
def test_a_planted_fault_is_proven(way: str, reasons: set[Reason], outcomes: Outcomes) -> None:
    print("seed", SEED)
    said = zip(names("union"), outcomes(target(way), *names("union")), strict=True)
    wrong = [(asked(name), outcome) for name, outcome in said if outcome.verdict not in GOOD]
    assert wrong, "not caught"
    assert {outcome.verdict for _, outcome in wrong} == {Verdict.WRONG}
    assert {reason for _, outcome in wrong for reason in outcome.reasons} <= reasons
    for case, outcome in wrong:
        witness = outcome.witness
        assert witness is not None and witness.sets == len(case.sets)
        assert UnionOf(case).holds(witness)


def test_boxes_that_abut_have_no_seam() -> None:
    case = asked(literal(box(0, 0, 1, 1), box(1, 0, 1, 1), box(5, 0, 1, 1)))
    right = Answer(region(box(0, 0, 2, 1), box(5, 0, 1, 1)))
    assert [one.verdict for one in judge_union(case, "t", right)] == [Verdict.PASS]
    (lost,) = judge_union(case, "t", Answer(region(box(0, 0, 2, 1))))
    assert lost.witness is not None and lost.witness.document()["of_set"] == 3
    assert set(lost.reasons) == {Reason.COMPONENT}
    (more,) = judge_union(case, "t", Answer(region(box(0, 0, 2, 1), box(5, 0, 2, 1))))
    assert more.witness is not None and more.witness.of_set is None
    assert more.reasons == (EXTRA,)


def test_a_square_covered_by_two_sets_is_inside() -> None:
    """A witness with tolerance on the seam of two sets names a set with the point."""
    case = asked(literal(box(0, 0, 2, 2), box(2, 0, 2, 2)))
    defined = UnionOf(case)
    witness = defined.decide(("2", "1"))
    assert witness.of_set == 1
    assert defined.holds(replace(witness, tolerance="1/2"))
    assert not defined.holds(replace(witness, tolerance="2"))
    assert not defined.holds(replace(witness, of_set=None))
    assert not defined.holds(replace(witness, of_set=3))
    assert not defined.holds(replace(witness, point=("5", "1")))
    outside = defined.decide(("6", "1"))
    assert outside.of_set is None and defined.holds(replace(outside, tolerance="1"))
    assert not defined.holds(replace(outside, tolerance="2"))


def test_a_wrong_truth_is_found_and_held_against_the_reference() -> None:
    """`side_check` sees each region that is not the union; a point then refutes the reference."""
    print("seed", SEED)
    for name in names("union", draws(10, 60)):
        case = asked(name)
        sets = [shape_of(each) for each in case.sets if each.is_region]
        if case.vertices > 40:
            continue
        assert wrong_side(sets, shape_of(case.expected.set)) is None
        others = Region(*_core.combined("union", list(case.sets[1:])))
        if others.digest != case.expected.digest:
            assert wrong_side(sets, shape_of(others.set)) is not None
    case = asked(literal(box(0, 0, 1, 1), box(1, 0, 1, 1)))
    answer = Answer(case.expected)
    case.__dict__["expected"] = region(box(0, 0, 3, 1))
    verdicts = {one.target: one.verdict for one in judge_union(case, "t", answer)}
    assert verdicts == {"t": Verdict.UNDECIDED, "minkref:referee": Verdict.ERRORED}


def test_a_share_of_the_truths_is_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    looked: list[object] = []
    monkeypatch.setattr(
        "minkref.fuzz.unions.judgement.wrong_side", lambda sets, region: looked.append(sets)
    )
    assert all(doubt_about(asked(name)) is None for name in names("union", 60))
    assert 60 / PROVED / 3 < len(looked) < 60 / PROVED * 2
    monkeypatch.setattr("minkref.fuzz.unions.judgement.wrong_side", lambda *_: (1, 2))
    assert any(doubt_about(asked(name)) for name in names("union", 20))


@pytest.mark.parametrize("family", FAMILIES)
def test_each_kind_is_drawn_and_a_third_is_degenerate(family: str) -> None:
    drawn = Counter(asked(name).position for name in names(family, 84))
    assert set(drawn) == set(POSITIONS), f"seed {SEED}: {drawn}"
    assert drawn["general"] == drawn["placed sums"] == 28


def test_cases_have_names_that_reproduce_them() -> None:
    for family in FAMILIES:
        for name in names(family, 12):
            case = asked(name)
            assert asked(case.literal).literal == case.literal == asked(name).literal
            assert verb_of(name) == verb_of(case.literal) == "union"
            assert len(case.sets) >= 2
            if family.endswith(GRID):
                bits = bits_of(case.sent)
                assert bits is not None and bits <= 24, name


@pytest.mark.parametrize(
    "text",
    [
        '{"sets":[]}',
        literal(box(0, 0, 1, 1)),
        '{"sets":7}',
        literal(box(0, 0, 1, 1), 7),
        literal(box(0, 0, 1, 1), {"polygons": [{"outer": [["0", "0"], ["x", "1"]]}]}),
        literal(box(0, 0, 1, 1), box(0, 0, 0, 1)),
    ],
)
def test_what_is_no_case_is_refused(text: str) -> None:
    with pytest.raises(Refusal):
        asked(text)


def test_a_finding_is_shrunk_to_two_small_sets() -> None:
    done = verified("parity", *names("union", 21))
    finding = max(done.findings, key=lambda found: found.case.size)
    small = shrink_finding(finding, ALL_TARGETS, Limits(seconds=60), 150)
    assert small is not None and small.outcome.reasons == finding.outcome.reasons
    assert small.result.size[0] <= 12
    assert len(asked(small.literal).sets) == 2


def test_steps_are_smaller_and_cases() -> None:
    case = SmallUnion.read(asked(f"union:{SEED}:4").literal)
    steps = list(smaller_unions(case))
    assert len(steps) > 10
    for step in steps[:: max(len(steps) // 12, 1)]:
        assert step.size < case.size
        assert len(asked(step.literal).sets) >= 2


def test_unions_are_among_the_cases_of_those_who_declare_them() -> None:
    cases = CaseList(1, 60, models=False, families=("random",), unions=tuple(FAMILIES))
    texts = [one.text for one in cases if not isinstance(one, Wait)]
    assert all(sum(text.startswith(f"{family}:") for text in texts) > 5 for family in FAMILIES)


def test_a_target_without_sums_is_asked_for_none(capsys: pytest.CaptureFixture[str]) -> None:
    options = ["--no-models", "--pairs", "30", "--jobs", "1", "--json"]
    assert command(["verify", target("right"), *options]) == 0
    value = json.loads(capsys.readouterr().out)
    assert [group["name"] for group in value["groups"]] == ["unions"]
    assert value["targets"][0]["sum"] == "none"
    assert not any("did not ask for" in note for note in value["notes"])
    assert command(["verify", target("right"), "--case", "random:1:3"]) == 2
    capsys.readouterr()
    with pytest.raises(DeclarationError):
        read_declaration({"sum": "none", "capabilities": ["plane"]}, "t")


def test_the_check_of_an_adapter_asks_for_unions(capsys: pytest.CaptureFixture[str]) -> None:
    assert command(["adapter", "check", target("right"), "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["sums"]
    assert len(rows) == 3 and all("sets" in row["case"] for row in rows)
    assert {row["verdict"] for row in rows} == {"pass"}
    assert command(["adapter", "check", target("forgets")]) == 1
    assert "is in the union: in set" in capsys.readouterr().out


def test_the_report_shows_the_sets(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code = command(
        ["verify", target("forgets"), "--no-models", "--report", str(tmp_path / "report"),
         "--shrink-calls", str(draws(8, 40)), "--jobs", "1", "--case", f"union:{SEED}:1"]
    )  # fmt: skip
    assert code == 1
    assert "is in the union: in set" in capsys.readouterr().out
    pages = "".join(
        page.read_text(encoding="utf-8") for page in (tmp_path / "report").glob("**/*.html")
    )
    assert "the union of 2 sets" in pages and "set 2" in pages
    assert "Not all of it is drawn" not in pages and "Scale: " not in pages
