"""`minkref decompose`: documents, files, options, refusals."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref import read_file
from minkref.exact import digest, set_json

Minkref = Callable[..., Any]
SLOT = "POLYGON ((0 0, 6 0, 6 6, 4 6, 4 1, 2 1, 2 6, 0 6, 0 0))"
RING = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (2 3, 2 5, 6 5, 6 3, 2 3))"


def test_the_document_has_notches_cuts_and_pieces(minkref: Minkref) -> None:
    value = minkref("decompose", SLOT, "--json").json
    assert (value["alpha"], value["to"], value["persistence"]) == ("0", None, "0")
    assert [notch["vertex"] for notch in value["notches"]] == [["2", "1"], ["4", "1"]]
    assert [notch["cut"] for notch in value["notches"]] == [0, 1]
    assert [notch["death"] for notch in value["notches"]] == [None, {"low": 2, "high": 2}]
    assert value["cuts"] == [
        {"from": ["2", "1"], "to": ["2", "0"], "squared_length": "1", "notch": 0, "wall": None},
        {"from": ["4", "1"], "to": ["4", "0"], "squared_length": "1", "notch": 1, "wall": None},
    ]
    assert [piece["area"] for piece in value["pieces"]] == ["12", "2", "12"]
    assert all(piece["convex"] and piece["bars"] == 0 for piece in value["pieces"])
    rows = [(piece["outer"], piece["holes"]) for piece in value["pieces"]]
    assert value["digest"] == digest(set_json(rows))


def test_a_persistence_leaves_longer_features_alone(minkref: Minkref) -> None:
    value = minkref("decompose", SLOT, "--persistence", "2", "--json").json
    assert len(value["cuts"]) == 1
    left, right = value["pieces"]
    assert left["convex"] and not right["convex"]
    assert (right["bars"], right["endless_bars"], right["longest_bar"]) == (1, 1, None)
    assert minkref("decompose", SLOT, "--persistence", "inf", "--json").json["cuts"] == []


def test_a_range_counts_the_part_of_bars_inside(minkref: Minkref) -> None:
    words = ("decompose", SLOT, "--from", "1", "--to", "2", "--json", "--persistence")
    assert len(minkref(*words, "1/2").json["notches"]) == 2
    value = minkref(*words, "1").json
    assert (value["notches"], value["alpha"], value["to"]) == ([], "1", "2")


def test_a_cut_from_a_hole_is_told_as_a_slit(minkref: Minkref) -> None:
    (piece,) = minkref("decompose", RING, "--persistence", "2", "--json").json["pieces"]
    assert piece["slits"] == [[["2", "3"], ["0", "3"]]]
    assert (len(piece["holes"]), piece["area"]) == (1, "73")


@pytest.mark.parametrize("ending", ["wkt", "geojson", "json"])
def test_files_hold_the_pieces(minkref: Minkref, tmp_path: Path, ending: str) -> None:
    file = tmp_path / f"pieces.{ending}"
    value = minkref("decompose", SLOT, "-o", file, "--json").json
    assert (value["output"], value["output_exact"]) == (str(file), True)
    pieces = read_file(file)
    assert [len(polygon) for polygon in pieces.rings()] == [1, 1, 1]
    assert minkref("union", file, "--json").json["area"] == "26"


def test_a_picture_has_the_cuts(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "pieces.svg"
    assert minkref("decompose", SLOT, "-o", file).code == 0
    assert 'class="cut"' in file.read_text() and "3 pieces, 2 cuts" in file.read_text()


def test_standard_output_takes_the_pieces_alone(minkref: Minkref) -> None:
    ran = minkref("decompose", SLOT, "-o", "-", "--format", "json")
    polygons = json.loads(ran.out)["polygons"]
    assert (ran.err, len(polygons)) == ("", 3)


def test_the_table_tells_counts_and_the_largest_pieces(minkref: Minkref) -> None:
    ran = minkref("decompose", "glyph275", "--persistence", "1")
    assert ran.code == 0
    for word in ("notches", "resolved already", "cuts", "convex", "longest that ends", "smaller"):
        assert word in ran.out


@pytest.mark.parametrize("thin", ["POINT (1 2)", "LINESTRING (0 0, 3 1)", "POLYGON EMPTY"])
def test_thin_shapes_have_no_pieces(minkref: Minkref, thin: str, tmp_path: Path) -> None:
    value = minkref("decompose", thin, "--json").json
    assert (value["notches"], value["cuts"], value["pieces"]) == ([], [], [])
    assert minkref("decompose", thin, "-o", tmp_path / "none.svg").code == 0


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("--alpha", "-1"), "the diameter is negative"),
        (("--persistence", "-1"), "the persistence is negative"),
        (("--persistence", "much"), "the persistence is not a number"),
        (("--from", "1"), "a range has two ends"),
        (("--from", "1", "--to", "2", "--alpha", "1"), "features are taken at one diameter"),
        (("--from", "2", "--to", "1"), "the range is empty"),
        (("-o", "pieces.poly"), "names no format"),
        (("-o", "pieces.png"), "names no format"),
    ],
)
def test_refusals_say_what_is_wrong(minkref: Minkref, words: tuple[str, ...], says: str) -> None:
    ran = minkref("decompose", SLOT, *words)
    assert ran.code == 2 and says in ran.err


def test_pieces_of_a_model_tile_it(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "pieces.json"
    value = minkref(
        "decompose", "g1", "--alpha", "2", "--persistence", "1", "-o", file, "--json"
    ).json
    area = sum(Fraction(piece["area"]) for piece in value["pieces"])
    assert str(area) == minkref("union", "g1", "--json").json["area"]
    assert len(read_file(file).rings()) == len(value["pieces"]) > 1
