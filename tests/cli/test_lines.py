"""Open lines on the command line: sums, remnants, files, discs, refusals."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import schema

Minkref = Callable[..., Any]
ROAD = "LINESTRING (0 0, 10 0, 10 10)"
SQUARE = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"


def test_a_line_and_a_square(minkref: Minkref) -> None:
    value = minkref("sum", ROAD, SQUARE, "--json").json
    jsonschema.validate(value, schema("sum"))
    assert (value["area"], value["components"], value["remnants"]) == ("44", 1, None)
    for route in ("winding", "definition", "dynamic", "index"):
        other = minkref("sum", ROAD, SQUARE, "--route", route, "--json").json
        assert other["digest"] == value["digest"]
    assert minkref("sum", SQUARE, ROAD, "--json").json["digest"] == value["digest"]


def test_two_lines_have_remnants(minkref: Minkref, tmp_path: Path) -> None:
    words = ("sum", ROAD, "LINESTRING (0 0, 3 0)")
    value = minkref(*words, "--json").json
    jsonschema.validate(value, schema("sum"))
    assert (value["area"], value["tight_passages"]) == ("30", None)
    assert [one["points"] for one in value["remnants"]] == [[["0", "0"], ["10", "0"]]]
    assert "remnants" in minkref(*words).out
    minkref(*words, "-o", str(tmp_path / "sum.svg"))


def test_a_road_is_grown_by_a_disc(minkref: Minkref, tmp_path: Path) -> None:
    value = minkref("sum", ROAD, "disc:1", "--json").json
    jsonschema.validate(value, schema("sum_with_disc"))
    assert (value["curves"], value["components"]) == (7, 1)
    assert (
        minkref("sum", ROAD, "disc:1", "--route", "paper", "--json").json["digest"]
        == (value["digest"])
    )
    path = tmp_path / "road.wkt"
    minkref("sum", ROAD, "disc:1", "-o", str(path), "--tolerance", "1/100")
    assert path.read_text().startswith("POLYGON")


def test_files_hold_lines(minkref: Minkref, tmp_path: Path) -> None:
    path = tmp_path / "road.geojson"
    path.write_text('{"type":"MultiLineString","coordinates":[[[0,0],[10,0],[10,10]]]}')
    case = tmp_path / "case.json"
    case.write_text(
        '{"schema":"case-v1","id":"road","title":"A road","dimension":2,"scales":["1"],'
        '"P":{"polygons":[{"outer":[[0,0],[10,0]]},{"outer":[[10,0],[10,10]]}]},'
        '"Q":{"polygons":[{"outer":[[0,0],[2,0],[2,2],[0,2]]}]}}'
    )
    expected = minkref("sum", ROAD, SQUARE, "--json").json["digest"]
    for name in (str(path), f"{case}#P"):
        assert minkref("sum", name, SQUARE, "--json").json["digest"] == expected


NO_LINES = {
    ("erode", SQUARE, ROAD),
    ("certify", ROAD, SQUARE, "-o", "x.cert.json"),
    ("convolution", ROAD, SQUARE),
    ("path", ROAD, SQUARE, "LINESTRING (0 0, 1 1)"),
    ("sum", ROAD, SQUARE, "--route", "paper-update"),
    ("features", ROAD),
    ("decompose", ROAD),
    ("opening", ROAD, "disc:1"),
}


@pytest.mark.parametrize("words", sorted(NO_LINES), ids=lambda words: words[0])
def test_what_takes_no_lines_says_what_does(minkref: Minkref, words: tuple[str, ...]) -> None:
    refused = minkref(*words)
    assert refused.code == 2 and "several segments or points" in refused.err
    assert "minkref sum" in refused.err
