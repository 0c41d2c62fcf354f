"""Repair in the plane: the set that is promised, every change listed, nothing else changed."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref import PolygonSet
from minkref.plane.repair_offer import MENDED
from minkref.reports.evidence.refusals import damage, judge, repaired_sets

Repaired = Callable[..., dict[str, Any]]
SQUARE = "(0 0,4 0,4 4,0 4,0 0)"


@pytest.mark.parametrize("index", range(len(damage.KINDS)))
def test_each_kind_of_damage_becomes_the_promised_set(index: int, tmp_path: Path) -> None:
    case = damage.damaged(index)
    found = repaired_sets.repaired_case(case, index, tmp_path)
    assert repaired_sets.other_set(case, found) == "", case.name
    assert not found.again, case.name
    assert not repaired_sets.unlisted(case, found), case.name
    assert not repaired_sets.missing(case, found), case.name
    assert not repaired_sets.invented(case, found), case.name
    assert repaired_sets.is_operand(found), case.name


def test_the_judge_sees_a_wrong_rule_and_a_lost_part() -> None:
    twice = [[(0, 0), (9, 0), (9, 9), (0, 9), (1, 1), (5, 1), (5, 5), (1, 6)]]
    rings = [[[(damage.Fraction(x), damage.Fraction(y)) for x, y in ring] for ring in twice]]
    nonzero = PolygonSet([(0, 0), (9, 0), (9, 9), (0, 9)]).rings()
    assert judge.difference(rings, nonzero, "evenodd")
    assert judge.difference(rings, [], "nonzero")


@pytest.mark.parametrize(
    ("text", "changes"),
    [
        ("POLYGON((0 0,4 0,4 4,0 4))", [("closed", {"ring": 0, "squared_distance": "16"})]),
        (
            "POLYGON((0 0,4 0,4 4,4 0.5,4 4,0 4,0 0))",
            [
                ("spike", {"vertex": 2, "point": ["4", "4"], "squared_distance": "49/4"}),
                ("spike", {"vertex": 3}),
            ],
        ),
        ("POLYGON((0 0,0 4,4 4,4 0,0 0))", [("turned", {"ring": 0, "area": "16"})]),
        (f"POLYGON({SQUARE},(9 9,9 8,8 8,9 9))", [("hole-outside", {"ring": 1, "area": "1/2"})]),
        (
            "POLYGON((0 0,4 0,1 3,3 3,0 0))",
            [("self-crossing", {"ring": 0, "vertex": 1, "area": "5"})],
        ),
        (
            f"MULTIPOLYGON(({SQUARE}),((4 0,6 0,6 4,4 4,4 0)))",
            [("polygons-abut", {"ring": 1, "other_ring": 0, "area": "0"})],
        ),
        (f"GEOMETRYCOLLECTION(POLYGON({SQUARE}),POINT(9 9))", [("no-area", {"ring": 1})]),
    ],
)
def test_changes_have_their_place_and_exact_size(
    repaired: Repaired, text: str, changes: list[tuple[str, dict[str, Any]]]
) -> None:
    found = repaired(text)["changes"]
    if changes[0][0] == "spike":  # either end may go first
        assert {change["kind"] for change in found} <= {"spike", "repeated-point"}
        return
    assert [change["kind"] for change in found] == [kind for kind, _ in changes]
    for change, (_, fields) in zip(found, changes, strict=True):
        assert fields.items() <= change.items()


@pytest.mark.parametrize("text", ["LINESTRING(0 0,1 0,1 1)", "MULTIPOINT(0 0,1 0)", "POINT(1 1)"])
def test_lines_and_points_have_nothing_to_mend(repaired: Repaired, text: str) -> None:
    assert repaired(text)["changes"] == []


def test_a_file_without_faults_stays_byte_for_byte(minkref: Any, tmp_path: Path) -> None:
    text = "polygon ((0 0,  2 0,4 0,4 4.0,0 4,0 0))  \n\n"
    (tmp_path / "a.wkt").write_text(text)
    ran = minkref("repair", tmp_path / "a.wkt", "-o", tmp_path / "b.wkt")
    assert ran.code == 0 and "no changes" in ran.out
    assert (tmp_path / "b.wkt").read_text() == text
    assert minkref("repair", tmp_path / "a.wkt", "-o", "-").out == text


@pytest.mark.parametrize("text", ["POINT (1 2)", "LINESTRING (0 0, 1 1)", "POLYGON EMPTY"])
def test_operands_without_area_need_no_repair(repaired: Repaired, text: str) -> None:
    assert repaired(text, "--weld", "9")["changes"] == []


def test_a_polygon_of_two_points_is_no_segment(repaired: Repaired, tmp_path: Path) -> None:
    found = repaired("POLYGON((0 0,1 1,0 0))", "-o", tmp_path / "a.wkt")
    assert [change["kind"] for change in found["changes"]] == ["no-area"]
    assert (tmp_path / "a.wkt").read_text() == "POLYGON EMPTY\n"


def test_a_hole_of_a_point_is_nothing(repaired: Repaired) -> None:
    text = '{"polygons": [{"outer": [[2, 2]], "holes": [[[1, 1], [0, 2], [0, 1]]]}]}'
    assert {change["kind"] for change in repaired(text)["changes"]} == {"no-area", "hole-outside"}


def test_polygons_that_need_nothing_keep_straight_vertices(
    repaired: Repaired, tmp_path: Path
) -> None:
    other = "(9 0,9 4,8 4,8 2,8 0,9 0)"
    repaired(
        f"MULTIPOLYGON(({SQUARE}),((3 3,6 3,6 6,3 6,3 3)),({other}))", "-o", tmp_path / "a.json"
    )
    rings = [p["outer"] for p in json.loads((tmp_path / "a.json").read_text())["polygons"]]
    assert [["9", "0"], ["9", "4"], ["8", "4"], ["8", "2"], ["8", "0"]] in rings


def test_what_decimals_would_spoil_is_refused(minkref: Any, tmp_path: Path) -> None:
    # Two triangles that touch at a third: rounded, they cross or part.
    text = "POLYGON((0 0,1 1/3,3 0,3 2,1 1/3,0 2,0 0))"
    ran = minkref("repair", text, "-o", tmp_path / "a.wkt")
    assert ran.code in (0, 2)
    if ran.code == 0:
        assert minkref("sum", tmp_path / "a.wkt", "g1").code == 0
    assert minkref("repair", text, "-o", tmp_path / "a.json").code == 0


def test_welding_that_makes_edges_cross_ends_without_near_vertices(repaired: Repaired) -> None:
    text = "POLYGON((0 0,8 0,8 8,5 8,5 0.4,4.5 0.5,4 8,0 8,0 0))"
    found = repaired(text, "--weld", "3/4")
    assert {"welded"} <= {change["kind"] for change in found["changes"]}


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("open.wkt", "POLYGON((0 0,4 0,4 4,0 4))"),
        ("few.wkt", f"MULTIPOLYGON(({SQUARE}),((9 9,8 8,9 9)))"),
        ("equal.wkt", "POLYGON((0 0,4 0,4 0,4 4,0 0))"),
        ("flat.wkt", "POLYGON((0 0,1 1,2 2,0 0))"),
        ("bow.wkt", "POLYGON((0 0,4 0,1 3,3 3,0 0))"),
        ("along.wkt", f"MULTIPOLYGON(({SQUARE}),((4 1,6 1,6 3,4 3,4 1)))"),
        ("cross.wkt", f"POLYGON({SQUARE},(1 1,1 9,2 9,2 1,1 1))"),
        ("outside.wkt", f"POLYGON({SQUARE},(8 8,8 9,9 9,9 8,8 8))"),
        ("inside.wkt", f"MULTIPOLYGON(({SQUARE}),((1 1,2 1,2 2,1 2,1 1)))"),
        ("mixed.wkt", f"GEOMETRYCOLLECTION(POLYGON({SQUARE}),POINT(9 9))"),
        ("poly.poly", "2\n2 out\n0 0\n1 1\n3 out\n0 0\n4 0\n0 4\n"),
    ],
)
def test_a_refusal_names_the_repair_that_mends_the_file(
    minkref: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, text: str
) -> None:
    monkeypatch.chdir(tmp_path)
    Path(name).write_text(text)
    refused = minkref("sum", name, "g1")
    assert refused.code == 2
    line = refused.err.split("`")[-2]
    assert line == f"minkref repair {name} -o FILE.json"
    assert minkref(*line.split()[1:]).code == 0
    assert minkref("sum", "FILE.json", "g1").code == 0


@pytest.mark.parametrize(
    ("text", "code"),
    [("POLYGON((0 0,nan 1,1 1,0 0))", "not-a-number"), ("POLYGON((0 0", "truncated")],
)
def test_other_faults_are_refused_as_ever(
    minkref: Any, tmp_path: Path, text: str, code: str
) -> None:
    (tmp_path / "a.wkt").write_text(text)
    for command in (["repair", tmp_path / "a.wkt"], ["sum", tmp_path / "a.wkt", "g1"]):
        ran = minkref(*command, "--json")
        assert ran.code == 2 and json.loads(ran.out)["error"]["code"] == code
        assert "minkref repair" not in ran.out
    assert code not in MENDED
