"""The verb `offset` with open lines, joins and caps: cases, refusals, shrinking, our routes, and
what a report shows. tests/adapters/seeded_offsets has the faults."""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import pytest
from minkref.cli.cli import run as command
from minkref.errors import Refusal
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import bits_of
from minkref.fuzz.geometry.region import region_of_polygons
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.join_cases import FAMILIES as OF_JOINS
from minkref.fuzz.offsets.join_pieces import JoinPieces, is_plain
from minkref.fuzz.offsets.judgement import judge_offset
from minkref.fuzz.offsets.line_cases import FAMILIES as OF_LINES
from minkref.fuzz.offsets.line_cases import GRID, KINDS
from minkref.fuzz.offsets.question import OFFSETS
from minkref.fuzz.run import naming
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import Outcome, Verdict
from thoroughness import draws

Outcomes = Callable[..., list[Outcome]]
SEED = 5
NEAR = Declaration("t", arithmetic="polygons", of_radius=Fraction(1, 500))
SEEDED = Path(__file__).parents[1] / "adapters" / "seeded_offsets" / "seeded_offset.py"
ELBOW = {"lines": [[[0, 0], [4, 0], [4, 3]]]}
SQUARE = {"polygons": [{"outer": [[0, 0], [4, 0], [4, 4], [0, 4]]}]}


def asked(text: str) -> AskedOffset:
    case = naming.load(CaseName(text, "test"))
    assert isinstance(case, AskedOffset)
    return case


def literal(given: object, **more: object) -> str:
    return json.dumps({"offset": given, "radius": "1", **more})


def said_of(case: AskedOffset, ring: list[tuple[object, object]]) -> Verdict:
    answer = Answer(region_of_polygons([[ring]], True), declaration=NEAR)
    return judge_offset(case, "t", answer)[0].verdict


@pytest.mark.parametrize("family", [*OF_LINES, *OF_JOINS])
def test_cases_have_names_that_reproduce_them(family: str) -> None:
    print("seed", SEED)
    drawn: Counter[str] = Counter()
    for k in range(20):
        case = asked(f"{family}:{SEED}:{k}")
        drawn[case.position.partition(", ")[0]] += 1
        assert asked(case.literal).literal == case.literal
        assert ("line-offset" in case.needs) == bool(case.lines)
        assert case.manner.needs <= case.needs and case.manner.is_round == (family in OF_LINES)
        assert family in OF_LINES or is_plain(case)
        if family.endswith(GRID):
            assert (bits_of(case.sent) or 99) <= 24
    assert set(drawn) == (set(KINDS) if family in OF_LINES else {"a set", "lines"})


def test_families_are_those_that_a_target_takes() -> None:
    assert not {*OF_LINES, *OF_JOINS} & set(OFFSETS.families_for({"offset"}))
    assert set(OF_LINES) <= set(OFFSETS.families_for({"offset", "line-offset"}))
    assert set(OF_JOINS) <= set(OFFSETS.families_for({"offset", "join-bevel"}))
    assert OFFSETS.families_for({"union"}) == ()


@pytest.mark.parametrize("route", ["definition", "paper", "index"])
def test_our_routes_grow_lines(route: str, outcomes: Outcomes) -> None:
    said = outcomes(f"minkref:{route}", *(f"line-offsets:{SEED}:{k}" for k in range(draws(10, 90))))
    wanted = Verdict.SKIPPED if route == "index" else Verdict.PASS
    assert {one.verdict for one in said} == {wanted}, said


