"""Shrinking on targets with planted conditions: small, valid, the same fault, deterministic."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref import _core
from minkref.cli.cli import run
from thoroughness import THOROUGH, draws, some

TARGET = "py:planted_conditions:"


@pytest.fixture
def minkref(
    faulty_sums: None,
    capsys: pytest.CaptureFixture[str],
    follows_schema: Callable[[Any, str], None],
) -> Any:
    def call(*arguments: str | Path) -> tuple[int, Any, str]:
        code = run([*(str(argument) for argument in arguments), "--json"])
        captured = capsys.readouterr()
        value = json.loads(captured.out)
        follows_schema(value, str(arguments[0]))
        return code, value, captured.err

    return call


def box(size: int, at: int = 0) -> list[list[int]]:
    return [[at, at], [at + size, at], [at + size, at + size], [at, at + size]]


def literal(P: Any, Q: Any, scale: str = "1") -> str:
    return json.dumps({"P": {"polygons": P}, "Q": {"polygons": Q}, "scale": scale})


HOLES = [[[31, 1], [30, 9], [39, 1]], box(6, 4)[::-1], box(7, 20)[::-1]]
TEETH = [[5, 2], [5, 5], [3, 5], [3, 2]]
FRAME = {"outer": box(40), "holes": HOLES[: draws(1, 3)]}
COMB = {"outer": [[0, 0], [9, 0], [9, 5], [7, 5], [7, 2], *TEETH[: draws(0, 4)], [0, 5]]}
FAR = {"outer": [[500, 700], [510, 700], [511, 707], [505, 711], [500, 705]]}


def counts(finding: Any) -> tuple[int, int, int]:
    """Vertices of P and of Q, and both operands' holes."""
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
        ("hole_and_vertices", literal([COMB], [FRAME, FAR][: draws(1, 2)], "7/3"), 1, (4, 6, 1)),
        ("large", literal([COMB], [FAR, FRAME][: draws(1, 2)]), 1, (3, 3, 0)),
        ("fractions", literal([COMB], [FRAME], "7/3"), 1, (3, 3, 0)),
        pytest.param(  # two_faults has the same, and another
            *("dies_of_two_holes", literal([FRAME], [FRAME]), 3, (3, 9, 2)),
            marks=pytest.mark.thorough,
        ),
        ("two_faults", literal([COMB] if THOROUGH else [FRAME], [FRAME]), 3, (3, 9, 2)),
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


def test_shrinking_again_gives_the_same(minkref: Any, tmp_path: Path) -> None:
    """The same file from the same case, and the same case from the shrunk one."""
    target = TARGET + "hole_and_vertices"
    files = [tmp_path / f"{k}.json" for k in range(3)]
    case = literal([COMB], [FRAME], "7/3")
    for given, file in ((case, files[0]), (case, files[1]), (files[0], files[2])):
        minkref("shrink", given, "--target", target, "-o", file)
    texts = [file.read_text(encoding="utf-8") for file in files]
    assert texts[0] == texts[1]
    first, again = json.loads(texts[0]), json.loads(texts[2])
    assert (first["P"], first["Q"]) == (again["P"], again["Q"])


@pytest.mark.parametrize("calls", some(["0", "7", "1", "-1"], 3))
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
    options = ("--seed", "5", "--no-models", "--shrink-calls", str(draws(5, 15)))
    options += ("--pairs", "40") if THOROUGH else ("--pairs", "6", "--family", "holes")
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
    """A quarter of a second would make the case a time-out."""
    arguments = ("--pairs", "1", "--family", "random", "--no-models", "--call-seconds", "2")
    code, value, _ = minkref("verify", "py:faulty_sums:slow_if_small", *arguments)
    assert code == 3 and value["shrunk"] == []
    assert [finding["verdict"] for finding in value["findings"]] == ["timed-out"]
