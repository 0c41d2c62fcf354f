"""A few adapters written from the page alone: right ones pass, faulty ones are found. The parts
`unusual_adapters` and `faulty_adapters` of the evidence ask all such adapters."""

from __future__ import annotations

import json
import shutil
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from minkref.cli.cli import run
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.run import naming
from minkref.fuzz.settings import asking_about
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Verdict
from thoroughness import THOROUGH

FOLDER = Path(__file__).parent
SECONDS = 120
PLANE = ("random:1:0", "holes:1:9", "degenerate:1:0", "convex:1:0", "probe:0(random:1:26)")
PLANE += ("update(star:1:0)", "events(holes:1:9)", "invalid:1:0")
SPACE = ("space-convex:1:0", "space-polycube:1:0", "space-apart:1:0", "space-offset:1:0")
Verify = Callable[..., tuple[int, dict[str, Any]]]


@pytest.fixture
def verify(capsys: pytest.CaptureFixture[str]) -> Verify:
    """Runs the command."""

    def call(target: str, *words: str, shrink_calls: str = "0") -> tuple[int, dict[str, Any]]:
        more = ("--no-models", "--jobs", "1", "--shrink-calls", shrink_calls, "--json")
        code = run(["verify", target, *words, *more])
        return code, json.loads(capsys.readouterr().out)

    return call


def adapter(name: str) -> str:
    return f"cmd:{sys.executable} {FOLDER / 'adapter.py'} {name}"


def said_of(name: str, *cases: str) -> list[tuple[Verdict, str]]:
    """Verdicts and messages about a target on named cases, without a run and its workers."""
    limits = Limits(seconds=SECONDS)
    target = cache(lambda name: ALL_TARGETS.target(name, limits))  # it, or one of ours
    found = []
    try:
        for text in cases:
            case = naming.load(CaseName(text, "test"))
            asking = asking_about(case, target, lambda _: None, {}, limits)
            found += [(one.verdict, one.message) for one in asking.outcomes([name])]
    finally:
        target(name).close()
    return found


def no_alarm(target: str, *cases: str) -> None:
    said = said_of(target, *cases)
    verdicts = {verdict for verdict, _ in said}
    assert verdicts <= {Verdict.PASS, Verdict.PASS_WITHIN, Verdict.SKIPPED}, said
    assert verdicts - {Verdict.SKIPPED}


def verdicts(value: dict[str, Any]) -> set[str]:
    return {verdict for row in value["matrix"] for verdict in row["verdicts"]}


@pytest.mark.parametrize(
    "name",
    [
        "AnotherFormEachTime",
        "OddSpellings",
        "AllIn",
        "SumOfBoundaries",
        "UnicodeEscapes",
        "Everything",
    ],
)
def test_right_in_the_plane(name: str) -> None:
    no_alarm(adapter(name), *PLANE)


@pytest.mark.parametrize("name", ["NoVertexShared", "UnusedVertices", "RoundedInSpace"])
def test_right_in_space(name: str) -> None:
    no_alarm(adapter(name), *SPACE)


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "pairs"), [("Everything", "24"), ("OddSpellings", "24"), ("RoundedInSpace", "11")]
)
def test_right_in_a_run(verify: Verify, name: str, pairs: str) -> None:
    """Repeats `test_right_in_the_plane` and `test_right_in_space` on the cases that a run draws."""
    code, value = verify(adapter(name), "--pairs", pairs)
    assert code == 0 and verdicts(value) <= {"pass", "pass-within", "skipped"}


def test_what_is_declared_and_no_case_had_is_noted(verify: Verify) -> None:
    """A report must not look as if all that is declared had been tried."""
    name = adapter("PlaneAndSpace")
    words = ("--family", "convex", "--family", "space-polycube", "--pairs", "12")
    (note,) = [note for note in verify(name, *words)[1]["notes"] if "no case of this run" in note]
    before, _, rest = note.partition(" declares kinds of input that no case of this run had: ")
    in_plane, in_space = rest.split("; ")
    assert name in before
    assert {"holes", "components", "segment"} < kinds_in(in_plane, "in the plane ")
    assert "empty" in kinds_in(in_space, "in space ") and "non-convex" not in in_space
    alone = verify(name, "--case", "convex:1:0")[1]["notes"]
    assert not any("no case of this run" in note for note in alone)


def kinds_in(text: str, where: str) -> set[str]:
    assert text.startswith(where)
    return set(text.removeprefix(where).split(", "))


def test_a_scale_of_three_numbers_is_a_list() -> None:
    no_alarm(adapter("ScalesItselfInSpace"), "space-offset:1:0")


def test_scales_of_events_rounded_by_an_absolute_tolerance() -> None:
    no_alarm(adapter("EventsAbsolute"), "events(holes:1:9)")


def test_p_off_the_doubles_is_not_sent_as_doubles() -> None:
    """P itself is no list of doubles, though sP and Q are, and an adapter may look at P alone."""
    folder = FOLDER.parents[2] / "degeneracies" / "corpus" / "mixed-magnitudes"
    case = f"{folder / 'mixed-magnitudes-c3e4557b57ca.json'}@1/2000000000000000000000000000"
    assert {verdict for verdict, _ in said_of(adapter("ScalesItselfInDoubles"), case)} == {
        Verdict.SKIPPED
    }


@pytest.mark.parametrize("case", ["space-convex:1:0", "space-polycube:1:0"])
def test_a_body_cut_into_tetrahedra(case: str) -> None:
    no_alarm(adapter("Tetrahedra"), case)


def test_right_in_javascript() -> None:
    if shutil.which("node") is None:
        pytest.skip("no node here")
    no_alarm(f"cmd:node {FOLDER / 'convex.js'}", *(f"convex:1:{k}" for k in range(6)))


@pytest.mark.parametrize(
    ("name", "case"),
    [
        ("PinchedHolesLost", "probe:0(random:1:26)"),
        ("EventsWithoutDeaths", "events(holes:1:9)"),
        ("UpdateDrifts", "update(star:1:0)"),
        ("ThirdFactorIgnored", "space-offset:1:0"),
        ("SecondBodyLost", "space-apart:1:0"),
        ("CavitiesFilled", "space-hollow:1:0"),
        ("VertexOffInSpace", "space-polycube:1:0"),
        ("AcceptsInvalid", "invalid:1:0"),
        ("EventsShifted", "events(holes:1:9)"),
    ],
)
def test_a_fault_is_found(name: str, case: str) -> None:
    assert {verdict for verdict, _ in said_of(adapter(name), case)} == {Verdict.WRONG}


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["AcceptsInvalid", "EventsShifted"])
def test_a_fault_is_found_in_a_run(verify: Verify, name: str) -> None:
    """Repeats `test_a_fault_is_found` on the cases that a run draws."""
    assert verify(adapter(name), "--first", "--pairs", "1200")[0] == 1


def test_input_accepted_against_a_promise_is_shrunk(verify: Verify) -> None:
    cases = ("--first", "--pairs", "1200") if THOROUGH else ("--case", "invalid:1:0")
    assert verify(adapter("AcceptsInvalid"), *cases, shrink_calls="40")[0] == 1
