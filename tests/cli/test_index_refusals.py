"""Indices for other operands or scales are refused, and so are builds that cannot succeed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from index_runs import THIN, TRIANGLE, Minkref, U, ask, refused, written
from minkref import _core
from minkref.plane.operand import read_operand

COMMANDS = {
    "sum": ["sum", "g1", "g2"],
    "sweep": ["sweep", "g1", "g2", "--from", "1", "--to", "2", "--steps", "2"],
    "events": ["events", "g1", "g2", "--kind", "topology"],
    "view": ["view", "g1", "g2", "-o", "page.html"],
}
EACH = pytest.mark.parametrize("command", COMMANDS)


@pytest.fixture
def at(letters: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working folder with an index."""
    monkeypatch.chdir(letters.parent)
    return letters.parent


@EACH
def test_an_index_of_other_operands_is_refused(minkref: Minkref, at: Path, command: str) -> None:
    name, _, _, *options = COMMANDS[command]
    for operands in (("g2", "g1"), ("g1", "g3"), ("g3", "g2"), ("g1", "g1")):
        text, error = refused(minkref, at, name, *operands, *options, "--index", "letters.index")
        assert "letters.index" in text
        assert " and ".join(operands) in text
        assert error["code"] == "other-operands"


@pytest.mark.parametrize(
    "arguments",
    [
        ["sum", "g1", "g2", "--scale", "5"],
        ["sum", "g1", "g2", "--scale", "1/5"],
        ["sum", "g1", "g2", "--scale", "4.0000000000000000000001"],
        ["sweep", "g1", "g2", "--from", "1/5", "--to", "1", "--steps", "2"],
        ["sweep", "g1", "g2", "--from", "5", "--to", "1", "--steps", "2", "-o", "sums"],
        ["events", "g1", "g2", "--kind", "boundary", "--from", "1/5"],
        ["events", "g1", "g2", "--kind", "topology", "--to", "5", "-o", "events.json"],
        ["view", "g1", "g2", "--from", "1/5"],
        ["view", "g1", "g2", "--to", "5"],
    ],
    ids=" ".join,
)
def test_a_scale_outside_the_window_is_refused(
    minkref: Minkref, at: Path, arguments: list[str]
) -> None:
    text, error = refused(minkref, at, *arguments, "--index", "letters.index")
    assert "letters.index" in text
    assert "1/4 to 4" in text
    assert error["code"] == "outside-window"
    assert [path.name for path in at.iterdir()] == ["letters.index"]


