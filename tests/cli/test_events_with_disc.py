"""`minkref events` with a disc."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import schema

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
    """Two chambers of a hole, joined by a door: the narrower chamber leaves the hole and ends
    first."""
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


BOXES = (
    "MULTIPOLYGON (((16 12, 17 12, 17 13, 16 13, 16 12)), ((15 7, 16 7, 16 8, 15 8, 15 7)), "
    "((11 10, 12 10, 12 13, 11 13, 11 10)), ((19 10, 20 10, 20 11, 19 11, 19 10)))"
)
ROOMS = (
    "POLYGON ((-10 -10, 10 -10, 10 20, -10 20, -10 -10), (-1/2 0, 1/2 0, 7/2 4, 7/2 8, 1 8, 1 9, "
    "7/2 9, 7/2 13, -7/2 13, -7/2 9, -1 9, -1 8, -7/2 8, -7/2 4, -1/2 0))"
)
ROOMS_UPSIDE_DOWN = (
    "POLYGON ((-10 10, 10 10, 10 -20, -10 -20, -10 10), (-1/2 0, 1/2 0, 7/2 -4, 7/2 -8, 1 -8, "
    "1 -9, 7/2 -9, 7/2 -13, -7/2 -13, -7/2 -9, -1 -9, -1 -8, -7/2 -8, -7/2 -4, -1/2 0))"
)
COMB = (
    "POLYGON ((0 0, 9 0, 9 4, 8 4, 8 1, 7 1, 7 4, 6 4, 6 2, 3 2, 3 4, 2 4, 2 2, 1 2, 1 4, 0 4, "
    "0 0))"
)


def births(minkref: Minkref, P: str) -> list[dict[str, Any]]:
    events = minkref("events", P, "disc", "--kind", "topology", "--json").json["events"]
    return [row for row in events if row["changes"]["born"]]


def test_each_of_two_holes_born_at_one_radius_has_its_own_place(minkref: Minkref) -> None:
    """They were both put at a corner of the outside, (19, 13), as far from the boxes."""
    first, second = births(minkref, BOXES)
    assert [row["squared_radius"] for row in (first, second)] == ["4", "4"]
    assert (first["kind"], first["place"]) == ("ridge", [14, 12])
    assert (second["kind"], second["place"]) == ("ridge", [16, 10])
    assert {"vertex": ["16", "8"]} in second["features"]


def test_a_mirror_image_has_the_images_of_places(minkref: Minkref) -> None:
    """A door with another event at its radius: the place depended on the order of edges."""
    (birth,), (image,) = births(minkref, ROOMS), births(minkref, ROOMS_UPSIDE_DOWN)
    assert (birth["kind"], birth["place"]) == ("ridge", [0, 9])
    assert (image["kind"], image["place"]) == ("ridge", [0, -9])
    assert {"vertex": ["1", "9"]} in birth["features"]
    assert {"vertex": ["1", "-9"]} in image["features"]


def test_of_edges_on_one_line_the_nearest_is_named(minkref: Minkref) -> None:
    """0.8, the floor of another slot, was named as the first edge on the line."""
    events = minkref("events", COMB, "disc", "--json").json["events"]
    (event,) = [row for row in events if row["place"] == [1.5, 2.5]]
    assert sorted(each["edge"] for each in event["features"]) == [[0, 11], [0, 12], [0, 13]]


def test_a_straight_vertex_cuts_an_edge_in_two_names(minkref: Minkref) -> None:
    """A frame with a 4 by 12 hole, whose long sides have a vertex in the middle."""
    frame = "POLYGON ((0 0, 16 0, 16 8, 0 8, 0 0), (2 2, 2 6, 8 6, 14 6, 14 2, 8 2, 2 2))"
    first, last = minkref("events", frame, "disc", "--json").json["events"]
    assert (first["place"], last["place"]) == ([4, 4], [12, 4])
    assert sorted(each["edge"] for each in first["features"]) == [[1, 0], [1, 1], [1, 5]]
    assert sorted(each["edge"] for each in last["features"]) == [[1, 2], [1, 3], [1, 4]]


def test_events_at_one_radius_are_in_the_order_of_their_places(minkref: Minkref) -> None:
    events = minkref("events", COMB, "disc", "--json").json["events"]
    keys = [(row["radius"]["low"], *row["place"]) for row in events]
    assert len({radius for radius, *_ in keys}) < len(keys)
    assert keys == sorted(keys)
