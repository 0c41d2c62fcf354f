"""Every misuse: exit code 2, the fault, its place and its remedy; nothing written."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
import typer
from minkref.cli.command_group import COMMANDS, load
from minkref.errors import Refusal
from minkref.schemas import error_schema

Minkref = Callable[..., Any]

MISUSES = [
    (["sum", "g1", "g2", "--scale", "0"], "scale is zero"),
    (["sum", "g1", "g2", "--scale", "0/7"], "scale is zero"),
    (["sum", "g1", "g2", "--scale", "-1"], "scale is negative"),
    (["sum", "g1", "g2", "--scale", "nan"], "not a finite number"),
    (["sum", "g1", "g2", "--scale", "-inf"], "not a finite number"),
    (["sum", "g1", "g2", "--scale", "1/0"], "denominator is zero"),
    (["sum", "g1", "g2", "--scale", "two"], "not a number"),
    (["sum", "g1", "g2", "--scale", ""], "not a number"),
    (["sum", "g1", "g2", "--scale", "1_0"], "not a number"),
    (["sum", "g1", "g2", "--scale", "\u0663"], "not a number"),
    (["sum", "g1", "g2", "--scale", "1,2,3"], "or two: SX,SY"),
    (["sum", "g1", "g2", "--scale", "1e1000000000"], "exponent"),
    (["sum", "g1", "g2", "--scale", "1" * 1_000_000], "characters"),
    (["sum", "g1", "g2", "--route", "shortest"], "no route"),
    (["sum", "g1", "g2", "--arithmetic", "decimal"], "no arithmetic"),
    (["sum", "g1", "g2", "--arithmetic", "mpfr:0"], "bits"),
    (["sum", "g1", "g2", "--arithmetic", "mpfr:"], "no arithmetic"),
    (["sum", "g1", "g2", "--arithmetic", "mpfr:1000000000"], "out of range"),
    (["sum", "g1", "g2", "--arithmetic", "double", "--route", "winding"], "exact only"),
    (["sum", "g1", "g2", "-o", "sum.stl"], "no format"),
    (["sum", "g1", "g2", "-o", "no/such/folder/sum.wkt"], "does not exist"),
    (["sum", "g1"], "Missing argument"),
    (["sum", "g1", "g2", "g3"], "unexpected extra argument"),
    (["sum", "g1", "g11"], "did you mean g1"),
    (["sum", "absent.wkt", "g1"], "no such file"),
    (["sum", "g1", "g2", "--shape", "round"], "No such option"),
    (["add", "g1", "g2"], "No such command"),
    (["sum", "x" * 300, "g1"], "no file has a name of 300 characters"),
    (["sum", "g1", "g2", "-o", "x" * 300 + ".json"], "no file has a name"),
    (["check", "x" * 300], "no file has a name"),
    (["verify", "--case", "x" * 300 + ".json"], "no file has a name"),
    (["verify", "./" + "x" * 300], "no file has a name"),
    (["verify", "cgal-magic"], "no such target"),
    (["verify", "py:no_such_module:f"], "cannot be loaded"),
    (["verify", "py:math"], "not the name of a Python function"),
    (["verify", "--pairs", "-1"], "too small"),
    (["verify", "--pairs", "many"], "--pairs"),
    (["verify", "--seed", "7" * 4_000], "a number of 4,000 digits is too large"),
    (["verify", "--seed", "7" * 100_000], "exceeded maximum size"),
    (["verify", "--size-limit", "-1"], "too small"),
    (["verify", "--jobs", "0"], "too small"),
    (["verify", "--call-memory", "99999999999999"], "too large"),
    (["verify", "--case", "random:\u0663:1"], "no generated case has this name"),
    (["verify", "--report", "/dev/null"], "not a folder"),
    (["sum", "g1", "g2", "-o", "/proc/sum.wkt"], "no file can be made"),
    (["verify", "--seconds", "nan"], "too small"),
    (["verify", "--call-seconds", "0"], "out of range"),
    (["verify", "--case", "random:1"], "no generated case has this name"),
    (["verify", "--case", "g1+g11"], "not the name of a pair"),
    (["verify", "--case", "g1+g2@0"], "scale is zero"),
    (["verify", "--baseline", "absent.json"], "cannot be read"),
    (["verify", "--junit", "no/such/folder/junit.xml"], "does not exist"),
    (["verify", "minkref:paper", "--pairs", "0", "--no-models"], "nothing was run"),
]


@pytest.mark.parametrize(("arguments", "message"), MISUSES, ids=lambda v: str(v)[-40:])
def test_misuse_exits_2_and_says_what_where_and_how_to_mend(
    minkref: Minkref,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: list[str],
    message: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("MINKREF_MODELS", raising=False)
    ran = minkref(*arguments)
    assert ran.code == 2
    assert message.lower() in ran.err.lower()
    assert "fix: " in ran.err
    assert len(ran.err) < 1000
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("arguments", [MISUSES[0][0], MISUSES[20][0], MISUSES[26][0]])
def test_refusal_with_json_is_one_document_too(minkref: Minkref, arguments: list[str]) -> None:
    ran = minkref(*arguments, "--json")
    assert ran.code == 2
    jsonschema.validate(ran.json, error_schema())
    assert ran.json["command"] == arguments[0]


BAD_FILES = [
    ("bow.wkt", "POLYGON((0 0,2 2,2 0,0 2,0 0))", "self-intersection"),
    ("flat.wkt", "POLYGON((0 0,2 2,4 4,0 0))", None),
    ("hole.wkt", "POLYGON((0 0,4 0,4 4,0 4,0 0),(8 8,9 8,9 9,8 8))", "hole-outside"),
    ("short.wkt", "POLYGON((0 0,4 0", None),
    ("empty.wkt", "", None),
    ("nan.wkt", "POLYGON((0 0,nan 0,4 4,0 0))", None),
    ("cut.json", '{"polygons":[{"outer":[["0"', None),
]


@pytest.mark.parametrize(("name", "text", "code"), BAD_FILES, ids=lambda v: str(v)[:20])
def test_bad_file_is_refused_by_name_and_leaves_the_output_alone(
    minkref: Minkref, tmp_path: Path, name: str, text: str, code: str | None
) -> None:
    path, output = tmp_path / name, tmp_path / "out.wkt"
    path.write_text(text, encoding="utf-8")
    output.write_text("as before", encoding="utf-8")
    ran = minkref("sum", path, "g1", "-o", output, "--json")
    assert ran.code == 2
    assert name in ran.json["error"]["where"]
    assert ran.json["error"]["mend"]
    if code is not None:
        assert ran.json["error"]["code"] == code
    assert output.read_text(encoding="utf-8") == "as before"
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted([name, "out.wkt"])


def test_self_intersection_names_ring_vertices_and_coordinates(
    minkref: Minkref, tmp_path: Path
) -> None:
    path = tmp_path / "bow.wkt"
    path.write_text(BAD_FILES[0][1], encoding="utf-8")
    where = minkref("sum", path, "g1", "--json").json["error"]["where"]
    assert "ring 0" in where
    assert "vertices" in where
    assert "(2, 2)" in where


def test_folder_is_refused_as_operand_and_as_output(minkref: Minkref, tmp_path: Path) -> None:
    assert "folder" in minkref("sum", tmp_path, "g1").err
    named = tmp_path / "sum.wkt"
    named.mkdir()
    ran = minkref("sum", "g1", "g2", "-o", named)
    assert ran.code == 2
    assert "folder" in ran.err


def _with_those_below(command: Any) -> list[Any]:
    below = getattr(command, "commands", {}).values()
    return [command, *(one for each in below for one in _with_those_below(each))]


@pytest.mark.parametrize("name", COMMANDS)
def test_an_option_of_one_value_is_given_once(name: str) -> None:
    """A second value would be taken, and the first one dropped in silence."""
    found = 0
    for command in _with_those_below(load(name)):
        for option in command.params:
            if option.param_type_name != "option" or option.is_flag or option.multiple:
                continue
            words = [option.opts[-1], *["1"] * option.nargs]
            with pytest.raises(Refusal, match="given twice"):
                command.parse_args(typer.Context(command), [*words, *words])
            found += 1
    assert found or name in ("families", "models", "targets")


@pytest.mark.parametrize(
    "words",
    [
        ["sum", "g1", "g2", "--scale=2", "--scale", "3"],
        ["report", "audit", "--seed", "1", "--seed", "1"],
        ["verify", "minkref:paper", "--pairs", "1", "--pairs", "2"],
    ],
)
def test_an_option_given_twice_is_named(minkref: Minkref, words: list[str]) -> None:
    ran = minkref(*words)
    assert ran.code == 2 and "given twice" in ran.err and "give it once" in ran.err
    assert next(word.partition("=")[0] for word in words if word.startswith("--")) in ran.err


@pytest.mark.parametrize(
    "text",
    [
        "not json",
        "[]",
        '{"baseline": "baseline-v9", "entries": []}',
        '{"baseline": "baseline-v1"}',
        '{"baseline": "baseline-v1", "entries": [{"target": "cgal-full"}]}',
        '{"baseline": "baseline-v1", "entries": [{"target": "*", "version": "*",'
        ' "kind": "typo", "reason": "r"}]}',
        "[" * 100_000,
    ],
)
def test_bad_baseline_is_refused(minkref: Minkref, tmp_path: Path, text: str) -> None:
    path = tmp_path / "baseline.json"
    path.write_text(text, encoding="utf-8")
    ran = minkref("verify", "minkref:paper", "--pairs", "1", "--baseline", path)
    assert ran.code == 2
    assert "baseline" in ran.err


def test_folder_of_executables_that_does_not_exist_is_refused(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for folder in (tmp_path, tmp_path / "absent"):
        monkeypatch.setenv("MINKREF_CGAL", str(folder))
        ran = minkref("targets")
        assert ran.code == 2
        assert "MINKREF_CGAL" in ran.err


@pytest.mark.parametrize("isolation", ["none", "auto"])
def test_a_current_folder_that_is_gone_is_no_fault_of_ours(tmp_path: Path, isolation: str) -> None:
    gone = tmp_path / "gone"
    gone.mkdir()
    words = ["verify", "minkref:winding", "--pairs", "2", "--no-models", "--isolation", isolation]
    script = (
        f"import os, sys; os.chdir({str(gone)!r}); os.rmdir({str(gone)!r})\n"
        f"from minkref.cli.cli import run; sys.exit(run({words!r}))"
    )
    ran = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=False
    )
    assert ran.returncode == 2, ran.stderr
    assert "the current folder has been removed" in ran.stderr and "fix: " in ran.stderr
