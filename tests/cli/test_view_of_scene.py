"""`minkref view SCENE`: the document, the data of the page, refusals."""

from __future__ import annotations

import io
import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import minkref as api
import pytest
from minkref.reports.evidence.pages.view import difference, true_polygons
from minkref.scene.page.picture import MOST_COPIES
from minkref.schemas import result_schema, schema
from page_decoder import Decoder, data_of

Minkref = Callable[..., Any]
ROBOT = "POLYGON((0 0,1 0,1 0.25,0 0))"
TEE = "POLYGON((0 0,6 0,6 1,4 1,4 5,2 5,2 1,0 1,0 0))"
SCENE: dict[str, Any] = {
    "schema": "scene-v1",
    "robot": ROBOT,
    "shapes": {"tee": TEE, "same": TEE, "point": "POINT(0.5 1)", "no": "g1"},
    "copies": [
        {"shape": "tee", "scale": "3/2", "place": ["1/3", 0.25]},
        {"shape": "same", "scale": 4, "place": ["-7", "1e2"]},
        {"shape": "point", "scale": "0.5", "place": [3, 4]},
        {"shape": "tee", "scale": "1.50", "place": [0, 0]},
    ],
}


def scene_file(folder: Path, **members: Any) -> Path:
    path = folder / "office.json"
    path.write_text(json.dumps({**SCENE, **members}), encoding="utf-8")
    return path