@EACH
def test_a_file_that_is_cut_off_is_refused(minkref: Minkref, at: Path, command: str) -> None:
    whole = (at / "letters.index").read_bytes()
    for size in (0, 1, 8, 100, len(whole) // 2, len(whole) - 1):
        (at / "cut.index").write_bytes(whole[:size])
        text, _ = refused(minkref, at, *COMMANDS[command], "--index", "cut.index")
        assert "cut.index" in text


def test_a_file_with_a_changed_byte_is_refused(minkref: Minkref, at: Path) -> None:
    whole = (at / "letters.index").read_bytes()
    for place in range(0, len(whole), len(whole) // 25):
        changed = bytearray(whole)
        changed[place] ^= 1 << place % 8
        (at / "changed.index").write_bytes(changed)
        text, _ = refused(minkref, at, *COMMANDS["sum"], "--index", "changed.index")
        assert "changed.index" in text, place
    (at / "changed.index").write_bytes(whole + b"\0")
    refused(minkref, at, *COMMANDS["sum"], "--index", "changed.index")


@EACH
@pytest.mark.parametrize(
    ("name", "code"),
    [
        ("empty", "not-an-index"),
        ("foreign", "not-an-index"),
        ("g1.json", "not-an-index"),
        (".", "no-file"),
        ("absent", "no-file"),
    ],
)
def test_what_is_no_index_is_refused(
    minkref: Minkref, at: Path, command: str, name: str, code: str
) -> None:
    (at / "empty").touch()
    (at / "foreign").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 20)
    (at / "g1.json").write_text(read_operand("g1").set.to_json(), encoding="utf-8")
    text, error = refused(minkref, at, *COMMANDS[command], "--index", name)
    assert text.startswith(f"minkref: {name}: ")
    assert error["code"] == code
    assert error["where"] == name


@EACH
def test_a_route_that_does_not_use_the_index_is_refused(
    minkref: Minkref, at: Path, command: str
) -> None:
    text, _ = refused(
        minkref, at, *COMMANDS[command], "--index", "letters.index", "--route", "dynamic"
    )
    assert "--index letters.index" in text
    assert "--route dynamic" in text
    ask(minkref, *COMMANDS[command], "--index", "letters.index", "--route", "index")


@pytest.mark.parametrize("kind", ["pair", "parallel", "triple", "arrangement"])
@pytest.mark.parametrize("option", [["--index", "letters.index"], ["--route", "index"]])
def test_events_of_the_arrangement_have_no_index(
    minkref: Minkref, at: Path, kind: str, option: list[str]
) -> None:
    text, _ = refused(minkref, at, "events", "g1", "g2", "--kind", kind, *option)
    assert option[0] in text
    assert f"{kind} events" in text


def test_other_arithmetics_have_no_index(minkref: Minkref, at: Path) -> None:
    options = ["--index", "letters.index", "--arithmetic", "double"]
    text, _ = refused(minkref, at, *COMMANDS["sum"], *options)
    assert "exact only" in text


@pytest.mark.parametrize(
    "arguments",
    [
        ["index", "gs3", "rod", "-o", "sums.index"],
        ["sum", "gs3", "rod", "--index", "letters.index"],
        ["sweep", "gs3", "rod", "--scales", "scales.txt", "--index", "letters.index"],
        ["events", "gs3", "rod", "--kind", "topology", "--index", "letters.index"],
        ["view", "gs3", "rod", "--index", "letters.index", "-o", "page.html"],
    ],
    ids=" ".join,
)
def test_polyhedra_have_no_index(minkref: Minkref, at: Path, arguments: list[str]) -> None:
    (at / "scales.txt").write_text("1,2,3\n", encoding="utf-8")
    refused(minkref, at, *arguments)
    assert sorted(path.name for path in at.iterdir()) == ["letters.index", "scales.txt"]


@pytest.mark.parametrize(
    ("options", "word"),
    [
        (["--memory", "1"], "memory"),
        (["--memory", "-1"], "--memory -1"),
        (["--memory", "much"], "--memory"),
        (["--threads", "0"], "--threads 0"),
        (["--threads", "-2"], "--threads -2"),
        (["--threads", "100000"], "--threads 100000"),
        (["--check", "-1"], "--check -1"),
        (["--check", "1000000"], "--check 1000000"),
        (["--from", "0"], "--from"),
        (["--from", ""], "--from"),
        (["--to", "-1"], "--to"),
        (["--to", "x"], "--to"),
        (["--from", "2", "--to", "1"], "empty"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else value,
)
def test_a_bad_option_is_refused_and_an_older_file_is_left(
    minkref: Minkref, tmp_path: Path, options: list[str], word: str
) -> None:
    path = tmp_path / "sums.index"
    for text in (None, "an older one"):
        if text is not None:
            path.write_text(text, encoding="utf-8")
        err, _ = refused(minkref, tmp_path, "index", "g1", "g2", "-o", path, *options)
        assert word in err
        assert path.exists() == (text is not None)


def test_points_without_a_sum_are_refused(minkref: Minkref, tmp_path: Path) -> None:
    thin = written(tmp_path, "thin", THIN["point"]), written(tmp_path, "long", THIN["segment"])
    refused(minkref, tmp_path, "index", *thin, "-o", tmp_path / "sums.index")
    assert not (tmp_path / "sums.index").exists()


def test_the_file_of_an_operand_is_not_lost(minkref: Minkref, tmp_path: Path) -> None:
    P, Q = written(tmp_path, "P", TRIANGLE), written(tmp_path, "Q", U)
    link = tmp_path / "link"
    link.symlink_to(Q)
    for output in (P, Q, link):
        text, error = refused(minkref, tmp_path, "index", P, Q, "-o", output)
        assert "operand" in text
        assert error["code"] == "cannot-write"
    assert Path(P).read_text(encoding="utf-8") == TRIANGLE


def test_an_output_that_cannot_be_is_refused(minkref: Minkref, tmp_path: Path) -> None:
    text, _ = refused(
        minkref, tmp_path, "index", "g1", "g2", "-o", tmp_path / "no" / "such" / "folder"
    )
    assert "does not exist" in text
    assert "folder" in refused(minkref, tmp_path, "index", "g1", "g2", "-o", tmp_path)[0]
    assert list(tmp_path.iterdir()) == []
    assert minkref("index", "g1", "g2").code == 2


@pytest.mark.parametrize("command", ["events", "view"])
@pytest.mark.parametrize("route", [["--index", "letters.index"], ["--route", "index"]])
@pytest.mark.parametrize(
    ("window", "word"),
    [
        (["--from", "2", "--to", "1"], ""),
        (["--from", ""], "not a number"),
        (["--to", ""], "not a number"),
        (["--from", "0"], "zero"),
    ],
    ids=["backwards", "empty begin", "empty end", "zero"],
)
def test_a_bad_window_is_refused_also_with_an_index(
    minkref: Minkref, at: Path, command: str, route: list[str], window: list[str], word: str
) -> None:
    text, _ = refused(minkref, at, *COMMANDS[command], *route, *window)
    assert word in text


def test_no_route_of_that_name(minkref: Minkref, at: Path) -> None:
    for command in COMMANDS.values():
        text, _ = refused(minkref, at, *command, "--route", "indices")
        assert "no route" in text


class Differing:
    """An index that errs at every scale asked for."""

    def __init__(self, index: _core.ScaleIndex) -> None:
        self._index = index

    def __getattr__(self, name: str) -> Any:
        return getattr(self._index, name)

    def first_difference(self, scales: list[str]) -> str:
        return scales[0]


def test_an_index_that_differs_from_the_static_route_is_not_written(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from minkref.plane.commands import index

    build_index = index.build_index
    monkeypatch.setattr(index, "build_index", lambda *given: Differing(build_index(*given)))
    path = tmp_path / "sums.index"
    path.write_text("an older one", encoding="utf-8")
    assert minkref("index", "g3", "g1", "-o", path).code == 70
    assert path.read_text(encoding="utf-8") == "an older one"
    assert minkref("index", "g3", "g1", "-o", path, "--check", "0").code == 0
