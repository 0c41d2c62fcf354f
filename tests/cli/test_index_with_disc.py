"""`minkref index P disc`: the outer Voronoi diagram as a file."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import result_schema, schema

Minkref = Callable[..., Any]

FRAME = "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 2 6, 6 6, 6 2, 2 2))"
NOTCH = "POLYGON ((0 0, 4 0, 4 4, 3 4, 2 1, 1 4, 0 4, 0 0))"


def test_a_frame(minkref: Minkref, tmp_path: Path) -> None:
    """Four parts lead from the hole's corners to the middle, where the hole ends."""
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


@pytest.fixture
def saved(minkref: Minkref, tmp_path: Path) -> Path:
    file = tmp_path / "saved.json"
    assert minkref("index", "g1", "disc", "-o", str(file)).code == 0
    return file


@pytest.mark.parametrize("radius", ["1/3", "7/5", "sqrt:2", "40"])
def test_a_sum_is_read_off(minkref: Minkref, saved: Path, radius: str) -> None:
    arguments = ("sum", "g1", f"disc:{radius}", "--json")
    told = minkref(*arguments, "--index", str(saved)).json
    jsonschema.validate(told, schema("sum"))
    assert told["route"] == "index"
    static = minkref(*arguments).json
    same = ("digest", "components", "holes", "curves", "result", "tight_passages", "radius")
    assert [told[name] for name in same] == [static[name] for name in same]
    assert minkref(*arguments, "--route", "index").json["digest"] == static["digest"]


def test_a_sum_at_an_event_has_its_tight_passages(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "frame.json"
    assert minkref("index", FRAME, "disc", "-o", str(file)).code == 0
    told = minkref("sum", FRAME, "disc:2", "--index", str(file), "--json").json
    assert [passage["points"] for passage in told["tight_passages"]] == [[["4", "4"]]]


def test_all_commands_take_the_file(minkref: Minkref, saved: Path, tmp_path: Path) -> None:
    """Finds the same with the file as without the file."""
    index = ("--index", str(saved))
    for kind in ("boundary", "topology"):
        arguments = ("events", "g1", "disc", "--kind", kind, "--to", "5", "--json")
        assert minkref(*arguments, *index).json["events"] == minkref(*arguments).json["events"]
    arguments = ("sweep", "g1", "disc", "--from", "1/3", "--to", "5", "--steps", "7", "--json")
    rows = [
        [row["digest"] for row in minkref(*arguments, *more).json["rows"]] for more in ((), index)
    ]
    assert rows[0] == rows[1]
    pages = [tmp_path / "a.html", tmp_path / "b.html"]
    for page, more in zip(pages, ((), index), strict=True):
        assert minkref("view", "g1", "disc", "-o", str(page), *more).code == 0
    assert pages[0].read_bytes() == pages[1].read_bytes()


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda told: told["places"].pop(), "does not belong"),
        (lambda told: told["places"][0].reverse(), "does not belong"),
        (lambda told: told["places"].append([0, 1, 2]), "no list of places"),
        (lambda told: told["places"].append([0, 1, 2, -1]), "no list of places"),
        (lambda told: told["places"].append([0, 1, True, 1]), "no list of places"),
        (lambda told: told.pop("places"), "no list of places"),
    ],
)
def test_a_file_that_was_changed_is_refused(
    minkref: Minkref, saved: Path, change: Callable[[Any], Any], said: str
) -> None:
    told = json.loads(saved.read_text())
    change(told)
    saved.write_text(json.dumps(told))
    ran = minkref("sum", "g1", "disc:1", "--index", str(saved))
    assert ran.code == 2
    assert said in ran.err


def test_what_is_no_index_is_refused(minkref: Minkref, saved: Path, tmp_path: Path) -> None:
    other = minkref("sum", "g2", "disc:1", "--index", str(saved))
    assert other.code == 2
    assert "does not belong to g2" in other.err
    text = tmp_path / "text.json"
    text.write_text("{")
    for file, said in ((text, "not JSON"), (tmp_path / "none.json", "cannot be read")):
        ran = minkref("sum", "g1", "disc:1", "--index", str(file))
        assert ran.code == 2
        assert said in ran.err
    scaled = minkref("sum", "g1", "disc:1", "--scale", "2", "--index", str(saved))
    assert scaled.code == 2
    kept = saved.read_bytes()
    assert minkref("sum", "g1", "disc:1", "--index", str(saved), "-o", str(saved)).code == 2
    assert saved.read_bytes() == kept


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
