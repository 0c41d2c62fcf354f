"""`minkref view PART OBSTACLES --path PATH` and the picture of `minkref path`: documents, data,
refusals."""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import jsonschema
import minkref as api
import pytest
from minkref.motion.page import picture
from minkref.plane.operand import read_operand
from minkref.schemas import result_schema, schema

Minkref = Callable[..., Any]
PART = "POLYGON((2 0,3 0,3 1,2 1,2 0))"
WALLS = "MULTIPOLYGON(((1 0,4 0,4 1,1 1,1 0)),((6 0,9 0,9 1,6 1,6 0)))"
WAY = "LINESTRING (0 0, 1 0, 1 0, 1 3)"
VIEW = ("view", PART, WALLS, "--path", WAY)


def data_of(page: Path) -> dict[str, Any]:
    import json

    found = re.search(
        r'<script id="data" type="application/json">(.*?)</script>',
        page.read_text(encoding="utf-8"),
        re.S,
    )
    assert found
    value: dict[str, Any] = json.loads(found[1])
    return value


@pytest.mark.parametrize("contact", ["allowed", "forbidden"])
def test_the_document_and_the_data_are_those_of_the_reference(
    minkref: Minkref, tmp_path: Path, contact: str
) -> None:
    page = tmp_path / "way.html"
    ran = minkref(*VIEW, "--contact", contact, "-o", page, "--json")
    assert (ran.code, ran.err) == (0, "")
    jsonschema.validate(ran.json, result_schema("view_with_path"))
    jsonschema.validate(ran.json, schema("view"))
    path = minkref("path", PART, WALLS, WAY, "--contact", contact, "--json").json
    assert ran.json["valid"] == path["valid"]
    assert ran.json["bounds"] == len(path["bounds"])
    data = data_of(page)
    bounds = [{key: bound[key] for key in bound if key != "about"} for bound in data["bounds"]]
    assert bounds == path["bounds"]
    part, walls = read_operand(PART).set, read_operand(WALLS).set
    exact = api.bad_polygons(part, walls, [(0, 0), (1, 0), (1, 0), (1, 3)], ran.json["to"], contact)
    assert len(exact) == len(data["polygons"]) == ran.json["polygons"] > 3
    for polygon, (segment, own, other, *numbers) in zip(exact, data["polygons"], strict=True):
        assert segment == polygon.segment
        assert numbers == [float(number) for corner in polygon.corners for number in corner]
        assert data["pieces"]["part"][own] == [float(n) for place in polygon.part for n in place]
        assert data["pieces"]["obstacles"][other] == [
            float(n) for place in polygon.obstacle for n in place
        ]


def test_bad_polygons_are_as_computed_by_hand() -> None:
    """[2 s, 3 s] moved by t meets (1, 4) iff t + 2 s < 4 and t + 3 s > 1."""
    part, wall = read_operand(PART).set, read_operand("POLYGON((1 0,4 0,4 1,1 1,1 0))").set
    (polygon,) = api.bad_polygons(part, wall, [(0, 0), (1, 0)], 5)
    assert set(polygon.corners) == {
        (Fraction(0), Fraction(1, 3)),
        (Fraction(1), Fraction(0)),
        (Fraction(1), Fraction(3, 2)),
        (Fraction(0), Fraction(2)),
    }
    with pytest.raises(api.LimitExceeded):
        api.bad_polygons(part, wall, [(0, 0), (1, 0)], 5, most=0)
    with pytest.raises(api.BadInput, match="window"):
        api.bad_polygons(part, wall, [(0, 0), (1, 0)], 1, from_scale=2)


