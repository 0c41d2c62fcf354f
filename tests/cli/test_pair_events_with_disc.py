"""`minkref events P disc --kind pair`."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import _core
from minkref.schemas import schema

Minkref = Callable[..., Any]

# A box with a slot of the width 4 between x = 4 and x = 8, as deep as 4.
SLOT = "POLYGON ((0 0, 12 0, 12 6, 8 6, 8 2, 4 2, 4 6, 0 6, 0 0))"


def test_all_events_of_a_slot(minkref: Minkref) -> None:
    ran = minkref("events", SLOT, "disc", "--kind", "pair", "--json")
    assert ran.code == 0
    jsonschema.validate(ran.json, schema("events"))
    assert ran.json["count"] == len(ran.json["events"]) == sum(ran.json["changes"].values())
    assert ran.json["truth"] is None and ran.json["form"] == "corrected"
    walls = [{"edge": [0, 3]}, {"edge": [0, 5]}]
    of_walls = [event for event in ran.json["events"] if event["features"] == walls]
    assert [event["squared_radius"] for event in of_walls] == ["4"]
    assert of_walls[0]["change"] == "overlap"
    assert of_walls[0]["shared"] == {"before": 0, "at": "segment", "after": 0}
    # The floor meets each wall from the start until it is as far out as half of itself.
    floor = [{"edge": [0, 3]}, {"edge": [0, 4]}]
    (met,) = [event for event in ran.json["events"] if event["features"] == floor]
    assert (met["change"], met["squared_radius"]) == ("death", "16")
    assert met["shared"] == {"before": 1, "at": 1, "after": 0}


def test_arcs_across_the_slot_touch_in_the_middle(minkref: Minkref) -> None:
    ran = minkref("events", SLOT, "disc", "--kind", "pair", "--json")
    arcs = [{"vertex": ["4", "6"]}, {"vertex": ["8", "6"]}]
    found = [
        event for event in ran.json["events"] if sorted(event["features"], key=json.dumps) == arcs
    ]
    (touch,) = found
    assert touch["condition"] == "circles" and touch["squared_radius"] == "4"
    assert touch["contacts"][-1]["place"] == [6, 6]
    assert touch["shared"] == {"before": 0, "at": 1, "after": 1}


def test_printed_events_are_held_against_the_truth(minkref: Minkref) -> None:
    ran = minkref("events", SLOT, "disc", "--kind", "pair", "--form", "printed", "--json")
    jsonschema.validate(ran.json, schema("events"))
    truth = ran.json["truth"]
    right = minkref("events", SLOT, "disc", "--kind", "pair", "--limit", "0", "--json").json
    assert truth["count"] == right["count"] and right["events"] == []
    assert truth["missed"] > 0 and truth["right"] > 0
    assert truth["missed"] + truth["right"] == truth["count"]
    assert truth["invented"] == ran.json["changes"]["none"]
    assert not any("overlap" == event["change"] for event in ran.json["events"])


def test_circles_of_another_radius_have_no_printed_ends(minkref: Minkref) -> None:
    a = [("-4", "-3"), ("0", "0"), ("-3", "4")]
    b = [("10", "3"), ("6", "0"), ("7", "0")]
    right = [radius[0] for _, radius, _, _ in _core.disc_pair(a, b)]
    assert right == ["9", "225/16", "25"]
    for unit, kept in ((True, right), (False, right[:1])):
        printed = _core.disc_pair(a, b, ["radical"], unit)
        assert [radius[0] for _, radius, _, _ in printed] == kept
    for Q, radius in (("disc:2", "2"), ("disc", "1"), ("disc:sqrt:2", "sqrt:2")):
        ran = minkref("events", SLOT, Q, "--kind", "pair", "--form", "printed", "--json")
        jsonschema.validate(ran.json, schema("events"))
        assert ran.json["radius"] == radius


@pytest.mark.parametrize("P", ["POINT (1 2)", "LINESTRING (0 0, 3 4)", "POLYGON EMPTY"])
def test_what_has_no_pairs_that_meet(minkref: Minkref, P: str) -> None:
    ran = minkref("events", P, "disc", "--kind", "pair", "--json")
    assert (ran.code, ran.json["count"], ran.json["events"]) == (0, 0, [])


def test_events_grow_and_move_with_the_polygon(minkref: Minkref) -> None:
    """Beyond doubles too."""
    one = minkref("events", SLOT, "disc", "--kind", "pair", "--json").json
    far = SLOT
    for number in ("12", "8", "6", "4", "2"):
        far = re.sub(rf"\b{number}\b", f"{number}e400", far)
    other = minkref("events", far, "disc", "--kind", "pair", "--json").json
    for x, y in zip(one["events"], other["events"], strict=True):
        assert (x["features"][0].keys(), x["change"]) == (y["features"][0].keys(), y["change"])
        if x["squared_radius"] is not None:
            assert Fraction(y["squared_radius"]) == Fraction(x["squared_radius"]) * 10**800
        assert y["radius"]["high"] is None


@pytest.mark.parametrize(("window", "radii"), [
    (("--from", "2", "--to", "2"), {"4"}),
    (("--from", "2.01", "--to", "2.02"), set()),
])  # fmt: skip
def test_a_window_of_radii(minkref: Minkref, window: tuple[str, ...], radii: set[str]) -> None:
    ran = minkref("events", SLOT, "disc", "--kind", "pair", *window, "--json")
    assert {event["squared_radius"] for event in ran.json["events"]} == radii
    assert ran.json["filtered_pairs"] > 0


def test_a_limit_lists_the_first(minkref: Minkref) -> None:
    every = minkref("events", "glyph275", "disc", "--kind", "pair", "--to", "1", "--json").json
    some = minkref(
        "events", "glyph275", "disc", "--kind", "pair", "--to", "1", "--limit", "5", "--json"
    ).json
    assert some["count"] == every["count"] == len(every["events"]) > 5
    assert some["events"] == every["events"][:5]


def test_lines_of_json(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "events.jsonl"
    ran = minkref("events", "g1", "disc", "--kind", "pair", "-o", file, "--json")
    rows = [json.loads(line) for line in file.read_text(encoding="utf-8").splitlines()]
    assert ran.json["events"] is None and len(rows) == ran.json["count"] > 50
    assert [row["rank"] for row in rows] == sorted(row["rank"] for row in rows)
    radii = [row["radius"]["low"] for row in rows]
    assert radii == sorted(radii)


def test_what_people_see(minkref: Minkref) -> None:
    ran = minkref("events", "g1", "disc", "--kind", "pair", "--limit", "2")
    assert "events" in ran.out and "-o FILE writes all" in ran.out
    assert "arc about" in ran.out or "edge 0." in ran.out
    printed = minkref("events", "g1", "disc", "--kind", "pair", "--form", "printed")
    assert "missed" in printed.out


@pytest.mark.parametrize(
    "arguments",
    [
        ("disc:2",),
        ("disc:0", "--form", "printed"),
        ("disc", "--form", "literal"),
        ("disc", "--route", "index"),
        ("disc", "--where", "s > 1"),
        ("disc", "--arithmetic", "double"),
        ("disc", "--reading", "interval=printed"),
        ("disc", "--from", "2", "--to", "1"),
        ("disc", "--limit", "-1"),
        ("disc", "-o", "events.parquet"),
    ],
)
def test_what_it_refuses(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: tuple[str, ...]
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = minkref("events", SLOT, *arguments, "--kind", "pair")
    assert ran.code == 2
    assert "fix:" in ran.err
    assert not list(tmp_path.iterdir())
