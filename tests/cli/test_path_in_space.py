"""`minkref path` and `fit --at` in space: documents, texts, forms of paths, refusals."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import schema

Minkref = Callable[..., Any]
Corner = Sequence[int]
ORIGIN = "POINT Z (0 0 0)"
WAYS = {
    "way.wkt": "LINESTRING Z (0 0 0, 0 0.5 0)",
    "way.csv": "x,y,z\n0,0,0\n0,1/2,0\n",
    "bare.csv": "0, 0, 0\n0, 5e-1, 0\n",
    "way.geojson": '{"type": "LineString", "coordinates": [[0, 0, 0], [0, 0.5, 0]]}',
    "feature.json": '{"type": "Feature", "properties": {}, "geometry": '
    '{"type": "LineString", "coordinates": [[0, 0, 0], [0, "1/2", 0]]}}',
}


def boxes(*corners: tuple[Corner, Corner]) -> str:
    """An OFF file of boxes from a low to a high corner."""
    points: list[str] = []
    faces: list[str] = []
    for low, high in corners:
        ends = (low, high)
        first = len(points)
        for z in (0, 1):
            points += [
                f"{ends[x][0]} {ends[y][1]} {ends[z][2]}"
                for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))
            ]
        for ring in (
            (0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7),
        ):  # fmt: skip
            faces.append("4 " + " ".join(str(first + k) for k in ring))
    return "\n".join(["OFF", f"{len(points)} {len(faces)} 0", *points, *faces, ""])


@pytest.fixture
def scene(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "part.off").write_text(boxes(((2, 0, 0), (3, 1, 1))), encoding="utf-8")
    walls = boxes(((1, -9, -9), (4, 9, 9)), ((6, -9, -9), (9, 9, 9)))
    (tmp_path / "walls.off").write_text(walls, encoding="utf-8")
    (tmp_path / "room.off").write_text(boxes(((-1, -2, -3), (4, 5, 6))), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def ranges(value: dict[str, Any], field: str = "valid") -> list[tuple[str, str | None, bool, bool]]:
    return [(one["from"], one["to"], one["from_in"], one["to_in"]) for one in value[field]]


@pytest.mark.usefixtures("scene")
@pytest.mark.parametrize("route", ["pieces", "contacts"])
def test_two_alone_is_valid_between_two_walls(minkref: Minkref, route: str) -> None:
    """[2 s, 3 s] meets (1, 4) for 1/3 < s < 2, and (6, 9) for 2 < s < 9/2."""
    value = minkref("path", "part.off", "walls.off", ORIGIN, "--route", route, "--json").json
    jsonschema.validate(value, schema("path"))
    assert value["dimension"] == 3
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
    assert all(set(b["obstacle"]) <= {"vertex", "edge", "face"} for b in value["bounds"])


@pytest.mark.usefixtures("scene")
def test_contact_forbidden_opens_the_ends(minkref: Minkref) -> None:
    way = ("part.off", "walls.off", ORIGIN, "--contact", "forbidden", "--from", "1/4", "--to", "5")
    assert "[1/4, 1/3), (9/2, 5]" in minkref("path", *way).out


@pytest.mark.parametrize("name", WAYS)
def test_a_path_is_read_in_each_form(minkref: Minkref, name: str, scene: Path) -> None:
    (scene / name).write_text(WAYS[name], encoding="utf-8")
    value = minkref("path", "part.off", "walls.off", name, "--json").json
    inline = minkref("path", "part.off", "walls.off", WAYS["way.wkt"], "--json").json
    assert (value["vertices"], value["valid"], value["bounds"]) == (
        2,
        inline["valid"],
        inline["bounds"],
    )


@pytest.mark.usefixtures("scene")
@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("path", "part.off", "walls.off", "LINESTRING (0 0, 1 1)"), "space has three"),
        (("path", "part.off", "walls.off", "POINT Z (0 0)"), "space has three"),
        (("path", "part.off", "walls.off", "POINT Z EMPTY"), "no vertex"),
        (("path", "part.off", "POINT (0 0)", ORIGIN), "part.off lies in space"),
        (("path", "POINT (0 0)", "part.off", ORIGIN), "part.off lies in space"),
        (("path", "g1", "g2", ORIGIN), "plane has two"),
        (("path", "part.off", "walls.off", ORIGIN, "--route", "index"), "pieces or contacts"),
        (("path", "part.off", "walls.off", ORIGIN, "--from", "3", "--to", "2"), "3"),
        (("path", "part.off", "none.off", ORIGIN), "no such file"),
        (("path", "part.off", "walls.off", ORIGIN, "-o", "part.off"), "part.off"),
        (("fit", "part.off", "room.off"), "--at X,Y,Z"),
        (("fit", "part.off", "walls.off", "--anywhere", "--at", "0,0,0"), "one question"),
        (("fit", "part.off", "room.off", "--between", "0,0", "1,1"), "--at X,Y,Z"),
        (("fit", "part.off", "room.off", "--at", "0,0"), "three numbers"),
        (("fit", "part.off", "g1", "--at", "0,0,0"), "part.off lies in space"),
        (("trap", "part.off", "room.off", "--at", "0,0,0"), "strictly below the planes"),
    ],
)
def test_wrong_use_is_refused(minkref: Minkref, words: tuple[str, ...], said: str) -> None:
    ran = minkref(*words)
    assert ran.code == 2
    assert said in ran.err
    assert "fix:" in ran.err


@pytest.mark.usefixtures("scene")
def test_two_operands_without_volume_are_refused(minkref: Minkref, scene: Path) -> None:
    (scene / "point.json").write_text('{"vertices": [[0, 0, 0]], "faces": []}', encoding="utf-8")
    ran = minkref("path", "point.json", "point.json", ORIGIN)
    assert ran.code == 2
    assert "without volume" in ran.err
    value = minkref("path", "point.json", "walls.off", "POINT Z (1 0 0)", "--json").json
    assert ranges(value) == [("0", None, False, False)]


@pytest.mark.usefixtures("scene")
def test_a_part_fits_at_a_place(minkref: Minkref) -> None:
    """The part's far corner is s (3, 1, 1): 3 s <= 4 - 1."""
    value = minkref("fit", "part.off", "room.off", "--at", "1,0,0", "--json").json
    jsonschema.validate(value, schema("fit"))
    assert ranges(value, "scales") == [("0", "1", False, True)]
    [bound] = value["bounds"]
    assert bound["ends"] and bound["contact"]["obstacle"] == {"face": [3]}
    assert [proof["holds"] for proof in value["proofs"]] == [True, True, False]
    told = minkref("fit", "part.off", "room.off", "--at", "1,0,0", "--contact", "forbidden").out
    assert "(0, 1)" in told and "3 decisions at and beside the bounds" in told


def test_the_document_is_written_too(minkref: Minkref, scene: Path) -> None:
    ran = minkref("path", "part.off", "walls.off", ORIGIN, "-o", scene / "valid.json")
    written = json.loads((scene / "valid.json").read_text(encoding="utf-8"))
    jsonschema.validate(written, schema("path"))
    assert "2 alone" in ran.out
    assert "valid.json" in ran.out
