"""Operands and outputs with unusual names: not UTF-8, control characters, links, pipes."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.schemas import schema

Minkref = Callable[..., Any]
NOT_UTF8 = os.fsdecode(b"\xff.wkt")
SQUARE = "POLYGON((0 0,1 0,1 1,0 1,0 0))"


def test_file_whose_name_is_not_utf8_is_read(minkref: Minkref, tmp_path: Path) -> None:
    (tmp_path / NOT_UTF8).write_text(SQUARE, encoding="utf-8")
    ran = minkref("sum", tmp_path / NOT_UTF8, tmp_path / NOT_UTF8, "--json")
    assert (ran.code, ran.json["area"]) == (0, "4")


def test_bad_files_in_the_folder_of_models_are_listed_as_unreadable(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / NOT_UTF8).write_text(SQUARE, encoding="utf-8")
    (tmp_path / "cut.wkt").write_text("POLYGON((0 0", encoding="utf-8")
    monkeypatch.setenv("MINKREF_MODELS", str(tmp_path))
    ran = minkref("models", "--json")
    assert ran.code == 0
    assert [row["name"] for row in ran.json["unreadable"]] == ["cut"]
    assert minkref("models").code == 0


def test_control_characters_of_a_name_do_not_reach_the_terminal(minkref: Minkref) -> None:
    ran = minkref("sum", "a\n\x1b[31m.wkt", "g1")
    assert "a\\n\\x1b[31m.wkt" in ran.err
    assert "\x1b" not in ran.err


def test_output_through_a_link_leaves_the_link(minkref: Minkref, tmp_path: Path) -> None:
    link = tmp_path / "link.wkt"
    link.symlink_to("real.wkt")
    assert minkref("sum", "g1", "g3", "-o", link).code == 0
    assert link.is_symlink()
    assert (tmp_path / "real.wkt").is_file()


def test_special_files_and_empty_names_are_called_so(minkref: Minkref) -> None:
    assert "not a regular file" in minkref("sum", "/dev/null", "g1").err
    assert "empty" in minkref("sum", "", "g1").err


def test_operand_of_a_case_is_named_with_its_letter(minkref: Minkref, tmp_path: Path) -> None:
    square = '{"polygons": [{"outer": [["0","0"],["%s","0"],["%s","1"],["0","1"]]}]}'
    (tmp_path / "case.json").write_text(
        '{"schema": "case-v1", "id": "a", "title": "a", "dimension": 2, "scales": ["1"],'
        f'"P": {square % (1, 1)}, "Q": {square % (2, 2)}}}',
        encoding="utf-8",
    )
    path = tmp_path / "case.json"
    assert minkref("sum", f"{path}#P", f"{path}#Q", "--json").json["area"] == "6"


def test_area_beyond_doubles_is_null_and_shown_by_its_power_of_ten(minkref: Minkref) -> None:
    huge = ("sum", "g1", "g3", "--scale", "1e1000")
    assert minkref(*huge, "--json").json["area_approximate"] is None
    assert re.search(r"area +about \d\.\d+e200\d \(", minkref(*huge).out)


def test_undecided_double_says_why_and_is_not_unequal(minkref: Minkref) -> None:
    huge = ("sum", "g1", "g3", "--scale", "1e400", "--arithmetic", "double")
    assert minkref(*huge, "--json").json["exact"]["equal"] is None
    ran = minkref(*huge)
    assert "arithmetic double" in ran.out
    assert "another set" not in ran.out


def test_signs_name_the_arithmetic_that_decided_them(minkref: Minkref) -> None:
    assert "all by mpfr:53" in minkref("sum", "g1", "g3", "--arithmetic", "mpfr:53").out


def test_schema_covers_the_refusal(minkref: Minkref) -> None:
    import jsonschema

    jsonschema.validate(minkref("sum", "absent.wkt", "g1", "--json").json, schema("sum"))


def test_package_offers_sums_that_validate_their_operands() -> None:
    import minkref as package

    square = package.read_text(SQUARE, "wkt")
    result = package.minkowski_sum(square, square, "1/2")
    assert result.region.area() == "9/4"
    assert package.difference(result.region, square) is not None
    assert package.decide(square, square, 1, "3", "3")["contact"] == "empty"
    with pytest.raises(package.BadInput, match="cross"):
        package.minkowski_sum(package.read_text("POLYGON((0 0,2 2,2 0,0 2,0 0))", "wkt"), square)