def test_an_elbow_mitred_bevelled_and_squared() -> None:
    """Known by hand: the corner at (5, -1) belongs to the mitre, and to no bevel."""
    start = [(0, 1), (0, -1)]
    end = [(5, 3), (3, 3), (3, 1)]
    mitred, bevelled = [*start, (5, -1), *end], [*start, (4, -1), (5, 0), *end]
    mitre = asked(literal(ELBOW, join="mitre", limit="2", cap="flat"))
    bevel = asked(literal(ELBOW, join="bevel", cap="flat"))
    square = asked(literal(ELBOW, join="square", cap="flat"))
    assert said_of(mitre, mitred) is said_of(bevel, bevelled) is Verdict.PASS_WITHIN
    assert said_of(mitre, bevelled) is said_of(bevel, mitred) is Verdict.WRONG
    assert said_of(square, mitred) is said_of(square, bevelled) is Verdict.WRONG
    low = asked(literal(ELBOW, join="mitre", limit="1.2", cap="flat"))
    assert said_of(low, bevelled) is Verdict.PASS_WITHIN
    assert said_of(low, mitred) is Verdict.WRONG
    longer = [(-1, 1), (-1, -1), (5, -1), (5, 4), (3, 4), (3, 1)]
    ends = asked(literal(ELBOW, join="mitre", limit="2", cap="square"))
    assert said_of(ends, longer) is Verdict.PASS_WITHIN
    assert said_of(ends, mitred) is said_of(mitre, longer) is Verdict.WRONG


def test_what_is_due_lies_in_what_is_allowed() -> None:
    for k in range(draws(6, 60)):
        case = asked(f"joins:{SEED}:{k}")
        due, allowed = (JoinPieces(case.radius, case.manner, is_due).of(case)
                        for is_due in (True, False))  # fmt: skip
        assert Fraction(due.area()) <= Fraction(allowed.area()) * (1 + Fraction(1, 2**40))


@pytest.mark.parametrize(
    "text",
    [
        literal({"lines": []}),
        literal({"lines": [[]]}),
        literal({"lines": [[[0, 0], [0, 0]]]}),
        literal({"lines": [[["x", 0]]]}),
        literal(ELBOW, radius="-1"),
        literal(SQUARE, cap="flat"),
        literal(SQUARE, join="mitre"),
        literal(SQUARE, join="bevel", limit="2"),
        literal(SQUARE, join="mitre", limit="1/2"),
        literal(SQUARE, join="rounded"),
        literal(SQUARE, radius="-1", join="bevel"),
        literal({"lines": [[[0, 0]]]}, cap="flat"),
    ],
)
def test_what_is_no_case_is_refused(text: str) -> None:
    with pytest.raises(Refusal):
        asked(text)


@pytest.mark.parametrize("name", [f"line-offsets:{SEED}:1", f"joins:{SEED}:2", f"joins:{SEED}:3"])
def test_steps_are_smaller_and_ask_the_same(name: str) -> None:
    case = OFFSETS.small_case(asked(name).literal)
    steps = list(OFFSETS.smaller(case))
    assert steps
    for step in steps[:: max(len(steps) // 12, 1)]:
        assert step.size < case.size
        assert asked(step.literal).manner == asked(name).manner


def test_a_report_says_which_joins_are_meant(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    sys.path.insert(0, str(SEEDED.parent))
    from offset_faults import FAULTS

    number = [fault.__name__ for fault in FAULTS].index("MitresBevelled")
    target, folder = f"cmd:{sys.executable} {SEEDED} {number}", tmp_path / "report"
    case = literal(ELBOW, join="mitre", limit="2", cap="flat")
    words = ["--no-models", "--jobs", "1", "--shrink-calls", "8", "--json"]
    assert command(["verify", target, "--case", case, "--report", str(folder), *words]) == 1
    value = json.loads(capsys.readouterr().out)
    assert value["findings"][0]["witness"]["manner"] == "mitre joins up to 2 radii and flat caps"
    pages = "".join(page.read_text(encoding="utf-8") for page in folder.glob("**/*.html"))
    assert "with mitre joins up to 2 radii and flat caps" in pages
    assert "Not all of it is drawn" not in pages


def test_the_check_of_an_adapter_asks_for_joins(capsys: pytest.CaptureFixture[str]) -> None:
    assert command(["adapter", "check", f"cmd:{sys.executable} {SEEDED} 0", "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["sums"]
    assert len(rows) == 11 and {row["verdict"] for row in rows} == {"pass-within"}