def test_the_window_is_around_the_bounds(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "way.html"
    last = Fraction(minkref(*VIEW, "-o", page, "--json").json["to"])
    largest = max(bound["about"]["scale"] for bound in data_of(page)["bounds"])
    assert largest < last < 2 * largest
    away = ("view", PART, WALLS, "--path", "POINT (0 9)", "-o", page, "--json")
    assert minkref(*away).json["to"] == "3"
    value = minkref(*VIEW, "-o", page, "--from", "1/2", "--to", "5/2", "--json").json
    assert (value["from"], value["to"]) == ("1/2", "5/2")
    heights = [s for _, _, _, *ts in data_of(page)["polygons"] for s in ts[1::2]]
    assert 0.5 <= min(heights) <= max(heights) <= 2.5


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ((*VIEW, "--contact", "maybe"), "allowed, forbidden"),
        ((*VIEW, "--route", "index"), "--route"),
        ((*VIEW, "--scale", "1"), "--scale"),
        ((*VIEW, "--from", "2", "--to", "1"), "window"),
        ((*VIEW, "--to", "0"), "--to"),
        (("view", PART, WALLS, "--path", "nowhere.csv"), "no such file"),
        (("view", PART, WALLS, "--contact", "allowed"), "--path"),
        (("view", PART, "POINT (3 3)", "--path", "POINT EMPTY"), "no vertex"),
        (("view", "POINT (1 1)", "POINT (3 3)", "--path", WAY), "without area"),
        (("view", PART, "disc", "--path", WAY), "disc"),
    ],
)
def test_wrong_use_is_refused(
    minkref: Minkref, tmp_path: Path, words: tuple[str, ...], said: str
) -> None:
    page = tmp_path / "way.html"
    ran = minkref(*words, "-o", page)
    assert ran.code == 2
    assert said in ran.err
    assert not page.exists()


def test_too_many_polygons_are_refused(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(picture, "MOST_POLYGONS", 2)
    for words in ((*VIEW, "-o", tmp_path / "way.html"), ("path", PART, WALLS, WAY, "-o")):
        last = words if words[-1] != "-o" else (*words, tmp_path / "way.svg")
        ran = minkref(*last)
        assert ran.code == 2
        assert "more than 2 polygons" in ran.err
    assert list(tmp_path.iterdir()) == []


def test_the_path_is_not_overwritten(minkref: Minkref, tmp_path: Path) -> None:
    way = tmp_path / "way.html"
    way.with_suffix(".wkt").write_text(WAY, encoding="utf-8")
    way.symlink_to(way.with_suffix(".wkt"))
    ran = minkref("view", PART, WALLS, "--path", way.with_suffix(".wkt"), "-o", way)
    assert ran.code == 2
    assert way.read_text(encoding="utf-8") == WAY


@pytest.mark.parametrize("way", [WAY, "POINT (0 0)", "LINESTRING (0 0, 0 0)"])
def test_the_picture_has_each_polygon_range_and_bound(
    minkref: Minkref, tmp_path: Path, way: str
) -> None:
    drawn = tmp_path / "way.svg"
    value = minkref("path", PART, WALLS, way, "-o", drawn, "--json").json
    root = ElementTree.fromstring(drawn.read_text(encoding="utf-8"))
    classes = [one.get("class") for one in root.iter()]
    assert value["output"] == str(drawn)
    assert classes.count("bound") == len(value["bounds"])
    single = sum(one["from"] == one["to"] for one in value["valid"])
    assert classes.count("alone") == single
    assert classes.count("range") == len(value["valid"]) - single
    assert classes.count("bad") >= 2


def test_the_picture_of_the_docs_is_what_the_command_draws(
    minkref: Minkref, tmp_path: Path
) -> None:
    bolt = "POLYGON ((-4 -30, 4 -30, 4 0, 9 0, 9 6, -9 6, -9 0, -4 0, -4 -30))"
    bracket = (
        "MULTIPOLYGON (((-24 -8, -4.2 -8, -4.2 0, -24 0, -24 -8)), "
        "((4.3 -8, 24 -8, 24 10, 9.6 10, 9.6 0, 4.3 0, 4.3 -8)))"
    )
    way = "LINESTRING (-3 45, -3 34, 0 31.6, 0 0)"
    minkref("path", bolt, bracket, way, "-o", tmp_path / "diagram.svg")
    shown = Path(__file__).resolve().parents[2] / "docs" / "paths-diagram.svg"
    assert (tmp_path / "diagram.svg").read_text(encoding="utf-8") == shown.read_text(
        encoding="utf-8"
    )
