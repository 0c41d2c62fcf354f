"""`minkref fit --anywhere`, `--between` and `minkref trap` with --clearance: documents, text,
pictures and refusals."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.certain_digits import enclosing
from minkref.schemas import schema

Minkref = Callable[..., Any]
SQUARE = "POLYGON((-1 -1,1 -1,1 1,-1 1,-1 -1))"
DIAMOND = "POLYGON((-1 0,0 -1,1 0,0 1,-1 0))"
ASIDE = "POLYGON((1 -1,3 -1,3 1,1 1,1 -1))"
HOOK = "POLYGON((0 0,4 0,4 4,3 4,3 1,1 1,1 4,0 4,0 0))"
ROOM = "POLYGON((-1 -1,9 -1,9 3,8 3,8 0,0 0,0 8,8 8,8 5,9 5,9 9,-1 9,-1 -1))"
POCKET = "POLYGON((0 0,8 0,8 3,9 3,9 0,15 0,15 8,9 8,9 5,8 5,8 8,0 8,0 0))"
#: With a door that leans.
LEANING = "POLYGON((0 0,8 0,8 3,9 4,9 0,15 0,15 8,9 8,9 6,8 5,8 8,0 8,0 0))"
WAY = ("--between", "3,3", "12,3")
KEPT = ("--clearance", "1/4")

ASKED = {
    "anywhere": ("fit", SQUARE, POCKET, "--anywhere", *KEPT),
    "between": ("fit", SQUARE, LEANING, *WAY, *KEPT, "--contact", "forbidden"),
    "exact between": ("fit", SQUARE, POCKET, *WAY, *KEPT, "--contact", "forbidden"),
    "no way": ("fit", DIAMOND, POCKET, *WAY, "--clearance", "2"),
    "trap": ("trap", DIAMOND, ROOM, "--at", "4,4", *KEPT),
    "no trap": ("trap", DIAMOND, ROOM, "--at", "30,4", *KEPT, "--to", "2"),
    "nowhere free": ("trap", DIAMOND, ROOM, "--at", "0,0", *KEPT),
    "fit at a scale": ("fit", HOOK, POCKET, "--anywhere", *KEPT, "--scale", "1"),
    "way at a scale": ("fit", ASIDE, POCKET, *WAY, *KEPT, "--scale", "1/2"),
    "trap at a scale": ("trap", ASIDE, ROOM, "--at", "2,4", *KEPT, "--scale", "1"),
    "no room at a scale": ("fit", SQUARE, POCKET, "--anywhere", *KEPT, "--scale", "9"),
}


@pytest.mark.parametrize("name", ASKED)
def test_documents_keep_their_schema_and_people_are_told(minkref: Minkref, name: str) -> None:
    told = minkref(*ASKED[name])
    assert told.code == 0 and "clearance" in told.out
    document = minkref(*ASKED[name], "--json").json
    jsonschema.validate(document, schema(ASKED[name][0]))


def test_both_ends_are_told_and_are_as_near_as_asked(minkref: Minkref) -> None:
    told = minkref(*ASKED["between"])
    assert "both decided exactly" in told.out and "(0, s), s between 0.3232233" in told.out
    for width in ("1/10", "1/1000000000000"):
        found = minkref(*ASKED["between"], "--tolerance", width, "--json").json["bracket"]
        low, high = Fraction(found["holds_to"]), Fraction(found["fails_from"])
        assert 0 < high - low <= high * Fraction(width) and not found["is_exact"]
    exact = minkref(*ASKED["anywhere"], "--json").json
    assert exact["bracket"]["holds_to"] == exact["bracket"]["fails_from"] == "15/4"
    assert exact["witness"]["scale"] == "15/4" and "(0, 15/4]" in minkref(*ASKED["anywhere"]).out
    assert "trapped    (3/4, " in minkref(*ASKED["trap"]).out
    assert "at no scale" in minkref(*ASKED["no way"]).out
    assert "at no scale" in minkref(*ASKED["nowhere free"]).out


def test_ends_with_more_digits_than_decimals_have_by_themselves_are_rounded_outwards() -> None:
    third = Fraction(1, 3)
    told = enclosing(str(third), str(third + Fraction(1, 10**32)), 34)
    assert told == f"between 0.{'3' * 34} and 0.{'3' * 31}4{'3'}4"


def test_one_scale_is_answered_for_any_part_with_all_its_clearances(minkref: Minkref) -> None:
    found = minkref(*ASKED["fit at a scale"], "--json").json
    assert found["holds"] and found["distances"]["to"]["squared_distance"] == "4"
    found = minkref(*ASKED["way at a scale"], "--json").json
    assert found["holds"] and found["cause"] == "neck"
    assert found["distances"]["to"]["squared_distance"] == "1/4"
    assert not minkref(*ASKED["no room at a scale"], "--json").json["holds"]
    assert minkref(*ASKED["trap at a scale"], "--json").json["holds"]


def test_pictures_show_the_part_with_its_clearance(minkref: Minkref, tmp_path: Path) -> None:
    for name in ("anywhere", "between", "exact between", "trap"):
        file = tmp_path / f"{name}.svg"
        assert "written" in minkref(*ASKED[name], "-o", str(file)).out
        drawn = file.read_text()
        assert 'class="first"' in drawn and 'class="tight"' in drawn and "clearance 1/4" in drawn
    nothing = tmp_path / "nothing.svg"
    minkref(*ASKED["no way"], "-o", str(nothing))
    assert "no part is shown" in nothing.read_text()
    kept = tmp_path / "kept.json"
    minkref(*ASKED["anywhere"], "-o", str(kept))
    assert json.loads(kept.read_text())["seconds"] is None


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("fit", HOOK, POCKET, "--anywhere", *KEPT), "no point of the part sees all of it"),
        (("fit", ASIDE, POCKET, *WAY, *KEPT), "origin to (2, 0)"),
        (("trap", ASIDE, ROOM, "--at", "4,4", *KEPT), "origin to (2, 0)"),
        (("trap", SQUARE, ROOM, "--at", "4,4", *KEPT, "--certify", "a.json"), "no certificate"),
        (("fit", SQUARE, POCKET, "--at", "3,3", *KEPT, "--scale", "1"), "for all scales"),
        (("fit", SQUARE, POCKET, "--anywhere", "--scale", "1"), "without a clearance"),
        (("trap", SQUARE, ROOM, "--at", "4,4", "--tolerance", "1"), "without a clearance"),
        ((*ASKED["trap at a scale"], "--tolerance", "1/9"), "one scale is decided"),
        ((*ASKED["trap at a scale"], "--from", "1"), "one scale is asked"),
        ((*ASKED["fit at a scale"], "-o", "a.svg"), "no file is written"),
        (("fit", SQUARE, "LINESTRING(0 0,4 0)", "--anywhere", *KEPT), "no area"),
        (("fit", "POINT(0 0)", POCKET, "--anywhere", *KEPT), "no extent"),
    ],
)
def test_refusals_say_what_and_how(minkref: Minkref, words: tuple[str, ...], says: str) -> None:
    ran = minkref(*words)
    assert ran.code == 2 and says in ran.err and "fix:" in ran.err