def test_the_document_and_the_data_are_those_of_the_scene(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    ran = minkref("view", scene_file(tmp_path), "-o", page, "--json")
    assert (ran.code, ran.err) == (0, "")
    jsonschema.validate(ran.json, result_schema("view_of_scene"))
    jsonschema.validate(ran.json, schema("view"))
    data = data_of(page.read_text(encoding="utf-8"))
    assert (ran.json["copies"], ran.json["sums"], ran.json["bytes"]) == (4, 2, page.stat().st_size)
    assert data["copies"] == [
        [0, "3/2", "1/3", "1/4"],
        [1, "4", "-7", "100"],
        [2, "1/2", "3", "4"],
        [0, "3/2", "0", "0"],
    ]
    assert [shape["name"] for shape in data["shapes"]] == ["tee", "same", "point", "no"]
    assert [shape["sum"] for shape in data["shapes"]] == [0, 0, 1, None]
    ends = [[text for text, _ in each["window"]] for each in data["sums"]]
    assert ends == [["3/4", "8"], ["1/4", "1"]]
    assert api.PolygonSet.from_json(json.dumps(data["robot"]["set"])) == api.PolygonSet(ROBOT)
    assert api.PolygonSet.from_json(json.dumps(data["shapes"][0]["set"])) == api.PolygonSet(TEE)


def test_rings_at_any_scale_are_those_of_the_sum_with_the_turned_robot(
    minkref: Minkref, tmp_path: Path
) -> None:
    page = tmp_path / "page.html"
    scene = scene_file(tmp_path, robot="g3", shapes={"g1": "g1", "g2": "g2"}, copies=[
        {"shape": "g1", "scale": 1, "place": [0, 0]}, {"shape": "g2", "scale": 2, "place": [0, 0]},
    ])  # fmt: skip
    assert minkref("view", scene, "-o", page).code == 0
    data = data_of(page.read_text(encoding="utf-8"))
    turned = api.read_file(model("g3")).scaled("-1")
    for name, sums, scales in zip(
        ("g1", "g2"), data["sums"], ((0.5, 0.77, 2.0), (1.0, 2.0, 3.9)), strict=True
    ):
        assert len(sums["about"]) > 0
        for scale in scales:
            wanted = true_polygons(api.read_file(model(name)), turned, scale)
            assert difference(Decoder(sums).polygons(scale), wanted) < 1e-9, (name, scale)


def model(name: str) -> str:
    from minkref.model_catalogue import all_models

    return str(all_models()[name].path)


def test_a_scene_comes_from_standard_input_and_as_a_text(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = json.dumps(SCENE)
    stream = io.TextIOWrapper(io.BytesIO(text.encode()))
    monkeypatch.setattr("sys.stdin", stream)
    for name in ("-", text):
        page = tmp_path / "page.html"
        assert minkref("view", name, "-o", page).code == 0
        assert len(data_of(page.read_text(encoding="utf-8"))["copies"]) == 4


def test_copies_come_from_a_table(minkref: Minkref, tmp_path: Path) -> None:
    page, table = tmp_path / "page.html", tmp_path / "moved.csv"
    table.write_text("shape,scale,x,y\ntee,1/2,0.25,-1\n", encoding="utf-8")
    assert minkref("view", scene_file(tmp_path), "--copies", table, "-o", page).code == 0
    assert data_of(page.read_text(encoding="utf-8"))["copies"] == [[0, "1/2", "1/4", "-1"]]
    ran = minkref("view", "g1", "g2", "--copies", table, "-o", page)
    assert (ran.code, "--copies" in ran.err) == (2, True)


def test_a_scene_without_copies_has_a_page(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    assert minkref("view", scene_file(tmp_path, copies=[]), "-o", page).code == 0
    assert data_of(page.read_text(encoding="utf-8"))["sums"] == []


def test_a_single_operand_that_is_no_scene_lacks_the_other(
    minkref: Minkref, tmp_path: Path
) -> None:
    plain = tmp_path / "set.json"
    plain.write_text(api.PolygonSet(TEE).to_json(), encoding="utf-8")
    for name in ("g1", TEE, plain, api.PolygonSet(TEE).to_json()):
        ran = minkref("view", name)
        assert ran.code == 2
        assert "Missing argument 'Q'" in ran.err


MANY = [{"shape": "tee", "scale": 1, "place": [0, 0]}] * (MOST_COPIES + 1)
FAR = [{"shape": "tee", "scale": 1, "place": ["1e400", 0]}]
TINY = [{"shape": "tee", "scale": "1e-400", "place": [0, 0]}]


@pytest.mark.parametrize(
    ("members", "options", "word"),
    [
        ({}, ["--from", "1"], "give copies other scales"),
        ({}, ["--path", "POINT (0 0)"], "for a scene"),
        ({}, ["--route", "dynamic"], "for a scene"),
        ({}, ["-o", "page.svg"], "ending"),
        ({}, ["-o", "office.json"], "ending"),
        ({"robot": None}, [], "robot"),
        ({"copies": MANY}, [], "a page holds 10,000"),
        ({"copies": FAR}, [], "the place of copy 0 is beyond the range of doubles"),
        ({"copies": TINY}, [], "copy 0, scale"),
    ],
)
def test_what_has_no_page_is_refused_with_a_mend(
    minkref: Minkref,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    members: dict[str, Any],
    options: list[str],
    word: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    scene = scene_file(tmp_path, **members)
    before = scene.read_bytes()
    ran = minkref("view", scene.name, *options)
    assert (ran.code, ran.out) == (2, "")
    assert word in ran.err
    assert "fix:" in ran.err
    assert list(tmp_path.iterdir()) == [scene]
    assert scene.read_bytes() == before


def test_a_point_and_a_segment_are_different_shapes(minkref: Minkref, tmp_path: Path) -> None:
    """Neither has a canonical form of its own."""
    shapes = {"point": "POINT(1 1)", "segment": "LINESTRING(0 0,2 1)"}
    copies = [{"shape": name, "scale": 1, "place": [0, 0]} for name in shapes]
    page = tmp_path / "page.html"
    assert minkref("view", scene_file(tmp_path, shapes=shapes, copies=copies), "-o", page).code == 0
    data = data_of(page.read_text(encoding="utf-8"))
    assert [shape["sum"] for shape in data["shapes"]] == [0, 1]


def test_missing_files_and_broken_scenes_are_told(minkref: Minkref, tmp_path: Path) -> None:
    assert "no such file" in minkref("view", tmp_path / "absent.json").err.lower()
    broken = tmp_path / "broken.json"
    broken.write_text('{"schema": "scene-v1", "robot"', encoding="utf-8")
    assert "not JSON" in minkref("view", broken).err


def test_scales_in_the_window_of_the_page_reach_twice_as_far() -> None:
    from minkref.scene.page.picture import window_of

    window = window_of([Fraction(1, 3), Fraction(5)])
    assert (window.first, window.last) == ("1/6", "10")
