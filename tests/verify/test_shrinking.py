"""Shrinking on targets with planted conditions: small, valid, the same fault, deterministic."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import _core
from minkref.commands.line.cli import run
from minkref.commands.schemas import schema

TARGET = "py:planted_conditions:"


@pytest.fixture
def minkref(faulty_sums: None, capsys: pytest.CaptureFixture[str]) -> Any:
    def call(*arguments: str | Path) -> tuple[int, Any, str]:
        code = run([*(str(argument) for argument in arguments), "--json"])
        captured = capsys.readouterr()
        value = json.loads(captured.out)
        jsonschema.validate(value, schema(str(arguments[0])))
        return code, value, captured.err

    return call


def box(size: int, at: int = 0) -> list[list[int]]:
    return [[at, at], [at + size, at], [at + size, at + size], [at, at + size]]


def literal(P: Any, Q: Any, scale: str = "1") -> str:
    return json.dumps({"P": {"polygons": P}, "Q": {"polygons": Q}, "scale": scale})


FRAME = {
    "outer": box(40),
    "holes": [box(6, 4)[::-1], box(7, 20)[::-1], [[31, 1], [30, 9], [39, 1]]],
}
COMB = {"outer": [[0, 0], [9, 0], [9, 5], [7, 5], [7, 2], [5, 2], [5, 5], [3, 5], [3, 2], [0, 5]]}
FAR = {"outer": [[500, 700], [510, 700], [511, 707], [505, 711], [500, 705]]}


def counts(finding: Any) -> tuple[int, int, int]:
    """Vertices of P and Q, and holes of both."""
    found = []
    hole_count = 0
    for name in "PQ":
        polygons = finding[name]["set"]["polygons"]
        hole_count += sum(len(p["holes"]) for p in polygons)
        found.append(sum(len(p["outer"]) + sum(map(len, p["holes"])) for p in polygons))
    return found[0], found[1], hole_count


@pytest.mark.parametrize(
    ("name", "case", "code", "least"),
    [
        ("hole_and_vertices", literal([COMB], [FRAME, FAR], "7/3"), 1, (4, 6, 1)),
        ("large", literal([COMB], [FRAME, FAR]), 1, (3, 3, 0)),
        ("fractions", literal([COMB], [FRAME], "7/3"), 1, (3, 3, 0)),
        ("dies_of_two_holes", literal([FRAME], [FRAME]), 3, (3, 9, 2)),
        ("two_faults", literal([COMB], [FRAME]), 3, (3, 9, 2)),
    ],
)
def test_shrunk_case_is_the_least_with_the_condition(
    minkref: Any, name: str, case: str, code: int, least: tuple[int, int, int], tmp_path: Path
) -> None:
    file = tmp_path / "small.json"
    found, value, _ = minkref("shrink", case, "--target", TARGET + name, "-o", file)
    assert found == code, value
    small = value["shrunk"] if "shrunk" in value else value
    text = json.dumps(small)
    again, verified, _ = minkref("verify", TARGET + name, "--case", file, "--shrink-calls", "0")
    assert again == code, text
    (finding,) = verified["findings"]
    for operand in "PQ":
        _core.PolygonSet.from_json(json.dumps(finding[operand]["set"])).validate(operand)
    p, q, hole_count = counts(finding)
    assert (p + q, hole_count) == (least[0] + least[1], least[2])
    if name == "fractions":
        assert finding["scale"] == "1" or Fraction(finding["scale"]).denominator <= 3
    if code == 3:
        assert finding["signal"] == "SIGFPE"


def test_shrinking_twice_gives_the_same_file(minkref: Any, tmp_path: Path) -> None:
    case = literal([COMB], [FRAME], "7/3")
    texts = []
    for k in range(2):
        file = tmp_path / f"{k}.json"
        minkref("shrink", case, "--target", TARGET + "hole_and_vertices", "-o", file)
        texts.append(file.read_text(encoding="utf-8"))
    assert texts[0] == texts[1]


def test_shrunk_case_is_shrunk_already(minkref: Any, tmp_path: Path) -> None:
    first, second = tmp_path / "first.json", tmp_path / "second.json"
    target = TARGET + "hole_and_vertices"
    minkref("shrink", literal([COMB], [FRAME]), "--target", target, "-o", first)
    minkref("shrink", first, "--target", target, "-o", second)
    kept = [json.loads(file.read_text(encoding="utf-8")) for file in (first, second)]
    assert kept[0]["P"] == kept[1]["P"]
    assert kept[0]["Q"] == kept[1]["Q"]


@pytest.mark.parametrize("calls", ["0", "1", "7", "-1"])
def test_bound_on_calls_holds(minkref: Any, calls: str, tmp_path: Path) -> None:
    file = tmp_path / "small.json"
    arguments = ("--target", TARGET + "large", "--calls", calls, "-o", file)
    code, value, _ = minkref("shrink", literal([COMB], [FAR]), *arguments)
    assert code in (1, 2), value


def test_target_without_a_fault_is_refused(minkref: Any) -> None:
    code, value, _ = minkref("shrink", "random:1:0", "--target", "py:faulty_sums:right")
    assert code == 2
    assert value["error"]["what"]


def test_findings_and_shrunk_cases_do_not_depend_on_the_number_of_workers(minkref: Any) -> None:
    options = ("--pairs", "40", "--seed", "5", "--no-models", "--shrink-calls", "15")
    seen = []
    for jobs in ("1", "2"):
        code, value, _ = minkref("verify", TARGET + "two_faults", *options, "--jobs", jobs)
        assert code in (1, 3)
        seen.append((value["findings"], value["shrunk"]))
    assert seen[0][0]
    assert all(each == seen[0] for each in seen)


@pytest.mark.parametrize(
    "case", ["", "{", "teleport(random:1:0)", "swap(" * 2000 + "random:1:0" + ")" * 2000]
)
def test_case_that_is_none_is_refused(minkref: Any, case: str) -> None:
    code, value, _ = minkref("shrink", case, "--target", "py:faulty_sums:nothing")
    assert code == 2
    assert value["error"]["what"]


def test_a_time_out_is_made_small_by_few_and_short_calls(minkref: Any) -> None:
    arguments = ("--pairs", "1", "--family", "random", "--no-models", "--call-seconds", "1")
    code, value, _ = minkref("verify", "py:faulty_sums:hangs", *arguments)
    (small,) = value["shrunk"]
    assert code == 3 and small["verdict"] == "timed-out"
    assert small["call_seconds"] == 0.25 and small["calls"] <= 12
    assert "1 s" in small["message"]  # with the limit of the run it is the same


def test_a_case_that_is_slow_but_answered_is_no_smaller_time_out(minkref: Any) -> None:
    """With a quarter of a second it would be one."""
    arguments = ("--pairs", "1", "--family", "random", "--no-models", "--call-seconds", "2")
    code, value, _ = minkref("verify", "py:faulty_sums:slow_if_small", *arguments)
    assert code == 3 and value["shrunk"] == []
    assert [finding["verdict"] for finding in value["findings"]] == ["timed-out"]
