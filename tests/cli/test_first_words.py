"""First words of a new user: the version, completion, an almost right word."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from forked import forked


def run(*words: str, folder: Path) -> subprocess.CompletedProcess[str]:
    return forked(folder, *words)


def test_the_version_in_short(tmp_path: Path) -> None:
    short, long = (run(word, folder=tmp_path) for word in ("-V", "--version"))
    assert short.stdout == long.stdout and short.stdout.startswith("minkref ")
    assert (short.returncode, short.stderr) == (0, "")


COMPLETE = """
eval "$(minkref --show-completion)"
complete_words() {
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
  _minkref_completion minkref
  echo "${COMPREPLY[@]}"
}
complete_words minkref verify clipper2-d
exit 0
"""


def test_completion_in_bash(tmp_path: Path) -> None:
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    ran = subprocess.run(
        ["bash", "-c", COMPLETE],
        cwd=tmp_path,
        env={**os.environ, "PATH": path},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert (ran.stdout, ran.stderr) == ("clipper2-double\n", "")


@pytest.mark.parametrize(
    ("words", "completed"),
    [
        ("minkref ver", "verify"),
        ("minkref verify --no-s", "--no-settings"),
        ("minkref verify --family small", "small-holes"),
    ],
)
def test_what_bash_is_told(tmp_path: Path, words: str, completed: str) -> None:
    asked = {"_MINKREF_COMPLETE": "complete_bash", "COMP_WORDS": words}
    asked["COMP_CWORD"] = str(len(words.split()) - 1)
    ran = forked(tmp_path, before=lambda: os.environ.update(asked))
    assert (ran.stdout.split(), ran.stderr) == ([completed], "")


@pytest.mark.parametrize(
    ("words", "mend"),
    [
        (("verify", "cgal-reducd"), "did you mean cgal-reduced?"),
        (("verify", "minkref:papr"), "did you mean minkref:paper?"),
        (("verify", "minkref:paper", "--family", "hole"), "did you mean holes?"),
        (("verify", "minkref:paper", "--family", "space-thn"), "did you mean space-thin?"),
        (("verify", "minkref:paper", "--suite", "corpse"), "did you mean corpus?"),
        (("verify", "adapter.py"), "write ./adapter.py"),
        (("sum", "g1", "gg1"), "did you mean g1?"),
        (("sum", "g1", "g2", "--route", "papr"), "did you mean paper?"),
        (("sum", "g1", "g2", "--arithmetic", "ratioal"), "did you mean rational?"),
        (("sum", "gs3", "rod", "--route", "dynamc"), "did you mean dynamic?"),
        (
            ("sweep", "g1", "g2", "--scales", "s", "-o", "x", "--format", "jsn"),
            "did you mean json?",
        ),
        (("convolution", "g1", "g2", "--compatible", "half-opn"), "did you mean half-open?"),
        (("convolution", "g1", "g2", "-o", "-", "--format", "geojsn"), "did you mean geojson?"),
        (("events", "g1", "g2", "--kind", "pairs"), "did you mean pair?"),
        (("events", "g1", "g2", "--form", "printd"), "did you mean printed?"),
        (("adapter", "new", "x", "--language", "pyton"), "did you mean python?"),
        (("adapter", "install", "clippr2"), "did you mean clipper2?"),
        (("generate", "antena"), "did you mean antennas?"),
        (("report", "audi"), "did you mean audit?"),
        (("bench", "--only", "tabel1"), "did you mean table1?"),
        (("verfy",), "Did you mean 'verify'"),
        (("sum", "g1", "g2", "--scale"), "`minkref sum --help`"),
        (("adapter", "new", "x", "--language"), "`minkref adapter new --help`"),
        (("verify", "so:./x.so:f"), "`minkref adapter header`"),
    ],
)
def test_a_word_that_is_nearly_right(
    minkref: Callable[..., Any],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    words: tuple[str, ...],
    mend: str,
) -> None:
    (tmp_path / "adapter.py").write_text("")
    (tmp_path / "s").write_text("1\n")
    monkeypatch.chdir(tmp_path)
    ran = minkref(*words)
    assert ran.code == 2 and mend in ran.err


def test_where_the_header_is(tmp_path: Path) -> None:
    ran = run("adapter", "header", folder=tmp_path)
    assert ran.returncode == 0
    path = Path(ran.stdout.strip())
    assert path.name == "minkref_adapter.h" and "minkref_sum_function" in path.read_text()


def test_a_quiet_run_says_it_by_its_exit_code(tmp_path: Path) -> None:
    more = ("--pairs", "2", "--no-models", "--jobs", "1", "--quiet")
    for extra, code in ((("minkref:paper",), 0), (("minkref:paper", "--family", "x"), 2)):
        ran = run("verify", *extra, *more, folder=tmp_path)
        assert (ran.returncode, ran.stdout) == (code, "")
    ran = run("verify", "minkref:paper", *more, "--json", folder=tmp_path)
    assert json.loads(ran.stdout)["exit_code"] == 0


def test_entries_of_a_baseline_that_nothing_met(tmp_path: Path) -> None:
    entries = [
        {"target": target, "version": version, "kind": "missing", "reason": "known"}
        for target, version in (("minkref:*", "*"), ("minkref:*", "0.0.9"), ("other", "*"))
    ]
    text = json.dumps({"baseline": "baseline-v1", "entries": entries})
    (tmp_path / "known.json").write_text(text)
    more = ("--pairs", "2", "--no-models", "--jobs", "1", "--baseline", "known.json", "--json")
    ran = run("verify", "minkref:paper", *more, folder=tmp_path)
    notes = json.loads(ran.stdout)["notes"]
    assert notes == ["the baseline lists missing of minkref:paper, which this run did not meet"]
