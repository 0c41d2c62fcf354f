"""`minkref path`, `fit` and `trap` with a disc, and with --clearance: documents, text and
refusals."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import schema

Minkref = Callable[..., Any]
SQUARE = "POLYGON((-1 -1,1 -1,1 1,-1 1,-1 -1))"
ROOM = "POLYGON((-1 -1,9 -1,9 3,8 3,8 0,0 0,0 8,8 8,8 5,9 5,9 9,-1 9,-1 -1))"
POCKET = "POLYGON((0 0,8 0,8 3,9 3,9 0,15 0,15 8,9 8,9 5,8 5,8 8,0 8,0 0))"
CAGE = "POLYGON((0 0,10 0,10 10,6 10,6 9,9 9,9 1,1 1,1 9,4 9,4 10,0 10,0 0))"
WAY = "LINESTRING(20 4,11 4)"

DISCS = {
    "path": ("path", "disc", ROOM, WAY),
    "path with a clearance": ("path", "disc", ROOM, WAY, "--clearance", "1/2"),
    "path of one disc": ("path", "disc:sqrt:2", ROOM, WAY, "--contact", "forbidden"),
    "fit at a place": ("fit", "disc", POCKET, "--at", "3,3"),
    "fit anywhere": ("fit", "disc", POCKET, "--anywhere"),
    "fit between": ("fit", "disc", POCKET, "--between", "3,3", "12,3"),
    "fit between rooms": ("fit", "disc", POCKET, "--between", "3,3", "30,3"),
    "trap": ("trap", "disc:2", ROOM, "--at", "4,4"),
    "no trap": ("trap", "disc", ROOM, "--at", "30,4"),
}


@pytest.mark.parametrize("name", DISCS)
def test_documents_keep_their_schema_and_people_are_told(minkref: Minkref, name: str) -> None:
    words = DISCS[name]
    value = minkref(*words, "--json").json
    jsonschema.validate(value, schema(words[0]))
    told = minkref(*words)
    assert told.code == 0 and "seconds" in told.out


def test_the_radii_are_exact_and_say_what_bounds_them(minkref: Minkref) -> None:
    value = minkref(*DISCS["path"], "--json").json
    assert value["radii"]["to"]["squared_distance"] == "5" and value["radii"]["to_in"]
    assert value["touches"]["obstacle"] == {"vertex": [0, 2]}
    value = minkref(*DISCS["fit between"], "--json").json
    assert value["cause"] == "neck" and value["radii"]["to"]["squared_distance"] == "1"
    value = minkref(*DISCS["trap"], "--json").json
    assert value["asked"] == {"radius": "2", "holds": True}
    assert "(0, sqrt(5) - 1/2]" in minkref(*DISCS["path with a clearance"]).out
    assert "yes; all radii" in minkref(*DISCS["path of one disc"]).out


def test_what_touches_is_named_by_its_side(minkref: Minkref) -> None:
    told = minkref("fit", "disc", POCKET, "--at", "3,3").out
    assert "of the container" in told and "obstacles" not in told


def test_a_part_with_a_clearance(minkref: Minkref, tmp_path: Path) -> None:
    value = minkref("path", SQUARE, ROOM, WAY, "--clearance", "1/2", "--json").json
    jsonschema.validate(value, schema("path"))
    assert [one["to"]["exact"] for one in value["clear"]] == ["3/2"]
    value = minkref("fit", SQUARE, POCKET, "--at", "3,3", "--clearance", "1", "--json").json
    jsonschema.validate(value, schema("fit"))
    assert value["clear"][0]["to"]["exact"] == "2"
    file = tmp_path / "clear.json"
    told = minkref("path", SQUARE, ROOM, WAY, "--clearance", "1/2", "-o", str(file))
    assert "clear scales  (0, 3/2]" in told.out
    assert json.loads(file.read_text())["seconds"] is None


def test_the_picture_shows_the_track_and_the_contact(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "way.svg"
    assert "written" in minkref("path", "disc", ROOM, WAY, "-o", str(file)).out
    drawn = file.read_text()
    assert 'class="track"' in drawn and 'class="touch"' in drawn and "sqrt(5)" in drawn
    told = minkref("path", "disc", ROOM, "POINT(4 8)", "-o", str(file)).out
    assert "a place is not free" in told and 'class="track"' not in file.read_text()


@pytest.mark.parametrize(
    ("words", "circles", "says"),
    [
        (("fit", "disc", POCKET, "--anywhere"), 2, "a disc fits at the radii"),
        (("fit", "disc", POCKET, "--at", "3,3"), 1, "a disc fits at the radii"),
        (("trap", "disc", CAGE, "--at", "5,5"), 2, "a disc is trapped at the radii (1, 4]"),
        (("trap", "disc", CAGE, "--at", "20,5"), 0, "radii none"),
        (("fit", "disc", POCKET, "--at", "900,3"), 0, "radii none"),
    ],
)
def test_the_picture_shows_the_largest_disc_and_each_neck(
    minkref: Minkref, tmp_path: Path, words: tuple[str, ...], circles: int, says: str
) -> None:
    file = tmp_path / "room.svg"
    ran = minkref(*words, "-o", str(file))
    assert ran.code == 0 and "written" in ran.out
    drawn = file.read_text()
    assert drawn.count('class="disc"') == circles and says in drawn


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("path", ROOM, "disc", WAY), "the disc is the part"),
        (("path", "disc", ROOM, WAY, "--clearance", "0"), "the clearance is not above 0"),
        (("path", "disc:0", ROOM, WAY), "the radius is zero"),
        (("fit", "disc", POCKET), "one question"),
        (("path", SQUARE, ROOM, WAY, "--clearance", "1", "--certify", "a.json"), "no certificate"),
        (("path", SQUARE, ROOM, WAY, "--clearance", "1", "--route", "contacts"), "one route"),
        (("fit", "disc", "LINESTRING(0 0,4 0)", "--anywhere"), "no area"),
    ],
)
def test_refusals_say_what_and_how(minkref: Minkref, words: tuple[str, ...], says: str) -> None:
    ran = minkref(*words)
    assert ran.code == 2 and says in ran.err and "fix:" in ran.err
