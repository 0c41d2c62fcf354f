"""Lists of events as JSON, JSON lines and Parquet: the same events whatever writes them."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pyarrow.parquet
import pytest
from minkref import _core
from minkref.plane.commands import event_output
from minkref.plane.event_lists import PairEventList
from minkref.plane.operand import read_operand

Minkref = Callable[..., Any]

# Coordinates that fit machine words; a unit beyond words; coordinates that need rationals.
PAIRS = {
    "machine words": ("g1", "g2"),
    "steps of one line": ("steps.wkt", "steps.wkt"),
    "a long denominator": ("fine.wkt", "g1"),
    "long coordinates": ("far.wkt", "g1"),
}


@pytest.fixture
def files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    steps = "POLYGON((0 0,2 0,2 1,1 1,1 2,0 2,0 0))"
    Path("steps.wkt").write_text(steps, encoding="utf-8")
    fine = "POLYGON((0 0,2e-30 1e-31,1e-30 3e-30,0 0))"
    Path("fine.wkt").write_text(fine, encoding="utf-8")
    far = f"POLYGON((0 0,2{'0' * 90} 1,1 3{'1' * 80},0 0))"
    Path("far.wkt").write_text(far, encoding="utf-8")


@pytest.mark.parametrize("name", PAIRS)
def test_texts_of_events_are_those_of_their_rationals(name: str, files: None) -> None:
    P, Q = (read_operand(operand).set for operand in PAIRS[name])
    found = PairEventList(_core.pair_events(P, Q, None, None, "both"))
    assert len(found) > 5
    wanted = "".join(json.dumps(event) + ";\n" for event in found.events(0, len(found)))
    assert found.json(0, len(found), ";\n").decode() == wanted


def test_lines_and_document_hold_the_same_events(
    minkref: Minkref, files: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(event_output, "CHUNK", 50)  # several pieces
    for name in ("events.json", "events.jsonl"):
        assert minkref("events", "g3", "disc1", "-o", name).code == 0
    document = json.loads(Path("events.json").read_text(encoding="utf-8"))
    with Path("events.jsonl").open(encoding="utf-8") as lines:
        events = [json.loads(line) for line in lines]
    assert events == document["events"]
    assert document["count"] == len(events) > 50
    assert document["events"][:2] == minkref("events", "g3", "disc1", "--json").json["events"][:2]


@pytest.mark.parametrize("kind", ["pair", "topology"])
def test_no_events_are_an_empty_list(kind: str, minkref: Minkref, files: None) -> None:
    window = ("--from", "1/1000", "--to", "1/999", "--kind", kind)
    assert minkref("events", "g1", "g2", *window, "--json").json["events"] == []
    assert minkref("events", "g1", "g2", *window, "-o", "-", "--format", "jsonl").out == ""


@pytest.mark.parametrize("kind", ["pair", "triple", "boundary", "topology"])
def test_a_limit_lists_the_first_and_counts_all(kind: str, minkref: Minkref) -> None:
    whole = minkref("events", "g1", "g2", "--kind", kind, "--json").json
    some = minkref("events", "g1", "g2", "--kind", kind, "--json", "--limit", "3").json
    assert some["events"] == whole["events"][:3]
    assert some["count"] == whole["count"] > 3
    assert (
        minkref("events", "g1", "g2", "--kind", kind, "--json", "--limit", "0").json["events"] == []
    )


def test_a_limit_holds_for_parquet_too(minkref: Minkref, files: None) -> None:
    assert minkref("events", "g1", "g2", "--limit", "7", "-o", "events.parquet").code == 0
    assert pyarrow.parquet.read_table("events.parquet").num_rows == 7


def test_standard_output_and_devices_take_a_format(minkref: Minkref) -> None:
    ran = minkref("events", "g1", "g2", "-o", "-", "--format", "jsonl", "--limit", "2")
    assert (ran.code, len(ran.out.splitlines())) == (0, 2)
    document = json.loads(minkref("events", "g1", "g2", "-o", "-").out)
    assert document["events"]
    ran = minkref("events", "g1", "g2", "-o", "/dev/null", "--format", "json")
    assert ran.code == 0
    assert "/dev/null" in ran.out


@pytest.mark.parametrize(
    ("options", "word"),
    [
        (["--limit", "-1"], "--limit -1"),
        (["--format", "json"], "nothing to write"),
        (["-o", "-", "--format", "parquet"], "Parquet is written to a file"),
        (["-o", "e.jsonl", "--format", "jsno"], "did you mean json"),
    ],
)
def test_output_that_cannot_be_is_refused(
    options: list[str], word: str, minkref: Minkref, files: None
) -> None:
    before = set(Path().iterdir())
    ran = minkref("events", "g1", "g2", *options)
    assert (ran.code, ran.out) == (2, "")
    assert word in ran.err
    assert set(Path().iterdir()) == before


def test_standard_output_takes_the_list_or_the_document(minkref: Minkref) -> None:
    ran = minkref("events", "g1", "g2", "-o", "-", "--json")
    assert (ran.code, ran.json["error"]["where"]) == (2, "-o - --json")
