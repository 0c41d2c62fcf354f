"""Certificates of paths before check.py alone; limits, and files that are damaged."""

from __future__ import annotations

import json
import random
from pathlib import Path
from typing import Any

import pytest
import squares
import walls
from file_alone import alone, laid


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return laid(tmp_path, walls.CASE, walls.certificate())


def test_it_is_followed_in_an_empty_folder_beside_other_forms(folder: Path) -> None:
    plane = folder / "plane"
    plane.mkdir()
    laid(plane, squares.CASE, squares.certificate())
    ran = alone(folder, "it.cert.json", "plane/it.cert.json")
    assert (ran.returncode, ran.stderr, ran.stdout.count(": verified")) == (0, "", 2)


@pytest.mark.parametrize(
    ("options", "code", "why"),
    [
        (["--case", "nowhere.json"], 2, "cannot be read"),
        (["--case", "case.json"], 0, "verified"),
        (["--seconds", "0"], 4, "limit is reached"),
        (["--tests", "10"], 4, "limit is reached"),
        (["--tests", "400"], 4, "limit is reached"),
        (["--tests", "1000"], 0, "verified"),
        (["--bytes", "100"], 4, "bytes"),
    ],
)
def test_limits_and_missing_files(
    check: Any, folder: Path, options: list[str], code: int, why: str
) -> None:
    options = [str(folder / word) if word.endswith(".json") else word for word in options]
    got, said = check(folder / "it.cert.json", *options)
    assert got == code, said
    assert why in said


def test_damaged_files(check: Any, folder: Path) -> None:
    """Any byte may be another: the two agree, and verify nothing that is not the same JSON."""
    text = json.dumps(walls.certificate()).encode()
    file = folder / "it.cert.json"
    dice = random.Random(11)
    for at in dice.sample(range(len(text)), 60):
        spoilt = text[:at] + bytes([text[at] ^ (1 << dice.randrange(7))]) + text[at + 1 :]
        file.write_bytes(spoilt)
        code, said = check(file)
        assert code in (0, 1, 2), said
        if code == 0:
            assert json.loads(spoilt)["claims"] == walls.certificate()["claims"], said


@pytest.mark.parametrize(
    "spoil",
    [
        lambda c: c.pop("steps"),
        lambda c: c.pop("claims"),
        lambda c: c.__setitem__("steps", {}),
        lambda c: c.__setitem__("more", 1),
        lambda c: c["steps"].insert(0, None),
        lambda c: c["steps"].insert(0, {"rule": ["pieces"]}),
        lambda c: c["claims"].insert(0, {"claim": {}}),
        lambda c: c["claims"].insert(0, []),
        lambda c: c["claims"][0].__setitem__("scales", None),
        lambda c: c["claims"][0].__setitem__("contact", ["allowed"]),
        lambda c: c["claims"][1].__setitem__("hits", [[]]),
        lambda c: c["claims"][5].__setitem__("claims", [-1]),
        lambda c: c["claims"][5].__setitem__("claims", ["0"]),
    ],
)
def test_other_shapes_are_malformed(check_value: Any, spoil: Any) -> None:
    value = walls.certificate()
    spoil(value)
    assert check_value(value, walls.CASE)[0] == 2


@pytest.mark.parametrize(
    "case",
    [
        [],
        {},
        {**walls.CASE, "path": None},
        {**walls.CASE, "path": []},
        {**walls.CASE, "path": [["0"]]},
        {**walls.CASE, "path": [["0", "nan"]]},
        {**walls.CASE, "R": []},
        {name: walls.CASE[name] for name in ("R", "path")},
    ],
)
def test_what_is_no_case_is_malformed(check_value: Any, case: Any) -> None:
    assert check_value(walls.certificate(), case)[0] == 2


def test_a_code_without_end_is_out_of_budget(check_value: Any, check: Any, tmp_path: Path) -> None:
    """Halves of halves: numbers grow, and the limit of tests ends it."""
    value = walls.certificate()
    value["steps"][2]["codes"] = [[-3] * 3000 + [0] * 3001]
    assert check_value(value, walls.CASE)[0] == 0
    assert check(tmp_path / "it.cert.json", "--tests", "5000")[0] == 4


@pytest.mark.parametrize("size", [2000, 60_000])
def test_long_numbers_are_read(check_value: Any, size: int) -> None:
    value = walls.certificate()
    value["claims"][1]["hits"][0]["points"][1][2][1] = "0." + "3" * size
    assert check_value(value, walls.CASE)[0] == 0
    value["claims"][1]["hits"][0]["points"][1][2][1] = "1" * size
    assert check_value(value, walls.CASE)[0] == 1
