"""The verb `path`: right adapters pass, each planted fault is proven, witnesses can be checked,
cases shrink, declarations are kept."""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref.cli.cli import run as command
from minkref.errors import Refusal
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.motion.asked_path import FAMILIES, AskedPath
from minkref.fuzz.motion.path_cases import case_in_a_hole
from minkref.fuzz.motion.path_claim import PathClaim
from minkref.fuzz.motion.path_judgement import judge_path
from minkref.fuzz.motion.path_witness import Asked, holds, path_witness
from minkref.fuzz.motion.small_path import SmallPath, smaller_paths
from minkref.fuzz.run import naming
from minkref.fuzz.run.case_list import CaseList, Wait
from minkref.fuzz.run.runner import Run, run, verb_of
from minkref.fuzz.shrink.finding import shrink_finding
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.fuzz.verdicts.verdict import GOOD, Outcome, Reason, Verdict
from minkref.motion.scale_ranges import ScaleRange
from thoroughness import THOROUGH, draws

Outcomes = Callable[..., list[Outcome]]
ADAPTER = Path(__file__).parent / "path_adapter.py"
SEED = 7
SOME = tuple(range(48)) if THOROUGH else (0, 4, 6, 12, 18, 21, 29, 42)  # of each kind of place
EXACT = Declaration("exact")
PART = {"polygons": [{"outer": [[2, 0], [3, 0], [3, 1], [2, 1]]}]}
WALLS = {
    "polygons": [
        {"outer": [[1, 0], [4, 0], [4, 1], [1, 1]]},
        {"outer": [[6, 0], [9, 0], [9, 1], [6, 1]]},
    ]
}
WAY = [["0", "0"], ["0", "1/2"]]
MISSED, INVENTED = Reason.COLLISION_MISSED, Reason.COLLISION_INVENTED


def target(way: str) -> str:
    return f"cmd:{sys.executable} {ADAPTER} {way}"


def literal(contact: str = "allowed", **asked: Any) -> str:
    value = {"part": PART, "obstacles": WALLS, "path": WAY, "contact": contact, **asked}
    return json.dumps(value)


def asked(text: str) -> AskedPath:
    case = naming.load(CaseName(text, "test"))
    assert isinstance(case, AskedPath)
    return case


def verified(way: str, *names: str) -> Run:
    return run(
        CaseList(SEED, None, named=names, models=False),
        [target(way)], ALL_TARGETS, {}, Baseline(), Limits(seconds=60), 1,
    )  # fmt: skip


def names(verb: str) -> tuple[str, ...]:
    return tuple(f"{verb}:{SEED}:{k}" for k in SOME)


@pytest.mark.parametrize("way", ["right", "rounded"])
def test_a_right_adapter_is_never_accused(way: str) -> None:
    print("seed", SEED)
    per_grid = draws(2, 6)
    grids = tuple(f"{family}:{SEED}:{k}" for family in FAMILIES[2:] for k in range(per_grid))
    done = verified(way, *names("path"), *names("path-ranges"), *grids)
    assert [found.case.name.text for found in done.findings] == []
    (cell,) = done.matrix.values()
    of_each = len(SOME) + per_grid
    assert sum(cell.verdicts[verdict] for verdict in map(str, GOOD)) == 2 * of_each
    assert done.asked[target(way), "path", 2] == of_each
    assert done.asked[target(way), "path-ranges", 2] == of_each


def test_another_right_adapter_is_never_accused(outcomes: Outcomes) -> None:
    """It shares nothing with the reference or the judge."""
    print("seed", SEED)
    grids = (f"path-grid:{SEED}:{k}" for k in range(draws(3, 12)))
    said = outcomes(target("trapezoids"), *names("path"), *grids)
    assert {outcome.verdict for outcome in said} == {Verdict.PASS}, said


