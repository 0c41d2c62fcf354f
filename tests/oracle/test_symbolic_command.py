"""The command of the symbolic oracle: documents, refusals, exit codes."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from minkref.oracle.symbolic.__main__ import COMMANDS, main

FOLDER = Path(__file__).resolve().parents[2] / "oracle"


def asked(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, name: str, request: str
) -> dict[str, Any]:
    path = tmp_path / "request.json"
    path.write_text(request)
    assert main([name, str(path)]) == 0
    answer: dict[str, Any] = json.loads(capsys.readouterr().out)
    return answer


def example(name: str) -> str:
    """The help text's request: its first JSON object."""
    found, _ = json.JSONDecoder().raw_decode(COMMANDS[name][2])
    return json.dumps(found)


def test_examples_of_the_help_are_answered(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    pair = asked(capsys, tmp_path, "pair", example("pair"))
    assert pair == {
        "contact": {"low": "4", "high": None},
        "events": [{"s": "4", "change": "birth", "at": ["4", "0"], "to": None}],
    }
    level = asked(capsys, tmp_path, "parallel", example("parallel"))
    assert [(e["s"], e["change"]) for e in level["events"]] == [
        ("3", "birth"),
        ("4", "swap"),
        ("5", "swap"),
        ("6", "death"),
    ]
    triple = asked(capsys, tmp_path, "triple", example("triple"))
    assert [e["s"] for e in triple["events"]] == ["541/186"]
    facets = asked(capsys, tmp_path, "facets", example("facets"))
    assert facets == {"case": "once", "s": "5", "meet": True, "at": ["1", "1", "5"]}
    edges = COMMANDS["facets"][2]
    contact = asked(capsys, tmp_path, "facets", edges[edges.index('{"edges"') :])
    assert contact == {"contact": {"low": "2", "high": None}}
    disc = asked(capsys, tmp_path, "disc", example("disc"))
    assert {tuple(e["polynomial"]) for e in disc["events"]} >= {(1, -2)}


def test_decimals_are_the_numbers_of_their_text(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    request = example("pair").replace('"1/2"', "0.1")
    answer = asked(capsys, tmp_path, "pair", request)
    assert answer["events"][0]["s"] == "20/9"  # s >= 2 + s / 10


@pytest.mark.parametrize(
    ("name", "request_text"),
    [
        ("pair", "no JSON"),
        ("pair", "[]"),
        ("pair", "{}"),
        ("pair", '{"segments": []}'),
        ("pair", '{"segments": 3}'),
        ("parallel", '{"segments": [{"kind": "S", "edge": [[0,0],[0,0]], "vertex": [0,0]}]}'),
        ("triple", '{"segments": [{"kind": "S", "edge": [[0,0],["1/0",0]], "vertex": [0,0]}]}'),
        ("facets", '{"facets": []}'),
        ("disc", '{"polygon": [[0,0],[1,0]]}'),
        ("disc", '{"polygon": [[0,0],[1,0],[0,1]], "radius": "-1"}'),
    ],
)
def test_bad_requests_are_refused(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, name: str, request_text: str
) -> None:
    path = tmp_path / "request.json"
    path.write_text(request_text)
    assert main([name, str(path)]) == 2
    refusal = capsys.readouterr()
    assert refusal.out == "" and refusal.err.startswith(f"{name}: ")


def test_the_command_runs_from_its_folder() -> None:
    ran = subprocess.run(
        [sys.executable, "-m", "symbolic", "triple"],
        input=example("triple"),
        capture_output=True,
        text=True,
        cwd=FOLDER,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
        check=True,
    )
    assert json.loads(ran.stdout)["events"][0]["at"] == ["-59/186", "-107/93"]
    with pytest.raises(SystemExit) as wrong:
        main(["quadruple"])
    assert wrong.value.code == 2
