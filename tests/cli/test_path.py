"""`minkref path`: documents, texts, forms of paths, refusals."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import schema

Minkref = Callable[..., Any]
PART = "POLYGON((2 0,3 0,3 1,2 1,2 0))"
WALLS = "MULTIPOLYGON(((1 0,4 0,4 1,1 1,1 0)),((6 0,9 0,9 1,6 1,6 0)))"
WAYS = {
    "way.wkt": "LINESTRING (0 0, 0 0.5)",
    "way.csv": "x,y\n0,0\n0,1/2\n",
    "bare.csv": "0, 0\n0, 5e-1\n",
    "way.geojson": '{"type": "LineString", "coordinates": [[0, 0], [0, 0.5]]}',
    "feature.json": '{"type": "Feature", "properties": {}, "geometry": '
    '{"type": "LineString", "coordinates": [[0, 0], [0, "1/2"]]}}',
}


def ranges(value: dict[str, Any]) -> list[tuple[str, str | None, bool, bool]]:
    return [(one["from"], one["to"], one["from_in"], one["to_in"]) for one in value["valid"]]


@pytest.mark.parametrize("route", ["pieces", "contacts", "index"])
def test_two_alone_is_valid_between_two_walls(minkref: Minkref, route: str) -> None:
    """[2 s, 3 s] meets (1, 4) for 1/3 < s < 2, and (6, 9) for 2 < s < 9/2."""
    value = minkref("path", PART, WALLS, "POINT (0 0)", "--route", route, "--json").json
    jsonschema.validate(value, schema("path"))
    assert ranges(value) == [
        ("0", "1/3", False, True),
        ("2", "2", True, True),
        ("9/2", None, True, False),
    ]
    assert [(b["scale"], b["event"]) for b in value["bounds"]] == [
        ("1/3", "blocks"),
        ("2", "frees"),
        ("2", "blocks"),
        ("9/2", "frees"),
    ]
    assert value["largest"] == {"scale": None, "is_valid": False}
    assert value["smallest"] == {"scale": "0", "is_valid": False}
    assert not value["star_shaped"]


def test_contact_forbidden_opens_the_ends(minkref: Minkref) -> None:
    way = (PART, WALLS, "POINT (0 0)", "--contact", "forbidden", "--from", "1/4", "--to", "5")
    value = minkref("path", *way, "--json").json
    assert ranges(value) == [("1/4", "1/3", True, False), ("9/2", "5", False, True)]
    assert "[1/4, 1/3), (9/2, 5]" in minkref("path", *way).out


@pytest.mark.parametrize("name", WAYS)
def test_a_path_is_read_in_each_form(minkref: Minkref, name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text(WAYS[name], encoding="utf-8")
    value = minkref("path", PART, WALLS, tmp_path / name, "--json").json
    inline = minkref("path", PART, WALLS, WAYS["way.wkt"], "--json").json
    assert (value["vertices"], value["valid"], value["bounds"]) == (
        2,
        inline["valid"],
        inline["bounds"],
    )


@pytest.mark.parametrize(
    ("name", "text", "where"),
    [
        ("way.wkt", "LINESTRING (0 0, 0 x)", "vertex 1"),
        ("way.wkt", "LINESTRING (0 0, 0 0 0)", "vertex 1"),
        ("way.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 0))", "LINESTRING"),
        ("way.wkt", "LINESTRING EMPTY", "no vertex"),
        ("way.csv", "x,y\n0,0\n0\n", "vertex 1"),
        ("way.csv", "0,0\n1/0,0\n", "vertex 1"),
        ("way.csv", "", "no vertex"),
        ("way.geojson", '{"type": "LineString", "coordinates": [[0, 0], 3]}', "vertex 1"),
        ("way.geojson", '{"type": "Polygon", "coordinates": []}', "LineString"),
        ("way.geojson", "{", "JSON"),
        ("way.txt", "0 0", ".csv"),
    ],
)
def test_a_bad_path_is_refused_with_file_and_vertex(
    minkref: Minkref, name: str, text: str, where: str, tmp_path: Path
) -> None:
    (tmp_path / name).write_text(text, encoding="utf-8")
    ran = minkref("path", PART, WALLS, tmp_path / name)
    assert ran.code == 2
    assert name in ran.err and where in ran.err and "fix:" in ran.err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ((PART, WALLS, "nowhere.csv"), "no such file"),
        ((PART, WALLS, "POINT (0 0)", "--contact", "maybe"), "allowed, forbidden"),
        ((PART, WALLS, "POINT (0 0)", "--route", "piece"), "did you mean pieces"),
        (("POINT (0 0)", "POINT (1 1)", "POINT (0 0)"), "without area"),
        ((PART, WALLS, "POINT (0 0)", "--from", "3", "--to", "2"), "3"),
    ],
)
def test_wrong_use_is_refused(minkref: Minkref, words: tuple[str, ...], said: str) -> None:
    ran = minkref("path", *words)
    assert ran.code == 2
    assert said in ran.err


def test_the_document_is_written_too(minkref: Minkref, tmp_path: Path) -> None:
    ran = minkref("path", PART, WALLS, "POINT (0 0)", "-o", tmp_path / "valid.json")
    written = json.loads((tmp_path / "valid.json").read_text(encoding="utf-8"))
    jsonschema.validate(written, schema("path"))
    assert "2 alone" in ran.out
    assert "valid.json" in ran.out
