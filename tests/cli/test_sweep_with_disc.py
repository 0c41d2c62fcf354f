"""`minkref sweep P disc`: sums with discs of many radii, read off an index."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import _core
from minkref.exact import digest
from minkref.plane.operand import read_operand
from minkref.schemas import schema

Minkref = Callable[..., Any]

FRAME = "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 2 6, 6 6, 6 2, 2 2))"
TWO = "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((4 0, 6 0, 6 2, 4 2, 4 0)))"


def test_each_row_is_the_sum_at_its_radius(minkref: Minkref) -> None:
    ran = minkref("sweep", "g1", "disc", "--from", "1/10", "--to", "3", "--steps", "9", "--json")
    assert ran.code == 0
    jsonschema.validate(ran.json, schema("sweep"))
    assert len(ran.json["rows"]) == 9
    for row in ran.json["rows"]:
        one = minkref("sum", "g1", f"disc:{row['radius']}", "--json").json
        for name in ("digest", "components", "holes", "curves"):
            assert row[name] == one[name], (row["radius"], name)
        for name in ("area", "length"):
            told, right = row[name], one[name]
            assert told["low"] <= right["high"] and right["low"] <= told["high"]
            assert told["high"] - told["low"] <= 1e-10 * told["high"]


def test_at_the_radius_of_an_event_the_hole_is_gone(minkref: Minkref) -> None:
    ran = minkref("sweep", FRAME, "disc", "--from", "1", "--to", "3", "--steps", "3", "--json")
    told = [(row["radius"], row["holes"], row["at_event"]) for row in ran.json["rows"]]
    assert told == [("1", 1, False), ("2", 0, True), ("3", 0, False)]


def test_files_are_forms_and_pictures(minkref: Minkref, tmp_path: Path) -> None:
    radii = tmp_path / "radii.txt"
    radii.write_text("1/2\n1\n")
    folder = tmp_path / "sums"
    ran = minkref("sweep", TWO, "disc", "--scales", str(radii), "-o", str(folder), "--json")
    assert ran.code == 0
    forms = sorted(folder.glob("sum-*.json"))
    assert [row["digest"] for row in ran.json["rows"]] == [
        digest(file.read_text().strip()) for file in forms
    ]
    assert [row["components"] for row in ran.json["rows"]] == [2, 1]
    ran = minkref(
        "sweep", TWO, "disc", "--scales", str(radii), "-o", str(folder), "--format", "svg"
    )
    assert ran.code == 0
    assert len(list(folder.glob("sum-*.svg"))) == 2
    assert json.loads((folder / "index.json").read_text())["format"] == "svg"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("disc", "g1", "--from", "1", "--to", "2", "--steps", "2"), "minkref sweep P disc"),
        (("g1", "disc:2", "--from", "1", "--to", "2", "--steps", "2"), "minkref sweep P disc"),
        (("g1", "disc", "--from", "1"), "--steps"),
        (("g1", "disc", "--from", "1", "--steps", "1", "--route", "dynamic"), "--route"),
        (("g1", "disc", "--from", "1", "--steps", "1", "-o", "x", "--format", "wkt"), "json, svg"),
    ],
)
def test_refusals(minkref: Minkref, arguments: tuple[str, ...], said: str) -> None:
    ran = minkref("sweep", *arguments)
    assert ran.code == 2
    assert said in ran.err


def test_queries_are_on_the_boundary() -> None:
    P = read_operand("g1").set
    index = _core.disc_index(P)
    for radius in (0.125, 0.75, 2.5, 40.0):
        points, starts = index.vertices(radius)
        rings = [
            ring
            for component in _core.offset(P, str(Fraction(radius) ** 2)).drawn_rings()
            for ring in component
        ]
        pieces = [(piece[1], piece[2]) for ring in rings for piece in ring]
        assert len(starts) == len(rings)
        for x, y, error in points:
            assert 0 <= error < 1e-9
            assert min(abs(x - a) + abs(y - b) for a, b in pieces) <= 2 * error + 1e-12
