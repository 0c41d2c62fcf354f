"""`minkref index`: its document, its file, and builds that do not finish."""

from __future__ import annotations

import os
import shutil
import signal
import stat
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from index_runs import (
    TRIANGLE,
    Minkref,
    U,
    Window,
    ask,
    build,
    refused,
    told,
    window_options,
    written,
)
from minkref import _core
from minkref.schemas import schema
from processes import started

# The document, the file.


@pytest.mark.parametrize("window", [(None, None), ("1/2", None), (None, "3"), ("1/2", "3")])
def test_document_follows_the_published_schema_and_tells_the_file(
    minkref: Minkref, tmp_path: Path, window: Window
) -> None:
    jsonschema.Draft202012Validator.check_schema(schema("index"))
    path = tmp_path / "sums.index"
    value = build(minkref, path, "g3", "g1", *window_options(window), "--threads", "2")
    assert (value["P"], value["Q"], value["from"], value["to"]) == ("g3", "g1", *window)
    assert (value["output"], value["bytes"]) == (str(path), path.stat().st_size)
    assert value["threads"] == 2
    opened = _core.ScaleIndex.open(str(path))
    assert [None if s is None else str(s) for s in opened.window] == list(window)
    kinds = [row[0] for row in opened.edges()]
    assert value["segments"] == {kind: kinds.count(kind) for kind in "ST"}
    assert value["statistics"]["tracks"] == len(opened.tracks())
    assert [path.name for path in tmp_path.iterdir()] == ["sums.index"]


def test_without_a_window_all_events_are_counted(minkref: Minkref, tmp_path: Path) -> None:
    statistics = build(minkref, tmp_path / "sums.index", "g1", "g2")["statistics"]
    for kind in ("boundary", "topology"):
        events = ask(minkref, "events", "g1", "g2", "--kind", kind, "--route", "dynamic")
        assert statistics[f"{kind}_events"] == events["count"] > 0


@pytest.mark.parametrize("count", [0, 1, 6])
@pytest.mark.parametrize("window", [(None, None), ("1/3", "2"), ("5", None), (None, "1/1000")])
def test_as_many_scales_of_the_window_are_checked_as_told(
    minkref: Minkref, tmp_path: Path, count: int, window: Window
) -> None:
    value = build(
        minkref, tmp_path / "x", "g3", "g1", *window_options(window), "--check", str(count)
    )
    scales = [Fraction(scale) for scale in value["checked"]["scales"]]
    assert len(scales) == count
    assert all(scale > 0 for scale in scales)
    assert all(scale >= Fraction(window[0]) for scale in scales if window[0])
    assert all(scale <= Fraction(window[1]) for scale in scales if window[1])


def test_people_are_told_what_was_built_and_that_nothing_was_checked(
    minkref: Minkref, tmp_path: Path
) -> None:
    path = tmp_path / "sums.index"
    ran = minkref("index", "g3", "g1", "-o", path, "--from", "1/2", "--check", "0")
    assert (ran.code, ran.err) == (0, "")
    for text in ("g3 + g1", "1/2 to infinity", "edges", "not: --check 0", path.name, "bytes"):
        assert text in ran.out, text


def test_an_index_is_the_same_bytes_however_often_and_by_however_many_threads_it_is_built(
    minkref: Minkref, tmp_path: Path
) -> None:
    for P, Q, window in (("g1", "g2", ()), ("g1", "glyph275", ("--from", "1/2", "--to", "3"))):
        files = []
        for number, threads in enumerate((1, 1, 2, 7)):
            path = tmp_path / f"{number}.index"
            build(minkref, path, P, Q, *window, "--threads", str(threads), "--check", "0")
            files.append(path.read_bytes())
        assert len(files[0]) > 1000
        assert all(file == files[0] for file in files)


def test_an_earlier_file_is_replaced_and_one_that_is_linked_to(
    minkref: Minkref, tmp_path: Path
) -> None:
    path, link = tmp_path / "sums.index", tmp_path / "link"
    path.write_text("an older one", encoding="utf-8")
    link.symlink_to(path)
    build(minkref, path, "g3", "g1")
    whole = path.read_bytes()
    path.write_text("an older one", encoding="utf-8")
    build(minkref, link, "g3", "g1")
    assert link.is_symlink()
    assert path.read_bytes() == whole
    assert sorted(path.name for path in tmp_path.iterdir()) == ["link", "sums.index"]


