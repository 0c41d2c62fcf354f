"""check.py needs nothing but itself; limits and missing files are told apart."""

from __future__ import annotations

import ast
import io
import json
import tokenize
from pathlib import Path
from typing import Any

import cubes
import pytest
import squares
from file_alone import alone, laid
from minkref.reports.evidence.certificates.checkers import CHECKER


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return laid(tmp_path, squares.CASE, squares.certificate())


@pytest.mark.parametrize("given", [squares, cubes], ids=["squares", "cubes"])
def test_it_runs_in_an_empty_folder(tmp_path: Path, given: Any) -> None:
    ran = alone(laid(tmp_path, given.CASE, given.certificate()), "it.cert.json")
    assert (ran.returncode, ran.stderr) == (0, "")
    assert "verified" in ran.stdout and given.CLAIM["digest"] in ran.stdout


@pytest.mark.parametrize(
    ("options", "code", "why"),
    [
        (["--case", "nowhere.json"], 2, "cannot be read"),
        (["--case", "case.json"], 0, "verified"),
        (["--seconds", "0"], 4, "a limit is reached"),
        (["--tests", "10"], 4, "a limit is reached"),
        (["--bytes", "100"], 4, "over 100 bytes"),
        (["nowhere.cert.json"], 2, "cannot be read"),
    ],
)
def test_limits_and_missing_files(
    check: Any, folder: Path, options: list[str], code: int, why: str
) -> None:
    options = [str(folder / word) if word.endswith(".json") else word for word in options]
    got, said = check(folder / "it.cert.json", *options)
    assert got == code, said
    assert why in said


@pytest.mark.parametrize(
    "text",
    [
        "",
        "{",
        "[]",
        "7",
        '{"certificate": 1}',
        '{"a": 1, "a": 2}',
        "[" * 100_000,
        '"\ud800"',
        "NaN",
    ],
)
def test_what_is_no_certificate_is_malformed(folder: Path, check: Any, text: str) -> None:
    (folder / "it.cert.json").write_bytes(text.encode("utf-8", "surrogatepass"))
    assert check(folder / "it.cert.json")[0] == 2


def test_the_worst_of_several_counts(folder: Path) -> None:
    spoilt = squares.certificate()
    spoilt["claims"][0]["holes"] = 3
    (folder / "no.cert.json").write_text(json.dumps(spoilt), encoding="utf-8")
    assert alone(folder, "nowhere", "no.cert.json", "it.cert.json").returncode == 1
    assert alone(folder, "nowhere", "it.cert.json").returncode == 2


def test_it_is_short_enough_to_be_read() -> None:
    """Fewer than 1700 lines of code for all forms without parts that add further claims, each with
    its own limit; blank lines, comments and docstrings apart."""
    parts = CHECKER.parent / "parts"
    most = {
        "03b_complete_lists.py": 80,
        "05b_solid_points.py": 45,
        "05c_shells.py": 170,
        "08b_disc_sums.py": 325,
    }
    rest = CHECKER.read_text(encoding="utf-8")
    for name, lines in most.items():
        part = (parts / name).read_text(encoding="utf-8")
        assert _code_lines(part) < lines
        rest = rest.replace(part, "")
    assert _code_lines(rest) < 1700


def _code_lines(text: str) -> int:
    passed = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT}
    passed |= {tokenize.ENDMARKER}
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    lines = {token.start[0] for token in tokens if token.type not in passed}
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and ast.get_docstring(
            node
        ):
            first = node.body[0]
            lines -= set(range(first.lineno, (first.end_lineno or first.lineno) + 1))
    return len(lines)