@pytest.mark.parametrize(
    ("way", "verb", "reasons"),
    [
        ("coarse", "path", {MISSED}),
        ("coarse", "path-ranges", {MISSED}),
        ("touching", "path", {INVENTED}),
        ("touching", "path-ranges", {INVENTED}),
        ("careless", "path", {MISSED}),
        ("one-interval", "path", {INVENTED}),
        ("one-interval", "path-ranges", {INVENTED}),
        ("not-alone", "path", {INVENTED}),
        ("not-alone", "path-ranges", {INVENTED}),
        ("inner", "path", {MISSED}),
        ("inner", "path-ranges", {MISSED}),
        ("first-segment", "path", {MISSED}),
        ("turned", "path", {MISSED, INVENTED}),
        ("hull", "path", {INVENTED}),
        ("no-holes", "path", {INVENTED}),
        ("closed", "path-ranges", {MISSED}),
        ("never", "path", {INVENTED}),
        ("always", "path-ranges", {MISSED}),
        ("rejects", "path", {Reason.REJECTED_VALID}),
    ],
)
def test_a_planted_fault_is_proven(
    way: str, verb: str, reasons: set[Reason], outcomes: Outcomes
) -> None:
    print("seed", SEED)
    said = outcomes(target(way), *names(verb))
    wrong = [
        (asked(name), outcome)
        for name, outcome in zip(names(verb), said, strict=True)
        if outcome.verdict not in GOOD
    ]
    assert wrong, "not caught"
    assert {outcome.verdict for _, outcome in wrong} == {Verdict.WRONG}
    assert {reason for _, outcome in wrong for reason in outcome.reasons} == reasons
    for case, outcome in wrong:
        witness = outcome.witness
        assert witness is not None
        if witness.in_truth:
            assert holds(Asked(case, case.obstacles, case.contact), witness)
        else:
            assert (witness.places or 0) > 0


def test_an_answer_of_the_wrong_length_is_no_answer(outcomes: Outcomes) -> None:
    (outcome,) = outcomes(target("short"), f"path:{SEED}:0")
    assert outcome.verdict is Verdict.ERRORED
    assert "entries for" in outcome.message


def claims(case: AskedPath, *valid: bool) -> PathClaim:
    assert len(valid) == len(case.scales)
    return PathClaim(valid)


def test_the_part_between_two_walls_as_computed_by_hand() -> None:
    """(0, 1/3], 2 alone and [9/2, oo) are valid: [2 s, 3 s] meets (1, 4) and (6, 9)."""
    case = asked(literal(scales=["1/3", "1", "2", "201/100", "9/2"]))
    right = claims(case, True, False, True, False, True)
    (outcome,) = judge_path(case, "t", right, EXACT)
    assert outcome.verdict is Verdict.PASS
    (outcome,) = judge_path(case, "t", claims(case, True, True, True, False, True), EXACT)
    assert outcome.reasons == (MISSED,)
    witness = outcome.witness
    assert witness is not None and witness.p is not None and witness.q is not None
    assert witness.scale == "1"
    x, p, q = (tuple(map(Fraction, point)) for point in (witness.point, witness.p, witness.q))
    assert (x[0] + p[0], x[1] + p[1]) == q
    assert 2 < p[0] < 3 and 0 < p[1] < 1 and 1 < q[0] < 4 and 0 < q[1] < 1
    (outcome,) = judge_path(case, "t", claims(case, True, False, False, False, True), EXACT)
    assert outcome.reasons == (INVENTED,)
    assert outcome.witness is not None and outcome.witness.scale == "2"
    assert not outcome.witness.in_truth
    forbidden = asked(literal("forbidden", scales=["1/3", "2", "5"]))
    (outcome,) = judge_path(forbidden, "t", claims(forbidden, False, False, True), EXACT)
    assert outcome.verdict is Verdict.PASS


