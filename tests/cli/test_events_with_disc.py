"""`minkref events` with a disc."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.commands.schemas import schema

Minkref = Callable[..., Any]

FRAME = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (2 2, 2 6, 5 2, 2 2))"
CORNERS = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((4 5, 5 5, 5 6, 4 6, 4 5)))"
WALLS = "MULTIPOLYGON (((0 0, 1 0, 1 3, 0 3, 0 0)), ((3 1, 4 1, 4 9, 3 9, 3 1)))"


def test_a_triangular_hole_ends_at_its_centre(minkref: Minkref) -> None:
    ran = minkref("events", FRAME, "disc", "--json")
    assert ran.code == 0
    jsonschema.validate(ran.json, schema("events"))
    (event,) = ran.json["events"]
    assert (event["kind"], event["squared_radius"], event["place"]) == ("maximum", "1", [3, 3])
    assert event["features"] == [{"edge": [1, 0]}, {"edge": [1, 1]}, {"edge": [1, 2]}]
    assert event["radius"]["low"] <= 1 <= event["radius"]["high"]


def test_components_meet_at_a_saddle(minkref: Minkref) -> None:
    ran = minkref("events", CORNERS, "disc", "--kind", "topology", "--json")
    jsonschema.validate(ran.json, schema("events"))
    first = ran.json["events"][0]
    assert (first["kind"], first["squared_radius"]) == ("saddle", "25/4")
    assert first["features"] == [{"vertex": ["1", "1"]}, {"vertex": ["4", "5"]}]
    for radius, components in (("249/100", 2), ("251/100", 1)):
        assert minkref("sum", CORNERS, f"disc:{radius}", "--json").json["components"] == components


def test_facing_walls_have_ridges(minkref: Minkref) -> None:
    ran = minkref("events", WALLS, "disc", "--json")
    assert ran.json["counts"]["ridge"] == 2
    assert [e["squared_radius"] for e in ran.json["events"] if e["kind"] == "ridge"] == ["1", "1"]


@pytest.mark.parametrize(
    ("window", "count"),
    [
        ((), 1),
        (("--from", "1"), 1),
        (("--to", "1"), 1),
        (("--from", "1.01"), 0),
        (("--to", "0.99"), 0),
    ],
)
def test_a_window_of_radii(minkref: Minkref, window: tuple[str, ...], count: int) -> None:
    assert minkref("events", FRAME, "disc", *window, "--json").json["count"] == count


def test_lines_of_json(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "events.jsonl"
    ran = minkref("events", "glyph275", "disc", "-o", file, "--json")
    rows = [json.loads(line) for line in file.read_text(encoding="utf-8").splitlines()]
    assert ran.json["events"] is None and len(rows) == ran.json["count"] > 300
    radii = [row["radius"]["low"] for row in rows]
    assert radii == sorted(radii)


def test_what_people_see(minkref: Minkref) -> None:
    ran = minkref("events", "glyph275", "disc", "--limit", "2")
    assert "boundary events" in ran.out
    assert len(ran.out.splitlines()) == 5


@pytest.mark.parametrize(
    "arguments",
    [
        ("disc:2",),
        ("disc", "--kind", "triple"),
        ("disc", "--form", "printed"),
        ("disc", "--route", "dynamic"),
        ("disc", "--where", "s > 1"),
        ("disc", "--arithmetic", "double"),
        ("disc", "--from", "2", "--to", "1"),
        ("disc", "--from", "0"),
        ("disc", "--limit", "-1"),
        ("disc", "-o", "events.parquet"),
    ],
)
def test_what_it_refuses(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: tuple[str, ...]
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = minkref("events", FRAME, *arguments)
    assert ran.code == 2
    assert "fix:" in ran.err
    assert not list(tmp_path.iterdir())


def test_topology_names_holes_and_components(minkref: Minkref) -> None:
    """Two chambers of a hole, joined by a door: the narrower one leaves it, and ends first."""
    hole = "2 2, 2 18, 18 18, 18 11, 20 11, 20 16, 30 16, 30 4, 20 4, 20 9, 18 9, 18 2, 2 2"
    chambers = f"POLYGON ((0 0, 40 0, 40 20, 0 20, 0 0), ({hole}))"
    ran = minkref("events", chambers, "disc", "--kind", "topology", "--json")
    jsonschema.validate(ran.json, schema("events"))
    told = [(row["squared_radius"], row["changes"]) for row in ran.json["events"] if row["changes"]]
    assert told == [
        ("1", {"born": [{"hole": 2, "of": 1}], "ended": [], "joined": []}),
        ("10201/400", {"born": [], "ended": [2], "joined": []}),
        ("64", {"born": [], "ended": [1], "joined": []}),
    ]
    window = minkref("events", chambers, "disc", "--kind", "topology", "--from", "1", "--to", "8")
    assert "hole 2 leaves hole 1" in window.out
    assert "hole 1 ends" in window.out
    ran = minkref("events", chambers, "disc", "--kind", "topology", "--from", "2", "--to", "7",
                  "--json")  # fmt: skip
    assert [row["squared_radius"] for row in ran.json["events"]] == ["10201/400"]
