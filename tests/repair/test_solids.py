"""Repair in space: the solid that was damaged, every change listed, open surfaces refused."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref.reports.evidence.refusals import repaired_solids as solids

Repaired = Callable[..., dict[str, Any]]


@pytest.mark.parametrize("index", range(len(solids.KINDS)))
def test_each_kind_of_damage_becomes_the_solid_again(index: int, tmp_path: Path) -> None:
    name, solid = solids.damaged(index)
    found = solids.repaired_solid(solid, tmp_path)
    assert solids.other_solid(solid, found, random.Random(index)) == "", name
    assert not found.again, name
    told, expected = {change["kind"] for change in found.changes}, {solid.expected or "joined"}
    assert expected <= told <= expected | solids.LEADS_TO.get(solid.expected, set()), name


def box(**more: Any) -> solids.Solid:
    low, high = (Fraction(0),) * 3, (Fraction(2),) * 3
    solid = solids.Solid([], [], [(low, high)], [], **more)
    solid.add(low, high)
    return solid


def written(folder: Path, solid: solids.Solid) -> Path:
    file = folder / "solid.json"
    file.write_text(solid.text())
    return file


def test_an_open_surface_is_refused_with_its_boundary(minkref: Any, tmp_path: Path) -> None:
    solid = box()
    del solid.faces[1]
    ran = minkref("repair", written(tmp_path, solid))
    assert ran.code == 2
    assert "runs through vertices 4 (0, 0, 2), 5 (2, 0, 2), 7 (2, 2, 2), 6 (0, 2, 2)" in ran.err
    assert "minkref repair" not in minkref("sum", written(tmp_path, solid), "gs3").err


def test_a_valid_solid_stays_byte_for_byte(minkref: Any, tmp_path: Path) -> None:
    text = box().text() + "\n \n"
    (tmp_path / "a.json").write_text(text)
    ran = minkref("repair", tmp_path / "a.json", "--weld", "1", "-o", tmp_path / "b.json")
    assert ran.code == 0 and "no changes" in ran.out
    assert (tmp_path / "b.json").read_text() == text


@pytest.mark.parametrize(
    ("rule", "kind", "volume"), [("nonzero", "turned-shell", "8"), ("evenodd", "turned-shell", "8")]
)
def test_a_shell_inside_out_is_turned(
    repaired: Repaired, tmp_path: Path, rule: str, kind: str, volume: str
) -> None:
    solid = box()
    solid.faces = [face[::-1] for face in solid.faces]
    found = repaired(written(tmp_path, solid), "--rule", rule)
    assert [change["kind"] for change in found["changes"]] == [kind]
    assert found["changes"][0]["volume"] == found["volume"] == volume


def test_a_body_in_another_is_dropped_or_hollows_it(repaired: Repaired, tmp_path: Path) -> None:
    solid = box()
    half, three = Fraction(1, 2), Fraction(3, 2)
    solid.add((half,) * 3, (three,) * 3)
    file = written(tmp_path, solid)
    assert repaired(file)["volume"] == "8"
    found = repaired(file, "--rule", "evenodd")
    assert found["volume"] == "7"
    assert found["changes"] == [{"kind": "turned-shell", "face": 6, "faces": 6, "volume": "1"}]


def test_solids_that_overlap_are_refused(minkref: Any, tmp_path: Path) -> None:
    solid = box()
    solid.add((Fraction(1),) * 3, (Fraction(3),) * 3)
    ran = minkref("repair", written(tmp_path, solid))
    assert ran.code == 2 and "repaired as far as possible" in ran.err


def test_stl_cannot_hold_bodies_along_an_edge(minkref: Any, tmp_path: Path) -> None:
    index = list(solids.KINDS).index("bodies along an edge")
    file = written(tmp_path, solids.damaged(index)[1])
    ran = minkref("repair", file, "-o", tmp_path / "a.stl")
    assert ran.code == 2 and "as stl the operand would have faults again" in ran.err
    assert not (tmp_path / "a.stl").exists()
    assert minkref("repair", file, "-o", tmp_path / "a.json").code == 0


def test_several_solids_of_an_stl_file_are_one_polyhedron(minkref: Any, tmp_path: Path) -> None:
    for at in (0, 5):
        solid = solids.Solid([], [], [], [])
        solid.add((Fraction(at),) * 3, (Fraction(at + 1),) * 3)
        minkref("repair", written(tmp_path, solid), "-o", tmp_path / f"{at}.stl")
    both = tmp_path / "both.stl"
    both.write_text((tmp_path / "0.stl").read_text() + (tmp_path / "5.stl").read_text())
    ran = minkref("repair", both)
    assert ran.code == 0 and "2 solids are read as one polyhedron" in ran.err
    assert "volume   2" in ran.out


def test_a_refusal_names_the_repair_only_where_it_mends_the_file(
    minkref: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for index in range(len(solids.KINDS)):
        name, solid = solids.damaged(index)
        if solid.weld:
            continue
        Path("solid.json").write_text(solid.text())
        refused = minkref("sum", "solid.json", "gs3")
        assert refused.code == 2, name
        line = refused.err.split("`")[-2]
        assert line == "minkref repair solid.json -o FILE.json", name
        assert minkref(*line.split()[1:]).code == 0
        assert minkref("repair", "FILE.json").code == 0, name