def test_a_pipe_is_written_to_and_stays_a_pipe(minkref: Minkref, tmp_path: Path) -> None:
    P, Q = written(tmp_path, "P", TRIANGLE), written(tmp_path, "Q", U)
    whole, pipe = tmp_path / "whole.index", tmp_path / "pipe"
    build(minkref, whole, P, Q, "--from", "1", "--to", "1", "--check", "0")
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        ran = minkref("index", P, Q, "-o", pipe, "--from", "1", "--to", "1", "--check", "0")
        assert stat.S_ISFIFO(pipe.stat().st_mode)
        if ran.code == 0:
            assert os.read(reader, 1 << 20) == whole.read_bytes()
        else:
            assert ran.code == 2
    finally:
        os.close(reader)


# Builds that do not come to their end.

# Announces the build's beginning; `last` runs before the file takes its name.
SLOW = """
import os, signal, sys
from minkref.output import documents
from minkref.plane.commands import index
from minkref.cli.cli import run
build = index.build_index
def telling(*arguments):
    print("building", flush=True)
    return build(*arguments)
index.build_index = telling
{last}
sys.exit(run(sys.argv[1:]))
"""


@contextmanager
def begun(path: Path, P: str, Q: str, last: str = "") -> Iterator[subprocess.Popen[str]]:
    """A build in progress."""
    command = ["index", P, Q, "-o", str(path), "--threads", "1", "--check", "0"]
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    with started(
        [sys.executable, "-c", SLOW.format(last=last), *command], text=True, **streams
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "building\n"
        yield process


@pytest.mark.parametrize(
    ("number", "old"),
    [
        (signal.SIGKILL, None),
        (signal.SIGKILL, b"an older one"),
        (signal.SIGTERM, b"an older one"),
        (signal.SIGINT, None),
    ],
)
def test_a_build_that_is_killed_leaves_no_file_and_an_older_one_whole(
    tmp_path: Path, number: signal.Signals, old: bytes | None
) -> None:
    path = tmp_path / "sums.index"
    if old is not None:
        path.write_bytes(old)
    with begun(path, "glyph1204", "glyph275") as process:
        time.sleep(0.2)
        process.send_signal(number)
        process.communicate(timeout=60)
    assert process.returncode in (-number, 128 + number)
    assert [(p.name, p.read_bytes()) for p in tmp_path.iterdir()] == (
        [] if old is None else [(path.name, old)]
    )


@pytest.mark.parametrize("old", [None, b"an older one"])
def test_a_build_that_is_killed_before_its_file_has_its_name_leaves_an_older_one_whole(
    tmp_path: Path, old: bytes | None
) -> None:
    path = tmp_path / "sums.index"
    if old is not None:
        path.write_bytes(old)
    dies = "documents.os.replace = lambda *paths: os.kill(os.getpid(), signal.SIGKILL)"
    with begun(path, "g1", "g3", dies) as process:
        process.communicate(timeout=60)
    assert process.returncode == -signal.SIGKILL
    assert (path.read_bytes() if path.exists() else None) == old


def test_a_file_that_cannot_be_written_leaves_an_older_one_whole(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "sums.index"
    path.write_text("an older one", encoding="utf-8")

    def full(*paths: Any) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("minkref.output.documents.os.replace", full)
    text, _ = refused(minkref, tmp_path, "index", "g1", "g3", "-o", path)
    assert "No space left" in text
    assert [path.name for path in tmp_path.iterdir()] == ["sums.index"]


@pytest.mark.parametrize("copied", [False, True])
def test_an_index_may_be_moved_and_be_read_only(
    minkref: Minkref, letters: Path, tmp_path: Path, copied: bool
) -> None:
    (tmp_path / "elsewhere").mkdir()
    other = tmp_path / "elsewhere" / "a name with blanks"
    (shutil.copy if copied else shutil.move)(letters, other)
    other.chmod(0o400)
    assert told(minkref, "g1", "g2", "--index", other) == told(minkref, "g1", "g2")
