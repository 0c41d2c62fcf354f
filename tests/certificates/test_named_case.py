"""Each verdict names its case; no certificate leads out of its folder, or beyond the limits."""

from __future__ import annotations

import json
import random
import subprocess
import time
from pathlib import Path
from typing import Any

import pytest
import squares
import touching
from file_alone import laid
from minkref.reports.evidence.certificates.checkers import in_cpp, in_proved, in_python

VERIFIED, REFUTED, MALFORMED, OUT_OF_BUDGET, DECLINED = 0, 1, 2, 4, 5
SEED = 3
POINT = [0, 0]
TWICE = ["concurrent", [[POINT, POINT], [[0, None], [1, None]], [[1, None], [2, None]]]]
SAME_PLACE = ["concurrent", [[[0, 2], [2, 0]], [[0, None], [1, None]], [[1, None], [2, None]]]]


@pytest.fixture(params=["check.py", "minkref-check", "minkref-check-proved"])
def checker(request: Any) -> list[str]:
    try:
        found = {"check.py": in_python, "minkref-check": in_cpp}.get(request.param, in_proved)()
    except FileNotFoundError as error:
        pytest.skip(str(error))
    return found


def asked(checker: list[str], folder: Path, *words: str) -> tuple[int, str]:
    ran = subprocess.run([*checker, *words], cwd=folder, capture_output=True, text=True)
    assert ran.stderr == "", ran.stderr
    return ran.returncode, ran.stdout


def test_the_case_and_its_digest_are_named(checker: list[str], tmp_path: Path) -> None:
    value = squares.certificate()
    laid(tmp_path, squares.CASE, value)
    digest = value["case"]["sha256"]
    code, said = asked(checker, tmp_path, "it.cert.json")
    assert code == VERIFIED and said.splitlines()[1] == f"  case case.json, {digest}"
    (tmp_path / "mine.json").write_text(json.dumps(squares.CASE), encoding="utf-8")
    code, said = asked(checker, tmp_path, "--case", "mine.json", "it.cert.json")
    assert code == VERIFIED and said.splitlines()[1] == f"  case mine.json, {digest}"


@pytest.mark.parametrize(
    "path", ["../case.json", "/{0}/case.json", "a/../case.json", ".//case.json"]
)
def test_a_case_outside_the_folder_has_to_be_given(
    checker: list[str], tmp_path: Path, path: str
) -> None:
    value = squares.certificate()
    value["case"]["path"] = path.format(tmp_path)
    (tmp_path / "a").mkdir()
    laid(tmp_path, squares.CASE, value)
    laid(tmp_path / "a", squares.CASE, value)
    for file in ("it.cert.json", "a/it.cert.json"):
        code, said = asked(checker, tmp_path, file)
        assert code == MALFORMED and "is in another folder: give --case FILE" in said
        assert asked(checker, tmp_path, "--case", "case.json", file)[0] == VERIFIED


@pytest.mark.parametrize("of", [TWICE, SAME_PLACE])
def test_a_line_through_one_point_twice_has_no_sign(
    checker: list[str], tmp_path: Path, of: Any
) -> None:
    """The determinant is zero for any other lines. Vertices 2 of both squares are (1, 1)."""
    value = squares.certificate()
    value["claims"].append({"claim": "sign", "of": of, "from": "1", "to": "1", "sign": 0})
    laid(tmp_path, squares.CASE, value)
    code, said = asked(checker, tmp_path, "it.cert.json")
    assert code == MALFORMED and "one point given twice" in said
    value["claims"][-1] |= {"to": "2"}
    laid(tmp_path, squares.CASE, value)
    assert (asked(checker, tmp_path, "it.cert.json")[0] == MALFORMED) == (of is TWICE)


def test_nor_has_one_of_a_union(tmp_path: Path) -> None:
    value = touching.certificate()
    of = ["concurrent", [[POINT, POINT], [[0, 0], [0, 1]], [[0, 1], [0, 2]]]]
    value["claims"].append({"claim": "sign", "of": of, "sign": 0})
    laid(tmp_path, touching.CASE, value)
    for checker in (in_python(), in_cpp()):
        code, said = asked(checker, tmp_path, "it.cert.json")
        assert code == MALFORMED and "one point given twice" in said


def test_reading_obeys_the_limit_of_time(checker: list[str], tmp_path: Path) -> None:
    """And the files after it are checked all the same."""
    laid(tmp_path, squares.CASE, squares.certificate())
    (tmp_path / "long.cert.json").write_text(f"[{'1,' * 8_000_000}1]", encoding="utf-8")
    began = time.monotonic()
    code, said = asked(checker, tmp_path, "--seconds", "0.05", "long.cert.json", "it.cert.json")
    assert code == OUT_OF_BUDGET and "a limit is reached" in said.splitlines()[0]
    assert time.monotonic() - began < 20  # a machine may be busy
    assert "it.cert.json: " in said
    assert asked(checker, tmp_path, "--seconds", "1e18", "it.cert.json")[0] == VERIFIED


def test_coordinates_over_one_denominator_obey_a_limit_of_room(tmp_path: Path) -> None:
    """A file of half a megabyte, whose coordinates would take 270 MB."""
    dice = random.Random(SEED)

    def number() -> str:
        return f"1/{2 * dice.randrange(10**25, 10**26) + 1}"

    case = {
        **squares.CASE,
        "P": {"polygons": [{"outer": [[number(), number()] for _ in range(4200)]}]},
    }
    value = squares.certificate()
    value["case"]["sha256"] = squares.digest_of_case(case)
    laid(tmp_path, case, value)
    for checker in (in_python(), in_cpp()):
        code, said = asked(checker, tmp_path, "it.cert.json")
        assert code == OUT_OF_BUDGET and "a denominator is too large" in said, (SEED, said)


def test_rings_that_cancel_are_declined(tmp_path: Path) -> None:
    """A ring less itself is the empty set, and so is its sum: no theorem is about it, and the
    others verify it."""
    outer = squares.SQUARE["polygons"][0]["outer"]
    case = {**squares.CASE, "P": {"polygons": [{"outer": outer, "holes": [outer[::-1]]}]}}
    value = squares.certificate()
    value["case"]["sha256"] = squares.digest_of_case(case)
    corners = [["meet", 0, 1], ["meet", 2, 1], ["meet", 2, 3], ["meet", 0, 3]]
    value["steps"] = [
        {"rule": "pieces", "of": "P", "pieces": [], "groups": []},
        {"rule": "pieces", "of": "Q", "pieces": [[0, 1, 2, 3]], "groups": []},
        {"rule": "eq", "scales": ["1"], "by": [0, 1], "box": ["0", "0", "1", "1"],
         "elements": corners, "cells": [[4, 5, 6, 7]], "normals": [], "proofs": [["sep"]],
         "contacts": [], "polygons": []},
    ]  # fmt: skip
    value["claims"] = [
        {"claim": "sum", "scale": "1", "step": 2, "components": 0, "holes": 0,
         "digest": squares.digest_of_polygons([])}
    ]  # fmt: skip
    laid(tmp_path, case, value)
    for checker in (in_python(), in_cpp()):
        assert asked(checker, tmp_path, "it.cert.json")[0] == VERIFIED
    try:
        code, said = asked(in_proved(), tmp_path, "it.cert.json")
    except FileNotFoundError as error:
        pytest.skip(str(error))
    assert code == DECLINED and "rings that cancel" in said
