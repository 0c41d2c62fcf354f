"""`minkref fit` and `minkref trap`: documents, proofs, and the word translation."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import jsonschema
import pytest
from minkref.schemas import schema

Minkref = Callable[..., Any]
SVG = "{http://www.w3.org/2000/svg}"
SQUARE = "POLYGON((-0.5 -0.5,0.5 -0.5,0.5 0.5,-0.5 0.5,-0.5 -0.5))"
# [0, 4] x [0, 4], with a door of width 1.
ROOM = "POLYGON((-1 -1,5 -1,5 1.5,4 1.5,4 0,0 0,0 4,4 4,4 2.5,5 2.5,5 5,-1 5,-1 -1))"
ROOMS = "POLYGON((0 0,4 0,4 1,5 1,5 0,9 0,9 4,5 4,5 2,4 2,4 4,0 4,0 0))"
RING = "POLYGON((-2 -2,2 -2,2 2,-2 2,-2 -2),(-1 -1,-1 1,1 1,1 -1,-1 -1))"


def ranges(value: dict[str, Any]) -> list[tuple[str, str | None, bool, bool]]:
    return [(one["from"], one["to"], one["from_in"], one["to_in"]) for one in value["scales"]]


def holds_beside_each_bound(value: dict[str, Any]) -> bool:
    """Proofs say so: at each bound, just below it and just above."""
    scales = [proof["scale"] for proof in value["proofs"]]
    return all(bound["scale"] in scales for bound in value["bounds"]) and len(scales) >= 3


@pytest.mark.parametrize(
    ("contact", "from_in", "to_in"), [("allowed", False, True), ("forbidden", True, False)]
)
def test_a_square_too_wide_for_the_door_is_trapped(
    minkref: Minkref, contact: str, from_in: bool, to_in: bool
) -> None:
    words = (SQUARE, ROOM, "--at", "2,2", "--contact", contact)
    value = minkref("trap", *words, "--json").json
    jsonschema.validate(value, schema("trap"))
    assert ranges(value) == [("1", "4", from_in, to_in)]
    assert [bound["event"] for bound in value["bounds"]] == ["split", "contact"]
    assert holds_beside_each_bound(value)
    told = minkref("trap", *words).out
    assert "by translation" in told
    assert "rotation" in told and "rotation" in value["motion"]


@pytest.mark.parametrize(
    ("part", "container", "question", "expected"),
    [
        (SQUARE, ROOMS, ("--at", "1,2"), [("0", "2", False, True)]),
        (SQUARE, ROOMS, ("--anywhere",), [("0", "4", False, True)]),
        (SQUARE, ROOMS, ("--between", "2,2", "7,2"), [("0", "1", False, True)]),
        (RING, RING, ("--anywhere",), [("0", "1/4", False, True), ("1", "1", True, True)]),
    ],
)
def test_scales_at_which_a_part_fits(
    minkref: Minkref,
    part: str,
    container: str,
    question: tuple[str, ...],
    expected: list[tuple[str, str, bool, bool]],
) -> None:
    value = minkref("fit", part, container, *question, "--json").json
    jsonschema.validate(value, schema("fit"))
    assert ranges(value) == expected
    assert value["largest"] == {"scale": expected[-1][1], "is_valid": True}
    assert holds_beside_each_bound(value)
    assert "translations only" in minkref("fit", part, container, *question).out


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("fit", SQUARE, ROOM), "one question"),
        (("fit", SQUARE, ROOM, "--anywhere", "--at", "1,1"), "one question"),
        (("fit", SQUARE, ROOM, "--at", "1"), "not a point"),
        (("fit", "POINT (1 1)", ROOM, "--anywhere"), "no extent"),
        (("fit", SQUARE, "POINT (1 1)", "--anywhere"), "without area"),
        (("trap", SQUARE, ROOM), "--at"),
        (("trap", SQUARE, ROOM, "--at", "2,2", "--contact", "never"), "allowed, forbidden"),
    ],
)
def test_wrong_use_is_refused(minkref: Minkref, words: tuple[str, ...], said: str) -> None:
    ran = minkref(*words)
    assert ran.code == 2
    assert said in ran.err


def test_a_picture_shows_the_part_at_its_greatest_scale(minkref: Minkref, tmp_path: Path) -> None:
    """A square of side 2 in a room with an oblique corner: the corner of the part touches it."""
    square = "POLYGON((0 0,2 0,2 2,0 2,0 0))"
    room = "POLYGON((0 0,9 0,9 7,3 9,0 9,0 0))"
    picture = tmp_path / "fit.svg"
    ran = minkref("fit", square, room, "--at", "1,2", "-o", picture, "--json")
    assert ran.json["output"] == str(picture)
    text = picture.read_text(encoding="utf-8")
    lines = [each.text for each in ElementTree.fromstring(text).iter(f"{SVG}text")]
    assert lines == [
        "at the scale 23/8, origin at (1, 2)", "fits: (0, 23/8]", "x 0 to 9, y 0 to 9",
    ]  # fmt: skip
    assert text.count('class="first"') == text.count('class="second"') == 1
    assert 'class="tight"' in text, "the contact"
    minkref("trap", square, f"{room[:-1]},(1 1,1 8,6 7,8 1,1 1))", "--at", "2,2", "-o", picture)
    assert "trapped: " in picture.read_text(encoding="utf-8")
    minkref("fit", square, room, "--at", "50,50", "-o", picture)
    assert "fits: none" in picture.read_text(encoding="utf-8")
    assert minkref("fit", square, room, "--anywhere", "-o", "fit.png").code == 2
