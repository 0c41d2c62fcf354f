"""`minkref index P disc`: the outer Voronoi diagram as a file."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.commands.schemas import result_schema, schema

Minkref = Callable[..., Any]

FRAME = "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 2 6, 6 6, 6 2, 2 2))"
NOTCH = "POLYGON ((0 0, 4 0, 4 4, 3 4, 2 1, 1 4, 0 4, 0 0))"


def test_a_frame(minkref: Minkref, tmp_path: Path) -> None:
    """Four parts from the corners of the hole to its middle, where it ends."""
    file = tmp_path / "frame.json"
    ran = minkref("index", FRAME, "disc", "-o", str(file), "--json")
    assert ran.code == 0
    jsonschema.validate(ran.json, schema("index"))
    told = json.loads(file.read_text())
    jsonschema.validate(told, result_schema("index_with_disc"))
    assert [(event["kind"], event["squared_radius"]) for event in told["events"]] == [
        ("maximum", "4")
    ]
    ends = sorted(str(end) for part in told["parts"] for end in (part["from"], part["to"]))
    corners = [{"vertex": [x, y]} for x in ("2", "6") for y in ("2", "6")]
    assert ends == sorted(map(str, [*corners, *[{"event": 0}] * 4]))
    assert told["holes"] == [
        {"birth": None, "end": {"low": 2.0, "high": 2.0}, "place": [4.0, 4.0], "of": 0}
    ]
    assert told["joins"] == []


def test_a_notch_goes_on_to_infinity(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "notch.json"
    assert minkref("index", NOTCH, "disc", "-o", str(file)).code == 0
    told = json.loads(file.read_text())
    ends = Counter(next(iter(end)) for part in told["parts"] for end in (part["from"], part["to"]))
    assert (ends["vertex"], ends["infinity"]) == (1, 1)
    assert ends["event"] == 2 * len(told["events"])


def test_each_event_has_as_many_parts_as_nearest_points(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "g1.json"
    assert minkref("index", "g1", "disc", "-o", str(file)).code == 0
    told = json.loads(file.read_text())
    parts = Counter(
        end["event"] for part in told["parts"] for end in (part["from"], part["to"])
        if "event" in end
    )  # fmt: skip
    joints = {k for k, event in enumerate(told["events"]) if event["kind"] == "joint"}
    for number, event in enumerate(told["events"]):
        wanted = 2 if number in joints else None
        assert parts[number] == wanted or (
            wanted is None and 2 <= parts[number] <= len(event["features"])
        )


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("disc", "g1", "-o", "x.json"), "minkref index P disc"),
        (("g1", "disc", "-o", "x.json", "--from", "1"), "--from"),
        (("g1", "disc", "-o", "x.index"), "json"),
    ],
)
def test_refusals(minkref: Minkref, arguments: tuple[str, ...], said: str) -> None:
    ran = minkref(*("index", *arguments))
    assert ran.code == 2
    assert said in ran.err
