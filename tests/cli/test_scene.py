"""`minkref scene`: the document, the scene's file and its copies as CSV, outputs and refusals."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import minkref as package
import pytest
from minkref.schemas import result_schema, schema

Minkref = Callable[..., Any]
UNIT = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"
COPIES = [
    {"shape": "box", "scale": "1", "place": ["0", "0"]},
    {"shape": "box", "scale": 1, "place": [2, 0]},
    {"shape": "box", "scale": 0.5, "place": ["3/2", 0.5]},
]
CSV = "shape,scale,x,y\nbox,1,0,0\nbox,1,2,0\n\nbox,0.5,3/2,.5\n"


def scene_text(**changes: Any) -> str:
    """A scene of three boxes; a member with the value None is left out."""
    value = {
        "schema": "scene-v1", "robot": UNIT, "shapes": {"box": UNIT}, "copies": COPIES, **changes,
    }  # fmt: skip
    return json.dumps({name: each for name, each in value.items() if each is not None})


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    path = tmp_path / "scene.json"
    path.write_text(scene_text(), encoding="utf-8")
    return path


def test_the_document_has_set_owners_and_passages(minkref: Minkref, scene: Path) -> None:
    value = minkref("scene", scene, "--owners", "--passages", "--json").json
    jsonschema.validate(value, schema("scene"))
    assert (value["area"], value["components"], value["holes"]) == ("8", 1, 0)
    assert value["result"]["polygons"] == [
        {"holes": [], "outer": [["-1", "-1"], ["3", "-1"], ["3", "1"], ["-1", "1"]]}
    ]
    assert [one["points"] for one in value["passages"]] == [[["1", "-1"], ["1", "-1/2"]]]
    assert [{one["copy"] for one in side} for side in value["passages"][0]["owners"]] == [{0, 1}]
    [ring] = value["owners"]
    assert [{one["copy"] for one in side} for side in ring] == [{0, 1}, {1}, {0, 1, 2}, {0}]
    assert value["shapes"] == [
        {"name": f'{scene}, shape "box"', "vertices": 4, "shape": "box", "copies": 3}
    ]
    assert value["copies"] == 3
    whole = minkref("scene", scene, "--json").json
    assert (whole["owners"], whole["passages"]) == (None, None)
    assert whole["digest"] == value["digest"] == package.read_scene(scene).digest


def test_the_table_tells_copies_set_and_passages(minkref: Minkref, scene: Path) -> None:
    told = minkref("scene", scene, "--passages", "--plot").out
    for line in ("copies             3 of 1 shape: 3 box", "area               8",
                 "components, holes  1, 0", "(1, -1) (1, -1/2)"):  # fmt: skip
        assert line in told
    assert "x -1 to 3, y -1 to 1" in told
    assert "tight passages" not in minkref("scene", scene).out


def test_copies_may_stand_in_a_csv_file(minkref: Minkref, scene: Path, tmp_path: Path) -> None:
    """The scene or the command names the file; columns have any order."""
    expected = minkref("scene", scene, "--json").json["digest"]
    (tmp_path / "copies.csv").write_text("\ufeff" + CSV, encoding="utf-8")
    turned = "y, X,scale,SHAPE\n0,0,1,box\n0,2,1,box\n0.5,1.5,1/2,box\n"
    (tmp_path / "turned.csv").write_text(turned, encoding="utf-8")
    scene.write_text(scene_text(copies="copies.csv"), encoding="utf-8")
    assert minkref("scene", scene, "--json").json["digest"] == expected
    for text in (scene_text(copies=None), scene_text(copies=[])):
        scene.write_text(text, encoding="utf-8")
        for name in ("copies.csv", "turned.csv"):
            value = minkref("scene", scene, "--copies", tmp_path / name, "--json").json
            assert (value["digest"], value["copies"]) == (expected, 3)
    again = package.read_scene(scene, tmp_path / "copies.csv")
    assert (again.digest, len(again.copies)) == (expected, 3)


def test_sets_of_a_scene_may_be_texts_files_models_or_polygons(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "scenes"
    folder.mkdir()
    (folder / "robot.wkt").write_text(UNIT, encoding="utf-8")
    square = [[0, 0], ["1", 0], ["1.0", 1], [0, "2/2"]]
    polygons = {"polygons": [{"outer": square}]}
    geojson = json.dumps(
        {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}
    )
    digests = set()
    for robot in (
        UNIT,
        "robot.wkt",
        "../scenes/robot.wkt",
        polygons,
        json.dumps(polygons),
        geojson,
    ):
        path = folder / "scene.json"
        path.write_text(scene_text(robot=robot, shapes={"box": "g1"}), encoding="utf-8")
        for words in ((path,), (path.read_text(encoding="utf-8"),)):
            monkeypatch.chdir(folder if isinstance(words[0], str) else tmp_path)
            value = minkref("scene", *words, "--json").json
            assert value["shapes"][0]["name"] == "g1"
            digests.add(value["digest"])
    assert len(digests) == 1


def test_numbers_count_exactly_as_written(minkref: Minkref, scene: Path) -> None:
    """0.1 means a tenth, and long numbers keep every digit."""
    long = "0.1000000000000000000000000000001"
    copy = f'{{"shape": "box", "scale": 1e-1, "place": [0.1, {long}]}}'
    text = scene_text(copies=[]).replace('"copies": []', f'"copies": [{copy}]')
    scene.write_text(text, encoding="utf-8")
    outer = minkref("scene", scene, "--json").json["result"]["polygons"][0]["outer"]
    assert outer[2] == ["1/5", "2000000000000000000000000000001/10000000000000000000000000000000"]


def test_sets_go_to_files_and_to_standard_output(
    minkref: Minkref, scene: Path, tmp_path: Path
) -> None:
    expected = "POLYGON ((-1 -1, 3 -1, 3 1, -1 1, -1 -1))\n"
    assert minkref("scene", scene, "-o", "-").out == expected
    for form in ("wkt", "geojson", "poly", "json", "svg"):
        path = tmp_path / f"out.{form}"
        value = minkref("scene", scene, "-o", path, "--json").json
        assert (value["output"], value["output_exact"]) == (str(path), form != "svg")
        if form != "svg":
            assert package.read_file(path) == package.PolygonSet(expected)
    assert (tmp_path / "out.svg").read_text(encoding="utf-8").startswith("<svg")


def test_an_example_follows_the_schema_of_the_file(scene: Path) -> None:
    jsonschema.validate(json.loads(scene.read_text(encoding="utf-8")), result_schema("scene_file"))


OVERLAPPING = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((1 0, 2 0, 2 1, 1 1, 1 0)))"


def copy_with(**changes: Any) -> list[dict[str, Any]]:
    return [*COPIES, {**COPIES[0], **changes}]


@pytest.mark.parametrize(
    ("changes", "where", "what"),
    [
        ({"copies": copy_with(shape="bx")}, "copy 3, shape", "did you mean box?"),
        ({"copies": copy_with(shape=0)}, "copy 3, shape", "named by a string, not by 0"),
        ({"copies": copy_with(scale="0")}, "copy 3, scale 0", "the scale is zero"),
        ({"copies": copy_with(scale=-2.5)}, "copy 3, scale -2.5", "negative"),
        ({"copies": copy_with(scale="two")}, "copy 3, scale two", "not a number"),
        ({"copies": copy_with(scale=True)}, "copy 3, scale", "not a number: true"),
        ({"copies": copy_with(scale=float("nan"))}, "copy 3, scale NaN", "not a finite number"),
        ({"copies": copy_with(place=[1])}, "copy 3, place", "two coordinates"),
        ({"copies": copy_with(place=[1, "1/0"])}, "copy 3, place, y", "denominator is zero"),
        ({"copies": copy_with(place=[1, "1" * 2000])}, "copy 3, place, y", "1000 characters"),
        ({"copies": copy_with(plaice=[1, 2])}, "copy 3", "did you mean place?"),
        ({"copies": [{"shape": "box"}]}, "copy 0", "scale is missing"),
        ({"copies": [7]}, "copy 0", "not an object: 7"),
        ({"copies": 7}, "copies", "no copies"),
        ({"copies": "gone.csv"}, "gone.csv", "cannot be read"),
        ({"copies": None}, "scene.json", "copies is missing"),
        ({"schema": "scene-v2"}, "schema", 'write "schema": "scene-v1"'),
        ({"robots": UNIT}, "scene.json", "did you mean robot?"),
        ({"robot": 7}, "robot", "no set: 7"),
        ({"robot": "g11"}, "robot", "did you mean g1?"),
        ({"robot": "gone.wkt"}, "robot, ", "no such file"),
        ({"robot": "-"}, "robot", "no such file"),
        ({"robot": {"polygon": []}}, "robot", "did you mean polygons?"),
        ({"shapes": []}, "shapes", "no shapes"),
        ({"shapes": {"box": "POLYGON ((0 0, 1 0, 2 0, 0 0))"}}, 'shape "box"', "on one line"),
        ({"shapes": {"box": OVERLAPPING}}, 'shape "box"', "overlap along an edge"),
        ({"robot": "POINT (0 0)", "shapes": {"box": "POINT (1 1)"}}, 'shape "box"', "has an area"),
    ],
)  # fmt: skip
def test_refusals_name_file_copy_and_field(
    minkref: Minkref, scene: Path, changes: dict[str, Any], where: str, what: str
) -> None:
    scene.write_text(scene_text(**changes), encoding="utf-8")
    ran = minkref("scene", scene, "--json")
    error = ran.json["error"]
    assert ran.code == 2
    assert where in error["where"] and (scene.name in error["where"] or "csv" in error["where"])
    assert what in f"{error['what']} {error['mend']}" and error["mend"]


@pytest.mark.parametrize(
    ("text", "where", "what"),
    [
        ("", "", "the file is empty"),
        ("shape,scale,x\nbox,1,2\n", "line 1", "lacks y"),
        ("shape,scale,x,z\n", "line 1", 'no column "z"'),
        ("shape,scale,x,x\n", "line 1", "column x is there twice"),
        (CSV + "box,1,2\n", "copy 3 (line 6)", "3 cells, not 4"),
        (CSV + "bx,1,2,3\n", "copy 3 (line 6), shape", "did you mean box?"),
        (CSV + "box,0,2,3\n", "copy 3 (line 6), scale 0", "zero"),
        (CSV + "box,1,2,three\n", "copy 3 (line 6), y", "not a number"),
    ],
)
def test_refusals_of_a_csv_file_name_copy_line_and_column(
    minkref: Minkref, scene: Path, tmp_path: Path, text: str, where: str, what: str
) -> None:
    path = tmp_path / "copies.csv"
    path.write_text(text, encoding="utf-8")
    ran = minkref("scene", scene, "--copies", path, "--json")
    error = ran.json["error"]
    assert (ran.code, "copies.csv" in error["where"]) == (2, True)
    assert where in error["where"] and what in f"{error['what']} {error['mend']}"


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("gone.json",), "No such file"),
        ((".",), "folder"),
        (("",), "name is empty"),
        (('{"robot": 1, "robot": 2}',), 'the member "robot" twice'),
        (("{",), "not JSON"),
        (("[" * 100_000,), "fix: "),
        (("scene.json", "--owners"), "add --json"),
        (("scene.json", "--threads", "0"), "between 1 and 256"),
        (("scene.json", "--plot", "--json"), "only one of them"),
        (("scene.json", "-o", "out.stl"), "names no format"),
        (("scene.json", "-o", "scene.json"), "file of an operand"),
        (("scene.json", "--copies", "."), "folder"),
    ],
    ids=lambda value: str(value)[:30],
)
def test_wrong_use_is_refused(
    minkref: Minkref,
    scene: Path,
    monkeypatch: pytest.MonkeyPatch,
    words: tuple[str, ...],
    told: str,
) -> None:
    monkeypatch.chdir(scene.parent)
    before = scene.read_text(encoding="utf-8")
    ran = minkref("scene", *words)
    assert ran.code == 2
    assert told in ran.err + ran.out
    assert scene.read_text(encoding="utf-8") == before and len(list(scene.parent.iterdir())) == 1


def test_files_of_a_scene_are_never_overwritten(
    minkref: Minkref, scene: Path, tmp_path: Path
) -> None:
    robot, copies = tmp_path / "robot.wkt", tmp_path / "copies.csv"
    robot.write_text(UNIT, encoding="utf-8")
    copies.write_text(CSV, encoding="utf-8")
    scene.write_text(scene_text(robot="robot.wkt", copies="copies.csv"), encoding="utf-8")
    for path in (robot, copies, scene):
        ran = minkref("scene", scene, "-o", path, "--format", "wkt")
        assert ran.code == 2 and "would be lost" in ran.err


def test_a_scene_that_needs_more_than_it_may_have_is_refused(
    minkref: Minkref, scene: Path, tmp_path: Path
) -> None:
    shapes = {"large": "cells1815", "letters": "glyph1204"}
    copies = [{"shape": "large", "scale": 1, "place": [0, 0]}]
    scene.write_text(scene_text(robot="glyph1204", shapes=shapes, copies=copies), encoding="utf-8")
    ran = minkref("scene", scene, "-o", tmp_path / "out.json", "--memory", "30", "--json")
    error = ran.json["error"]
    assert (ran.code, error["code"]) == (2, "memory-limit")
    assert "--memory" in error["mend"] and "scene.json" in error["where"]
    assert not (tmp_path / "out.json").exists()
