"""`minkref sum --passages` with polyhedra."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import schema
from written_solids import SQUARE, cube, frame, hollow_cube, polygon

Minkref = Callable[..., Any]


@pytest.fixture
def found(minkref: Minkref, tmp_path: Path) -> Callable[..., dict[str, Any]]:
    def call(P: str, Q: str, *words: str) -> dict[str, Any]:
        paths = [tmp_path / "P.off", tmp_path / "Q.off"]
        for path, text in zip(paths, (P, Q), strict=True):
            path.write_text(text, encoding="utf-8")
        ran = minkref("sum", *paths, "--json", *words)
        assert ran.code == 0, ran.out
        jsonschema.validate(ran.json, schema("sum"))
        value: dict[str, Any] = ran.json
        return value

    return call


def test_a_cube_in_a_cavity_of_its_size(found: Any) -> None:
    value = found(hollow_cube(), cube(), "--passages")
    assert value["passages_complete"] and value["cavities"] == 0
    assert value["tight_passages"] == {"lines": [], "points": [["2", "2", "2"]], "sheets": []}


def test_a_cube_in_a_tunnel_of_its_width(found: Any) -> None:
    value = found(frame(), cube(2), "--passages")
    line = [["3", "3", "0"], ["3", "3", "3"]]
    assert value["tight_passages"] == {"lines": [line], "points": [], "sheets": []}


def test_a_cube_in_a_slot_of_its_width(found: Any) -> None:
    value = found(frame(), cube(2), "--passages", "--scale", "2,1,1")
    (sheet,) = value["tight_passages"]["sheets"]
    assert sheet["normal"] == ["0", "1", "0"] and sheet["offset"] == "3"
    (polygon,) = sheet["region"]["polygons"]
    assert polygon["outer"] == [["4", "0"], ["6", "0"], ["6", "3"], ["4", "3"]]


def test_they_are_found_where_asked_for(found: Any) -> None:
    value = found(hollow_cube(), cube())
    assert value["tight_passages"] is None and not value["passages_complete"]
    value = found(cube(2), cube())
    assert value["passages_complete"]  # convex operands have none
    assert value["tight_passages"] == {"lines": [], "points": [], "sheets": []}


def test_the_table_counts_them(minkref: Minkref, tmp_path: Path) -> None:
    (tmp_path / "P.off").write_text(hollow_cube(), encoding="utf-8")
    (tmp_path / "Q.off").write_text(cube(), encoding="utf-8")
    ran = minkref("sum", tmp_path / "P.off", tmp_path / "Q.off", "--passages")
    assert "tight sheets, lines, points" in ran.out and "0, 0, 1" in ran.out


def test_a_plane_polygon_is_refused(minkref: Minkref, tmp_path: Path) -> None:
    (tmp_path / "P.off").write_text(hollow_cube(), encoding="utf-8")
    (tmp_path / "Q.off").write_text(polygon(SQUARE), encoding="utf-8")
    ran = minkref("sum", tmp_path / "P.off", tmp_path / "Q.off", "--passages")
    assert ran.code == 2 and "leave --passages out" in ran.err
