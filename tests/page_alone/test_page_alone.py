"""A few of the adapters written from the page alone: right ones pass, faulty ones are found. All of
them are asked by the parts `unusual_adapters` and `faulty_adapters` of the evidence."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

FOLDER = Path(__file__).parent
SECONDS = 120


def verify(target: str, *words: str, shrink_calls: str = "0") -> tuple[int, dict[str, Any]]:
    command = [sys.executable, "-m", "minkref", "verify", target, *words]
    more = ["--no-models", "--jobs", "1", "--shrink-calls", shrink_calls, "--json"]
    ran = subprocess.run([*command, *more], capture_output=True, text=True, timeout=SECONDS)
    assert ran.stdout, ran.stderr
    return ran.returncode, json.loads(ran.stdout)


def adapter(name: str) -> str:
    return f"cmd:{sys.executable} {FOLDER / 'adapter.py'} {name}"


def verdicts(value: dict[str, Any]) -> dict[str, int]:
    counts: dict[str, int] = {}
    for row in value["matrix"]:
        for verdict, count in row["verdicts"].items():
            counts[verdict] = counts.get(verdict, 0) + count
    return counts


def no_alarm(target: str, *words: str) -> None:
    code, value = verify(target, *words)
    counts = verdicts(value)
    assert code == 0 and set(counts) <= {"pass", "pass-within", "skipped"}, value["findings"][:1]
    assert set(counts) - {"skipped"}


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
    no_alarm(adapter(name), "--pairs", "24")


@pytest.mark.parametrize("name", ["NoVertexShared", "UnusedVertices", "RoundedInSpace"])
def test_right_in_space(name: str) -> None:
    no_alarm(adapter(name), "--pairs", "11")


def test_what_is_declared_and_no_case_had_is_noted() -> None:
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
    no_alarm(adapter("ScalesItselfInSpace"), "--case", "space-offset:1:0")


def test_scales_of_events_rounded_by_an_absolute_tolerance() -> None:
    no_alarm(adapter("EventsAbsolute"), "--case", "events(holes:1:9)")


def test_p_off_the_doubles_is_not_sent_as_doubles() -> None:
    """P itself is no list of doubles where sP and Q are: it may be all that an adapter looks at."""
    folder = FOLDER.parents[1] / "degeneracies" / "corpus" / "mixed-magnitudes"
    case = f"{folder / 'mixed-magnitudes-c3e4557b57ca.json'}@1/2000000000000000000000000000"
    code, value = verify(adapter("ScalesItselfInDoubles"), "--case", case)
    assert code in (0, 2) and set(verdicts(value)) <= {"skipped"}


@pytest.mark.parametrize("case", ["space-convex:1:0", "space-polycube:1:0"])
def test_a_body_cut_into_tetrahedra(case: str) -> None:
    no_alarm(adapter("Tetrahedra"), "--case", case)


def test_right_in_javascript() -> None:
    if shutil.which("node") is None:
        pytest.skip("no node here")
    no_alarm(f"cmd:node {FOLDER / 'convex.js'}", "--family", "convex", "--pairs", "20")


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
    ],
)
def test_a_fault_is_found(name: str, case: str) -> None:
    code, value = verify(adapter(name), "--case", case)
    assert code == 1 and set(verdicts(value)) == {"wrong"}


@pytest.mark.parametrize("name", ["AcceptsInvalid", "EventsShifted"])
def test_a_fault_is_found_in_a_run(name: str) -> None:
    code, _ = verify(adapter(name), "--first", "--pairs", "1200")
    assert code == 1


def test_input_accepted_against_a_promise_is_shrunk() -> None:
    code, _ = verify(adapter("AcceptsInvalid"), "--first", "--pairs", "1200", shrink_calls="40")
    assert code == 1
