"""`minkref check` of folders, which says what it passes over, and of standard input."""

from __future__ import annotations

import io
import json
import os
import sys
from pathlib import Path
from typing import Any

import pytest
import squares
from file_alone import laid
from minkref.cli.cli import run


@pytest.fixture
def rows(capsys: Any) -> Any:
    """Exit code, and a row for each file."""

    def call(*words: str) -> tuple[int, dict[str, Any]]:
        code = run(["check", "--json", *words])
        files = json.loads(capsys.readouterr().out)["files"]
        return code, {Path(row["file"]).name: row for row in files}

    return call


def test_what_a_folder_passes_over_is_said(tmp_path: Path, rows: Any) -> None:
    elsewhere, folder = tmp_path / "elsewhere", tmp_path / "folder"
    for place in (elsewhere, folder, folder / "inner"):
        place.mkdir()
        laid(place, squares.CASE, squares.certificate())
    assert rows(str(folder))[0] == 0
    (folder / "linked").symlink_to(elsewhere)
    (folder / "link.cert.json").symlink_to(elsewhere / "it.cert.json")
    (folder / "UP.CERT.JSON").write_text("{}", encoding="utf-8")
    os.mkfifo(folder / "fifo.cert.json")
    code, found = rows(str(folder))
    assert code == 2
    why = {name: row["message"] for name, row in found.items() if row["verdict"] == "malformed"}
    assert set(why) == {"linked", "link.cert.json", "UP.CERT.JSON", "fifo.cert.json"}
    assert all(told.startswith("passed over: ") for told in why.values())
    assert found["it.cert.json"]["verdict"] == "verified"
    assert rows(str(folder / "link.cert.json"))[0] == 0


def test_an_unreadable_folder_is_said(tmp_path: Path, rows: Any, monkeypatch: Any) -> None:
    laid(tmp_path, squares.CASE, squares.certificate())
    (tmp_path / "shut").mkdir()
    listed = os.scandir

    def scandir(path: Any) -> Any:
        if Path(path).name == "shut":
            raise PermissionError(13, "Permission denied")
        return listed(path)

    monkeypatch.setattr(os, "scandir", scandir)
    code, found = rows(str(tmp_path))
    assert (code, "cannot be read" in found["shut"]["message"]) == (2, True)


def test_standard_input_and_the_case(tmp_path: Path, rows: Any, monkeypatch: Any) -> None:
    """The case's path is then taken from the working folder."""
    value = squares.certificate()
    laid(tmp_path, squares.CASE, value)
    monkeypatch.chdir(tmp_path)

    def given() -> None:
        text = io.TextIOWrapper(io.BytesIO(json.dumps(value).encode()))
        monkeypatch.setattr(sys, "stdin", text)

    given()
    code, found = rows("-")
    assert code == 0
    assert found["-"]["case"] == {"path": "case.json", "sha256": value["case"]["sha256"]}
    (tmp_path / "mine.json").write_text(json.dumps(squares.CASE), encoding="utf-8")
    given()
    assert rows("-", "--case", "mine.json")[1]["-"]["case"]["path"] == "mine.json"
    assert rows("it.cert.json", "--case", "nothing.json")[1]["it.cert.json"]["case"] is None
