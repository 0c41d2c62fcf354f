"""Files that belong together: a run writes all or none, and every run writes the same."""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from forked import forked
from minkref.errors import Refusal
from minkref.output.documents import lasting, write_together

PART = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"
WALLS = "MULTIPOLYGON (((-9 0, -1 0, -1 1, -9 1, -9 0)), ((3 0, 9 0, 9 1, 3 1, 3 0)))"
WAY = "LINESTRING (0 3, 0 -3)"
SEVERAL = {
    "certify": ("certify", "g1", "g2", "-o", "proof.cert.json"),
    "certify, compressed": ("certify", "g1", "g2", "-o", "proof.cert.json.gz"),
    "path": ("path", PART, WALLS, WAY, "--to", "3", "--certify", "p.cert.json", "-o", "p.json"),
    "sweep": ("sweep", "g1", "g2", "--from", "1", "--to", "2", "--steps", "3", "-o", "sums"),
}  # fmt: skip
ONE = {
    "convolution": ("convolution", "g1", "g2", "-o", "c.json"),
    "events": ("events", "g1", "g2", "--limit", "9", "-o", "e.json"),
    "events with a disc": ("events", "g1", "disc", "-o", "e.json"),
    "index with a disc": ("index", "g1", "disc", "-o", "i.json"),
    "index": ("index", "g1", "g2", "--from", "1", "--to", "9/8", "--check", "0", "-o", "i.idx"),
    "sum": ("sum", "g1", "g2", "-o", "s.json"),
    "view": ("view", "g1", "g2", "--from", "1", "--to", "9/8", "-o", "v.html"),
}


def files(folder: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def run(
    words: tuple[str, ...], folder: Path, before: Callable[[], Any] = int
) -> subprocess.CompletedProcess[str]:
    folder.mkdir(exist_ok=True)
    return forked(folder, *words, before=before)


ALL_OF_THEM = """
import json, os, sys
from pathlib import Path
from minkref.cli.cli import run
for name, words in json.loads(sys.argv[1]).items():
    os.makedirs(Path(sys.argv[2], name))
    os.chdir(Path(sys.argv[2], name))
    assert run(words) == 0, name
"""


@pytest.fixture(scope="module")
def twice(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Folders with all commands' output from two runs, whose sets are ordered differently."""
    folders = [tmp_path_factory.mktemp("run") for _ in range(2)]
    for seed, folder in enumerate(folders, start=1):
        words = [sys.executable, "-c", ALL_OF_THEM, json.dumps({**SEVERAL, **ONE}), str(folder)]
        environment = {**os.environ, "PYTHONHASHSEED": str(seed)}
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL, env=environment)
    return folders


@pytest.mark.parametrize("name", [*SEVERAL, *ONE])
def test_two_runs_write_the_same_bytes(name: str, twice: list[Path]) -> None:
    written, again = (files(folder / name) for folder in twice)
    assert written
    assert written == again


@pytest.mark.parametrize("name", SEVERAL)
def test_a_full_disk_leaves_none_of_them(name: str, tmp_path: Path) -> None:
    """The limit leaves room for the smallest file, but not for the largest."""
    assert run(SEVERAL[name], tmp_path / "whole").returncode == 0
    sizes = sorted(map(len, files(tmp_path / "whole").values()))
    assert len(sizes) > 1
    limit = sizes[-1] - 1

    def full() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    # Without --no-check the checker's temporary files have no room either.
    for more in [(), ("--no-check",)] if name.startswith("certify") else [()]:
        ran = run((*SEVERAL[name], *more), tmp_path / "full", full)
        assert ran.returncode == 2, ran.stderr
        assert "File too large" in ran.stderr
        assert not list((tmp_path / "full").iterdir())


def test_a_file_that_was_there_stays_where_another_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "old").write_text("as it was")
    with pytest.raises(Refusal):
        write_together({tmp_path / "old": "new", tmp_path / "absent" / "file": "text"})
    assert files(tmp_path) == {"old": b"as it was"}
    write_together({tmp_path / "old": "new", tmp_path / "other": b"bytes"})
    assert files(tmp_path) == {"old": b"new", "other": b"bytes"}


def test_streams_come_last(tmp_path: Path) -> None:
    reader, writer = os.pipe()
    with pytest.raises(Refusal):
        write_together({Path(f"/dev/fd/{writer}"): "text", tmp_path / "absent" / "file": "text"})
    os.close(writer)
    assert os.read(reader, 10) == b""
    os.close(reader)


def test_files_have_no_times() -> None:
    value = {"seconds": 1.5, "peak_bytes": 7, "rows": [{"sum_seconds": 2.0, "scale": "1"}]}
    assert lasting(value) == {
        "seconds": None,
        "peak_bytes": None,
        "rows": [{"sum_seconds": None, "scale": "1"}],
    }
