"""Settings of a library in a file: minkref.toml, or the table [tool.minkref] of pyproject.toml."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from minkref.cli.cli import run
from minkref.cli.command_options import options_of
from minkref.cli.settings import KINDS
from minkref.verbs.verify import command

BASE = 'targets = ["minkref:paper"]\npairs = 2\nmodels = false\njobs = 1\n'


@pytest.fixture
def library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder whose subfolder is the current folder."""
    (tmp_path / "tests").mkdir()
    monkeypatch.chdir(tmp_path / "tests")
    return tmp_path


def verify(capsys: pytest.CaptureFixture[str], *words: str) -> Any:
    code = run(["verify", "--json", *words])
    value = json.loads(capsys.readouterr().out)
    assert value.get("exit_code", 2) == code
    return value


def names(value: Any) -> list[str]:
    return [target["name"] for target in value["targets"]]


@pytest.mark.parametrize(
    ("file", "head"), [("minkref.toml", ""), ("pyproject.toml", "[tool.minkref]\n")]
)
@pytest.mark.parametrize("place", [".", "tests"])
def test_a_file_here_or_above_is_read_and_named(
    library: Path, capsys: pytest.CaptureFixture[str], file: str, head: str, place: str
) -> None:
    (library / place / file).write_text(f"{head}{BASE}seed = 7\n")
    value = verify(capsys)
    assert names(value) == ["minkref:paper"]
    assert sum(group["cases"] for group in value["groups"]) == 2
    assert value["seed"] == 7
    named = file if place == "tests" else f"../{file}"
    assert value["notes"][0] == f"settings: {named}"


def test_options_win(library: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (library / "minkref.toml").write_text(f"{BASE}seed = 7\nderived = false\nlines = 'l'\n")
    value = verify(capsys, "minkref:winding", "--seed", "3", "--derived", "--lines", "mine")
    assert (names(value), value["seed"]) == (["minkref:winding"], 3)
    assert Path("mine").is_file() and not (library / "l").exists()


def test_a_time_on_the_command_line_wins_over_a_number_of_pairs(
    library: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (library / "minkref.toml").write_text(f"{BASE}seconds = 600\n")
    assert verify(capsys, "--seconds", "0")["groups"] == []


def test_the_nearest_file_with_settings_is_taken(
    library: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (library / "minkref.toml").write_text(f"{BASE}seed = 1\n")
    (library / "tests" / "pyproject.toml").write_text("[tool.other]\nx = 1\n")
    assert verify(capsys)["notes"][0] == "settings: ../minkref.toml"
    (library / "tests" / "pyproject.toml").write_text(f"[tool.minkref]\n{BASE}")
    assert verify(capsys)["notes"][0] == "settings: pyproject.toml"
    (library / "tests" / "minkref.toml").write_text(BASE)
    assert verify(capsys)["notes"][0] == "settings: minkref.toml"


def test_paths_lead_from_the_file(library: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (library / "known.json").write_text('{"baseline": "baseline-v1", "entries": []}')
    (library / "answer.py").write_text("raise SystemExit\n")
    text = f'{BASE}junit = "out.xml"\nbaseline = "known.json"\nreport = "./report"\n'
    (library / "minkref.toml").write_text(text)
    assert verify(capsys)["report"] == "../report/index.html"
    assert (library / "out.xml").is_file()
    again = (library / "report" / "index.html").read_text()
    assert "--no-settings" in again and "--junit ../out.xml" in again
    (library / "minkref.toml").write_text('targets = ["./answer.py"]\n')
    assert verify(capsys)["error"]["where"] == "../answer.py"  # it is found, and does not begin


@pytest.mark.parametrize("words", [("--no-settings",), ("--case", "random:1:1")])
def test_settings_are_left_out_where_asked_and_for_a_case(
    library: Path, capsys: pytest.CaptureFixture[str], words: tuple[str, ...]
) -> None:
    """The line that shows a finding again says the same everywhere."""
    (library / "minkref.toml").write_text("nonsense = 1\n")
    value = verify(capsys, "minkref:paper", "--pairs", "0", "--no-models", *words)
    assert not any(note.startswith("settings") for note in value.get("notes", []))
    assert "error" not in value


def test_another_file(library: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (library / "minkref.toml").write_text("nonsense = 1\n")
    (library / "night.toml").write_text(f"{BASE}seed = 9\n")
    for words in (("--case", "random:1:1"), ()):
        value = verify(capsys, "--settings", "../night.toml", *words)
        assert (value["seed"], value["notes"][0]) == (9, "settings: ../night.toml")


@pytest.mark.parametrize(
    ("text", "where", "said"),
    [
        ("pair = 3", "minkref.toml, pair", "did you mean pairs?"),
        ("call_seconds = 3", "minkref.toml, call_seconds", "did you mean call-seconds?"),
        ("case = ['comb:1:2']", "minkref.toml, case", "the settings are annotations"),
        ("schema = true", "minkref.toml, schema", "the settings are annotations"),
        ("pairs = '3'", "minkref.toml, pairs", '"3" is not an integer'),
        ("pairs = true", "minkref.toml, pairs", "true is not an integer"),
        ("derived = 1", "minkref.toml, derived", "1 is not true or false"),
        ("seconds = nan", "minkref.toml, seconds", "is not a number"),
        ("seconds = 2020-01-01", "minkref.toml, seconds", "is not a number"),
        ("targets = [['x']]", "minkref.toml, targets", "is not a text"),
        ("junit = 3", "minkref.toml, junit", "3 is not a text"),
        ("pairs = -3", "minkref.toml, pairs", "too small"),
        ("family = ['hole']", "minkref.toml, family hole", "did you mean holes?"),
        ("suite = 'corpse'", "minkref.toml, suite", "did you mean corpus?"),
        ("x y", "minkref.toml", "no TOML"),
        ("\udcff", "minkref.toml", "not UTF-8"),
        ("x = " + "[" * 100_000, "minkref.toml", "no TOML"),
        ("#" * 2_000_000, "minkref.toml", "longer than 1,048,576 bytes"),
    ],
)
def test_what_is_refused(
    library: Path, capsys: pytest.CaptureFixture[str], text: str, where: str, said: str
) -> None:
    (library / "minkref.toml").write_text(text, errors="surrogateescape")
    error = verify(capsys)["error"]
    assert error["where"] == f"../{where}"
    assert said in error["what"] + " " + error["mend"]


def test_an_option_that_is_wrong_is_not_said_of_the_file(
    library: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (library / "minkref.toml").write_text("pairs = 3\n")
    assert verify(capsys, "--pairs", "-3")["error"]["where"] == "--pairs"


def test_a_folder_that_is_gone_has_no_settings(
    library: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (library / "minkref.toml").write_text("nonsense = 1\n")
    (library / "tests").rmdir()
    assert "suite" in verify(capsys, "--suite", "none")["error"]["what"]


@pytest.mark.parametrize(
    ("text", "where"),
    [(None, "none.toml"), ("[tool.minkref]\npair = 3", "pyproject.toml, pair"), ("", "")],
)
def test_files_that_are_named(
    library: Path, capsys: pytest.CaptureFixture[str], text: str | None, where: str
) -> None:
    if text is not None:
        Path("pyproject.toml").write_text(text)
    file = "none.toml" if text is None else "pyproject.toml"
    error = verify(capsys, "--settings", file)["error"]
    assert error["where"] == (where or file)


def test_every_option_can_be_set() -> None:
    assert {option.kind for option in options_of(command) if not option.eager} <= set(KINDS)
