"""The slow engine's command line; as a separate process, as a reader of README.md would call it."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

import pytest
from minkref.oracle.slow.command import main

ORACLE = Path(__file__).resolve().parents[2] / "oracle"


def run(*arguments: object) -> tuple[object, str, str]:
    """In this process."""
    with redirect_stdout(io.StringIO()) as out, redirect_stderr(io.StringIO()) as err:
        try:
            code: object = main(list(map(str, arguments)))
        except SystemExit as ended:
            code = ended.code
    return code, out.getvalue(), err.getvalue()


def run_alone(
    *arguments: object, module: str = "slow", folder: Path = ORACLE
) -> tuple[int, str, str]:
    done = subprocess.run(
        [sys.executable, "-m", module, *map(str, arguments)],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=60,
    )
    return done.returncode, done.stdout, done.stderr


@pytest.fixture
def files(tmp_path: Path) -> tuple[Path, Path]:
    frame, unit = tmp_path / "frame.wkt", tmp_path / "unit.wkt"
    frame.write_text("POLYGON ((0 0,4 0,4 4,0 4,0 0),(1 1,1 2,2 2,2 1,1 1))")
    unit.write_text("POLYGON ((0 0,1 0,1 1,0 1,0 0))")
    return frame, unit


def test_sum_prints_a_document_whose_result_has_its_digest(files: tuple[Path, Path]) -> None:
    code, out, _ = run_alone("sum", *files, "--scale", "3/2", "--json")
    answer = json.loads(out)
    assert (code, answer["holes"], answer["scale"]) == (0, 1, "3/2")
    assert answer["tight_passages"] == []


def test_topology_tells_the_birth_of_the_hole(files: tuple[Path, Path]) -> None:
    code, out, _ = run("topology", *files, "--json")
    answer = json.loads(out)
    assert code == 0
    assert sorted(link["change"] for link in answer["holes"]) == ["birth", "same"]
    assert answer["topology_changes"] and answer["boundary_changes"]
    assert run("tight", *files)[1] == 'tight_passages: [{"points":[["2","2"]]}]\n'


def test_witness_names_two_points(files: tuple[Path, Path]) -> None:
    _, out, _ = run("witness", *files, "--at", "2,2", "--json")
    assert json.loads(out)["contact"] == "touching"


def test_compare_exits_with_one_and_a_witness_where_the_set_is_another(
    files: tuple[Path, Path], tmp_path: Path
) -> None:
    _, out, _ = run("sum", *files, "--json")
    claim = tmp_path / "claim.json"
    claim.write_text(json.dumps(json.loads(out)["result"]))
    assert run("compare", *files, "--with", claim)[0] == 0
    code, out, _ = run("compare", *files, "--with", files[0], "--json")
    assert code == 1
    assert json.loads(out)["witness"]["in_truth"] is True


@pytest.mark.parametrize(
    "arguments",
    [
        ("sum",),
        ("sum", "--scale", "0"),
        ("sum", "--scale", "x"),
        ("witness", "--at", "1"),
        ("none",),
    ],
)
def test_wrong_usage_exits_with_two(files: tuple[Path, Path], arguments: tuple[str, ...]) -> None:
    name, *options = arguments
    given = files[:1] if arguments == ("sum",) else files
    code, _, err = run(name, *given, *options)
    assert code == 2 and err and "Traceback" not in err


def test_crossing_rings_exit_with_two_and_say_so(tmp_path: Path, files: tuple[Path, Path]) -> None:
    bow = tmp_path / "bow.wkt"
    bow.write_text("POLYGON ((0 0,4 3,4 0,0 4,0 0))")
    code, _, err = run("sum", bow, files[1])
    assert code == 2 and "cross" in err


@pytest.mark.parametrize(
    "text",
    [
        "POLYGON ((0 0,4 0,4 4,0 4,0 0),(5 5,5 6,6 6,6 5,5 5))",
        "POLYGON ((0 0,4 0,4 4,0 4,0 0),(1 1,1 5,2 5,2 1,1 1))",
        "POLYGON ((0 0,6 0,6 6,4 6,1 -1,1 6,0 6,0 0))",
    ],
)
def test_holes_outside_and_rings_that_cross_are_noticed(
    tmp_path: Path, files: tuple[Path, Path], text: str
) -> None:
    bad = tmp_path / "bad.wkt"
    bad.write_text(text)
    code, _, err = run("sum", bad, files[1])
    assert code == 2 and err.startswith("slow: ") and "Traceback" not in err


def test_numbers_of_thousands_of_digits_are_printed_whole(
    tmp_path: Path, files: tuple[Path, Path]
) -> None:
    large = tmp_path / "large.wkt"
    large.write_text("POLYGON ((0 0, 1e4000 0, 0 1e4000, 0 0))")
    code, out, _ = run_alone("sum", large, files[1], "--json")
    assert code == 0 and len(json.loads(out)["area"]) >= 8000


def test_help_has_examples() -> None:
    code, out, _ = run("--help")
    assert code == 0 and "examples:" in out and "exit codes" in out


def test_package_works_below_another_name(tmp_path: Path, files: tuple[Path, Path]) -> None:
    """Links the package into a larger package: imports are relative."""
    (tmp_path / "larger").mkdir()
    os.symlink(ORACLE / "slow", tmp_path / "larger" / "slow")
    code, out, _ = run_alone("sum", *files, "--json", module="larger.slow", folder=tmp_path)
    assert code == 0 and json.loads(out)["components"] == 1