def test_ranges_are_compared_as_sets() -> None:
    case = asked(literal(**{"from": "1/8", "to": "8"}))
    one = Fraction(1, 3)

    def judged(*ranges: ScaleRange) -> tuple[Reason, ...]:
        return judge_path(case, "t", PathClaim(ranges=ranges), EXACT)[0].reasons

    first, last = (
        ScaleRange(Fraction(0), one, False, True),
        ScaleRange(Fraction(9, 2), None, True, False),
    )
    two = ScaleRange(Fraction(2), Fraction(2), True, True)
    halves = (
        ScaleRange(Fraction(1, 8), Fraction(1, 4), True, True),
        ScaleRange(Fraction(1, 5), one, True, True),
    )
    assert judged(first, two, last) == judged(last, two, *halves) == ()
    assert judged(first, last) == (INVENTED,)
    assert judged(replace(first, high_in=False), two, last) == (INVENTED,)
    assert judged(first, replace(two, high=Fraction(3)), last) == (MISSED,)
    assert judged() == (INVENTED,)
    assert judged(ScaleRange(Fraction(0), None, True, True)) == (MISSED,)


def test_a_double_next_to_the_end_of_a_range_stands_for_it() -> None:
    case = asked(literal(**{"from": "1/8", "to": "8"}))
    exact = Declaration("doubles", numbers="double")
    two, last = Fraction(2), ScaleRange(Fraction(9, 2), None, True, False)
    near = Fraction(1 / 3)
    for end in (near, Fraction(math.nextafter(1 / 3, 1))):
        ranges = (ScaleRange(Fraction(0), end, False, True), ScaleRange(two, two, True, True), last)
        (outcome,) = judge_path(case, "t", PathClaim(ranges=ranges), exact)
        assert outcome.verdict is Verdict.PASS
        assert judge_path(case, "t", PathClaim(ranges=ranges), EXACT)[0].verdict is Verdict.WRONG
    far = Fraction(math.nextafter(1 / 3, 0))
    ranges = (ScaleRange(Fraction(0), far, False, True), ScaleRange(two, two, True, True), last)
    assert judge_path(case, "t", PathClaim(ranges=ranges), exact)[0].reasons == (INVENTED,)


def test_a_tolerance_is_of_the_obstacles() -> None:
    """Within the tolerance of a bound a target may say either; farther away it must be right."""
    rough = Declaration("rough", arithmetic="float64", absolute=Fraction(1, 10))
    case = asked(literal(scales=["1/3", "1", "2", "9/2", "6"]))
    for near in (True, False):
        (outcome,) = judge_path(case, "t", claims(case, near, False, near, near, True), rough)
        assert outcome.verdict in GOOD
    (outcome,) = judge_path(case, "t", claims(case, True, True, True, True, True), rough)
    assert outcome.reasons == (MISSED,)
    assert outcome.witness is not None and outcome.witness.tolerance == "1/10"
    (outcome,) = judge_path(case, "t", claims(case, True, False, True, True, False), rough)
    assert outcome.reasons == (INVENTED,)


def test_a_false_witness_does_not_hold() -> None:
    case = asked(literal(scales=["1"]))
    one = Asked(case, case.obstacles, "allowed")
    witness = path_witness(one, Fraction(1))
    assert holds(one, witness)
    for change in (
        {"point": ("1", "0")},
        {"p": ("2", "0")},
        {"q": ("1", "0")},
        {"scale": "2"},
        {"on_path": ("0", "2")},
        {"on_path": ("1", "0")},
        {"p": None},
    ):
        assert not holds(one, replace(witness, **change)), change  # type: ignore[arg-type]


@pytest.mark.parametrize("way", ["coarse", "touching", "one-interval"][: draws(1, 3)])
def test_a_finding_is_shrunk_to_a_few_vertices(way: str) -> None:
    done = verified(way, *names("path"))
    finding = min(done.findings, key=lambda found: found.case.size)
    small = shrink_finding(finding, ALL_TARGETS, Limits(seconds=60), 150)
    assert small is not None
    assert small.outcome.reasons == finding.outcome.reasons
    assert small.result.size[0] <= 10
    case = asked(small.literal)
    assert len(case.scales) == 1


