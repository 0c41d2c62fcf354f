"""Certificates of convex bodies before check.py alone; limits, and files of another form."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import cubes
import pytest
import squares
from file_alone import alone, laid


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return laid(tmp_path, cubes.CASE, cubes.certificate())


def test_both_forms_are_followed_beside_each_other(folder: Path) -> None:
    plane = folder / "plane"
    plane.mkdir()
    laid(plane, squares.CASE, squares.certificate())
    ran = alone(folder, "it.cert.json", "plane/it.cert.json")
    assert (ran.returncode, ran.stderr, ran.stdout.count(": verified")) == (0, "", 2)


@pytest.mark.parametrize("form", ["certificate-v2", None, [], {}, 1])
def test_another_form_is_malformed(check: Any, folder: Path, form: Any) -> None:
    value = {**cubes.certificate(), "certificate": form}
    (folder / "it.cert.json").write_text(json.dumps(value), encoding="utf-8")
    code, said = check(folder / "it.cert.json")
    assert (
        code == 2
        and "this is no certificate-v1 or axes-certificate-v1 or convex-certificate-v1" in said
    )


@pytest.mark.parametrize(
    ("options", "code", "why"),
    [
        (["--case", "nowhere.json"], 2, "cannot be read"),
        (["--case", "case.json"], 0, "verified"),
        (["--seconds", "0"], 4, "limit is reached"),
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


def test_both_count_the_same_tests(check: Any, folder: Path) -> None:
    """One for each vertex, each vertex compared with a plane, 64 for a claim; and no fewer do."""
    needed = 16 + 2 * 6 * 8 + 24 + 6 * 16 + 64
    assert check(folder / "it.cert.json", "--tests", str(needed))[0] == 0
    for tests in (0, 15, 16, 100, 130, 200, needed - 1):
        assert check(folder / "it.cert.json", "--tests", str(tests))[0] == 4, tests


@pytest.mark.parametrize(
    "text", ["", "[]", "7", "null", '{"certificate": ["convex-certificate-v1"]}', '"\\ud800"']
)
def test_what_is_no_certificate_is_malformed(check: Any, folder: Path, text: str) -> None:
    (folder / "it.cert.json").write_text(text, encoding="utf-8")
    assert check(folder / "it.cert.json")[0] == 2


@pytest.mark.parametrize("member", ["certificate", "sums", "claims", "case", "title"])
def test_a_member_twice_is_malformed(check: Any, folder: Path, member: str) -> None:
    value = cubes.certificate() | {"title": "a test"}
    text = json.dumps(value)[:-1] + f', "{member}": {json.dumps(value[member])}}}'
    (folder / "it.cert.json").write_text(text, encoding="utf-8")
    assert check(folder / "it.cert.json")[0] == 2
