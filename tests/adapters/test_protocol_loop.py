"""The Python loop of adapters: whatever the implementation does, each request gets its line."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.fuzz.adapters import adapter_protocol

ADAPTER = """
import os, sys
sys.path.insert(0, {folder!r})
from adapter_protocol import Rejected, Skipped, serve

def sum_of(sP, Q):
    print("words of a library")
    os.write(1, b"words of a library in C")
    if sP == "skip": raise Skipped("not this")
    if sP == "reject": raise Rejected("crosses itself")
    if sP == "fail": raise MemoryError("too much")
    if sP == "nan": return {{"rings": [[[float("nan"), 0]]]}}
    return {{"rings": [sP, Q]}}

serve({{"name": "toy"}}, sum_of)
"""


@pytest.fixture
def toy(tmp_path: Path, converse: Callable[[list[str]], Any]) -> Any:
    program = tmp_path / "toy.py"
    folder = str(Path(adapter_protocol.__file__).parent)
    program.write_text(ADAPTER.format(folder=folder), encoding="utf-8")
    return converse([sys.executable, str(program)])


def test_a_conversation(toy: Any) -> None:
    assert toy.hello() == {"seq": 1, "status": "result", "protocol": "adapter-v1", "name": "toy"}
    assert toy.ask("at", scale="1", sP=1)["status"] == "errored"
    assert toy.ask("load", dimension=2, P=0, Q=2)["status"] == "result"
    assert toy.ask("at", scale="1", sP=1)["rings"] == [1, 2]
    assert toy.stop() == 0


@pytest.mark.parametrize(
    ("operand", "status", "reason"),
    [
        ("skip", "skipped", "not this"),
        ("reject", "rejected", "crosses itself"),
        ("fail", "errored", "MemoryError: too much"),
        ("nan", "errored", "the answer cannot be written: ValueError: Out of range"),
    ],
)
def test_what_an_implementation_does(toy: Any, operand: str, status: str, reason: str) -> None:
    toy.ask("load", dimension=2, P=0, Q=2)
    answer = toy.ask("at", scale="1", sP=operand)
    assert (answer["status"], answer["reason"][: len(reason)]) == (status, reason)
    assert toy.ask("at", scale="1", sP=1)["status"] == "result"


@pytest.mark.parametrize(
    "line", ["garbage", "[1, 2]", "7", "null", "{}", '{"verb": []}', "[" * 100_000]
)
def test_lines_that_are_no_requests(toy: Any, line: str) -> None:
    answer = toy.line(line)
    assert answer["seq"] is None
    assert answer["status"] in ("errored", "skipped")
    assert toy.hello()["status"] == "result"


def test_an_unknown_verb_is_skipped(toy: Any) -> None:
    assert toy.ask("events", **{"from": "1", "to": "2"})["status"] == "skipped"