def test_steps_are_smaller_and_cases() -> None:
    case = SmallPath.read(asked(f"path:{SEED}:3").literal)
    steps = list(smaller_paths(case))
    assert len(steps) > 10
    for step in steps[:: max(len(steps) // 12, 1)]:
        assert step.size < case.size
        assert SmallPath.read(asked(step.literal).literal).size <= step.size


def test_there_are_cases_for_many_numbers() -> None:
    """A drawn invalid outline is drawn again."""
    for index in range(3, 400, 4):
        assert case_in_a_hole(3170, index).obstacles.rings()


def test_cases_have_names_that_reproduce_them() -> None:
    for family in FAMILIES:
        for index in range(8):
            case = asked(f"{family}:{SEED}:{index}")
            again = asked(case.literal)
            assert again.literal == case.literal == asked(case.name.text).literal
            assert verb_of(case.name.text) == verb_of(case.literal) == case.verb
            if "grid" in family:
                assert all(axis.denominator <= 64 for point in case.path for axis in point)


@pytest.mark.parametrize(
    "text",
    [
        '{"part":{"polygons":[]},"path":[["0","0"]],"scales":["1"]}',
        literal(scales=[]),
        literal(scales=["0"]),
        literal(scales="1"),
        literal("maybe", scales=["1"]),
        literal(**{"from": "2", "to": "1"}),
        literal(),
        literal(scales=["1"]).replace('[["0", "0"], ["0", "1/2"]]', "[]"),
        literal(scales=["1"]).replace('[["0", "0"], ["0", "1/2"]]', '[["0"]]'),
        literal(scales=["1"]).replace('"1/2"', '"x"'),
    ],
)
def test_what_is_no_case_is_refused(text: str) -> None:
    with pytest.raises(Refusal):
        asked(text)


def test_paths_are_among_the_cases_of_those_who_declare_them() -> None:
    cases = CaseList(1, 40, models=False, families=("random",), paths=("path", "path-ranges"))
    texts = [one.text for one in cases if not isinstance(one, Wait)]
    assert sum(text.startswith("path:") for text in texts) > 5
    assert sum(text.startswith("path-ranges:") for text in texts) > 5
    doubles = CaseList(1, 40, models=False, families=("random",), paths=("path",), doubles=True)
    assert any(one.text.startswith("path-grid:") for one in doubles if not isinstance(one, Wait))


def test_the_check_of_an_adapter_asks_for_paths(capsys: pytest.CaptureFixture[str]) -> None:
    assert command(["adapter", "check", target("right"), "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["sums"]
    assert sum("path" in row["case"] for row in rows) == 3
    assert {row["verdict"] for row in rows} == {"pass"}
    assert command(["adapter", "check", target("one-interval")]) == 1
    out = capsys.readouterr().out
    assert "the scale 2 is valid, and not called so" in out


def test_the_report_shows_the_place(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code = command(
        ["verify", target("coarse"), "--no-models", "--report", str(tmp_path / "report"),
         "--shrink-calls", str(draws(8, 40)), "--jobs", "1",
         "--case", f"path:{SEED}:1", "--case", f"path:{SEED}:6"]
    )  # fmt: skip
    assert code == 1
    out = capsys.readouterr().out
    assert "the part collides at" in out
    assert "scale 1, " not in out  # a path is asked about at many scales
    pages = "".join(
        page.read_text(encoding="utf-8") for page in (tmp_path / "report").glob("**/*.html")
    )
    assert "Scale: " not in pages and "The sum has the point" not in pages
    assert "contact: forbidden" in pages and "path: (" in pages
    assert "in the part and in the obstacles" in pages
    assert "at the place of the witness" in pages
    assert "Not all of it is drawn" not in pages


def test_a_library_that_rounds_is_asked_on_a_grid(capsys: pytest.CaptureFixture[str]) -> None:
    """Without `rational` no case with thirds is sent, and paths are asked about all the same."""
    code = command(
        [
            "verify",
            target("doubles"),
            "--no-models",
            "--pairs",
            "40",
            "--seed",
            "3",
            "--jobs",
            "1",
            "--json",
        ]
    )
    value = json.loads(capsys.readouterr().out)
    assert code == 0, value
    asked_for = [note for note in value["notes"] if "did not ask" in note]
    assert not any("path" in note for note in asked_for)
