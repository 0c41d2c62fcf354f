"""`minkref point`: whether points are in a sum. With --proved: tests/proved."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import proved_program
from minkref.schemas import schema

Minkref = Callable[..., Any]
SQUARE = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"
SEGMENT = "LINESTRING (0 0, 1/3 0)"


def answers(minkref: Minkref, *words: str) -> list[dict[str, Any]]:
    ran = minkref("point", *words, "--json")
    assert (ran.code, ran.err) == (0, "")
    jsonschema.validate(ran.json, schema("point"))
    assert ran.json["proof"] is None
    rows: list[dict[str, Any]] = ran.json["points"]
    return rows


def test_points_of_two_squares_by_hand(minkref: Minkref) -> None:
    """2 P is the square of side 2, the sum that of side 3."""
    inside, corner, beyond = answers(
        minkref, SQUARE, SQUARE, "--scale", "2", "--at", "1,1/2", "--at", "3,3", "--at", "3,-1e-30"
    )
    assert (inside["in_sum"], inside["contact"]) == (True, "overlapping")
    assert corner == {
        "point": ["3", "3"], "in_sum": True, "contact": "touching", "p": ["1", "1"], "q": ["1", "1"]
    }  # fmt: skip
    assert (beyond["in_sum"], beyond["contact"]) == (False, "empty")
    assert (beyond["p"], beyond["q"]) == (None, None)


def test_a_factor_for_each_axis(minkref: Minkref) -> None:
    at = ("--at", "3,4/3", "--at", "3,1.34")
    rows = answers(minkref, SQUARE, SQUARE, "--scale", "2,1/3", *at)
    assert [row["in_sum"] for row in rows] == [True, False]
    assert rows[0]["p"] == ["1", "1"]


@pytest.mark.parametrize("first", [True, False])
def test_two_operands_without_area(minkref: Minkref, first: bool) -> None:
    """p is a point of P, and q one of Q, also where both lie on one line."""
    operands = ("LINESTRING (1 1, 2 3)", "POINT (0 0)")
    (row,) = answers(minkref, *(operands if first else operands[::-1]), "--at", "1,1")
    place = [["1", "1"], ["0", "0"]]
    assert [row["p"], row["q"]] == (place if first else place[::-1])


def test_points_of_a_file_and_of_standard_input(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "places.txt"
    file.write_text("3,1\n\n  1/2 , -0.5\n", encoding="utf-8")
    rows = answers(minkref, SQUARE, SQUARE, "--at", "2,2", "--points", str(file))
    assert [row["point"] for row in rows] == [["2", "2"], ["3", "1"], ["1/2", "-1/2"]]
    assert [row["in_sum"] for row in rows] == [True, False, False]
    ran = minkref("point", SQUARE, SQUARE, "--points", str(file))
    assert "0 of 2" in ran.out
    file.write_text("3,1\n3;1\n", encoding="utf-8")
    ran = minkref("point", SQUARE, SQUARE, "--points", str(file))
    assert ran.code == 2 and "places.txt, line 2:" in ran.err and "3;1" in ran.err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ((SQUARE, SQUARE), "no point is asked about"),
        ((SQUARE, SQUARE, "--points", "nowhere.txt"), "No such file"),
        (("-", SQUARE, "--points", "-"), "standard input can be read for one of these"),
        ((SQUARE, "MULTIPOINT (0 0, 1 1)", "--at", "1,1"), "several segments or points"),
        (("gs3", "rod", "--at", "1,1"), "in the plane only"),
    ],
)
def test_refusals(minkref: Minkref, words: tuple[str, ...], said: str) -> None:
    ran = minkref("point", *words)
    assert (ran.code, ran.out) == (2, "") and said in ran.err


def test_without_the_program(minkref: Minkref, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(proved_program, "PROGRAM", "minkref-no-such-program")
    ran = minkref("point", SQUARE, SQUARE, "--at", "1,1", "--proved")
    assert ran.code == 2 and "make proofs" in ran.err
    ran = minkref("sum", SQUARE, SQUARE, "--route", "proved")
    assert ran.code == 2 and "make proofs" in ran.err and "--route proved" in ran.err
