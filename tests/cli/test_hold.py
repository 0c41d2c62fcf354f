"""`minkref hold`: documents, text, picture, certificates and refusals, in the plane and in space;
fits and traps of polyhedra."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import minkref as api
import pytest
from minkref.schemas import schema

Minkref = Callable[..., Any]
SQUARE = "POLYGON((-1 -1,1 -1,1 1,-1 1,-1 -1))"
ROOM = "POLYGON((-1 -1,9 -1,9 3,8 3,8 0,0 0,0 8,8 8,8 5,9 5,9 9,-1 9,-1 -1))"
WAY = "LINESTRING(4 4,20 4)"
HELD = {"from": "1", "to": "4", "from_in": False, "to_in": True}


@pytest.fixture
def solids(tmp_path: Path) -> tuple[str, str]:
    """A cube of half-width 1, and two plates with a gap of 2 between them."""
    sides = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]

    def box(low: tuple[int, ...], high: tuple[int, ...]) -> list[tuple[int, ...]]:
        (a, b, c), (x, y, z) = low, high
        flat = [(a, b), (x, b), (x, y), (a, y)]
        return [(p, q, h) for h in (c, z) for p, q in flat]

    cube = api.Polyhedron(box((-1, -1, -1), (1, 1, 1)), sides)
    plates = [*box((5, -9, 1), (6, 9, 9)), *box((5, -9, -9), (6, 9, -1))]
    both = api.Polyhedron(plates, [*sides, *([k + 8 for k in ring] for ring in sides)])
    names = []
    for name, solid in (("cube", cube), ("plates", both)):
        file = tmp_path / f"{name}.off"
        file.write_text(api.write_mesh(solid, "off"))
        names.append(str(file))
    return names[0], names[1]


def test_the_document_has_the_scales_and_both_contacts(minkref: Minkref) -> None:
    value = minkref("hold", SQUARE, ROOM, WAY, "--json").json
    jsonschema.validate(value, schema("hold"))
    [held] = value["held"]
    assert {key: held[key] for key in HELD} == HELD
    assert (held["begin"]["cause"], held["begin"]["scale"]) == ("way", "1")
    assert (held["end"]["cause"], held["end"]["scale"]) == ("place", "4")
    assert held["stop"]["at"]["point"] == ["11/2", "4"]
    assert [one["to"] for one in (*value["fits"]["scales"], *value["way"]["scales"])] == ["4", "1"]
    assert value["largest"] == {"scale": "4", "is_valid": True}
    assert value["at"] == ["4", "4"] and "another way" in value["motion"]


def test_people_are_told_what_stops_the_part(minkref: Minkref) -> None:
    told = minkref("hold", SQUARE, ROOM, WAY).out
    for words in ("(1, 4]", "begins, segment 0", "ends, at the place", "stops, segment 0"):
        assert words in told


def test_the_picture_shows_the_held_scales(minkref: Minkref, tmp_path: Path) -> None:
    picture = tmp_path / "held.svg"
    minkref("hold", SQUARE, ROOM, WAY, "-o", str(picture))
    assert 'class="held band"' in picture.read_text()
    minkref("hold", SQUARE, ROOM, "POINT(4 4)", "-o", str(picture))
    assert 'class="held band"' not in picture.read_text()


def test_two_certificates_prove_the_answer(minkref: Minkref, tmp_path: Path) -> None:
    """One certificate for the scales that fit, one for the way; `path` proves both alike."""
    name = str(tmp_path / "held.cert.json")
    value = minkref("hold", SQUARE, ROOM, WAY, "--certify", name, "--json").json
    jsonschema.validate(value, schema("hold"))
    files = [tmp_path / f"held-{one}.cert.json" for one in ("place", "way")]
    assert [one["output"] for one in value["certificates"]] == [str(file) for file in files]
    assert all(one["verified"] for one in value["certificates"])
    claims = [json.loads(file.read_text())["claims"][-1] for file in files]
    assert [[one["to"] for one in claim["valid"]] for claim in claims] == [["4"], ["1"]]
    assert minkref("check", *map(str, files)).code == 0


def test_in_space(minkref: Minkref, solids: tuple[str, str]) -> None:
    """Out between the plates the cube gets up to their gap; before it the scale 5 stops it."""
    words = ("hold", *solids, "LINESTRING Z (0 0 0, 40 0 0)")
    value = minkref(*words, "--json").json
    jsonschema.validate(value, schema("hold_in_space"))
    [held] = value["held"]
    assert (held["from"], held["to"], held["from_in"], held["to_in"]) == ("1", "5", False, True)
    assert "(1, 5]" in minkref(*words).out
    assert minkref(*words, "--certify", "a.cert.json").code == 2
    assert minkref(*words, "-o", "a.svg").code == 2


def test_fit_anywhere_and_trap_in_space(minkref: Minkref, solids: tuple[str, str]) -> None:
    cube, plates = solids
    value = minkref("fit", cube, cube, "--anywhere", "--json").json
    jsonschema.validate(value, schema("fit_in_space"))
    assert value["largest"] == {"scale": "1", "is_valid": True} and value["supports"]
    assert "place" in minkref("fit", cube, cube, "--anywhere").out
    at = minkref("fit", cube, cube, "--at", "0,0,0", "--json").json
    jsonschema.validate(at, schema("fit_in_space"))
    trap = minkref("trap", cube, plates, "--at", "0,0,0", "--json").json
    jsonschema.validate(trap, schema("trap_in_space"))
    assert trap["scales"] == [] and trap["largest"] is None


def test_the_last_place_is_told_apart_from_what_touches_there(
    minkref: Minkref, solids: tuple[str, str]
) -> None:
    """A cube fits into one of two plates up to half their thickness of 1."""
    cube, plates = solids
    told = minkref("fit", cube, plates, "--anywhere").out
    assert "(0, 1/2]" in told
    assert "ends: death of free places, (" in told and "): there vertex " in told


def test_a_window_keeps_only_the_bounds_of_its_ranges() -> None:
    """A cube in a closed room, up to its half-width 3: with contact forbidden no scale from 3 on,
    and so no bound there."""
    sides = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]

    def cube(half: int) -> list[tuple[int, int, int]]:
        flat = [(-half, -half), (half, -half), (half, half), (-half, half)]
        return [(x, y, z) for z in (-half, half) for x, y in flat]

    turned = [[k + 8 for k in reversed(ring)] for ring in sides]
    room = api.Polyhedron([*cube(5), *cube(3)], [*sides, *turned])
    part = api.Polyhedron(cube(1), sides)
    for contact, all_scales, last in (
        ("allowed", "(0, 3]", ["[3, 3]"]),
        ("forbidden", "(0, 3)", []),
    ):
        found = api.trapped_scales(part, room, (0, 0, 0), contact)
        assert [str(one) for one in found.ranges] == [all_scales]
        assert [bound.scale for bound in found.bounds] == [3]
        end = api.trapped_scales(part, room, (0, 0, 0), contact, 3)
        assert [str(one) for one in end.ranges] == last
        assert len(end.bounds) == len(last)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("hold", SQUARE, ROOM), "Missing argument 'way'"),
        (("hold", SQUARE, ROOM, "LINESTRING EMPTY"), "no vertex"),
        (("hold", SQUARE, ROOM, WAY, "--contact", "never"), "allowed, forbidden"),
        (("hold", SQUARE, ROOM, WAY, "--certify", "held.json"), "not a name for a certificate"),
        (("hold", "POINT (1 1)", "POINT (2 2)", WAY), "without area"),
    ],
)
def test_wrong_use_is_refused(minkref: Minkref, words: tuple[str, ...], said: str) -> None:
    ran = minkref(*words)
    assert ran.code == 2
    assert said in ran.err
