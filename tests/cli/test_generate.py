"""`minkref generate`, and other commands on the generated cases."""

from __future__ import annotations

import itertools
import json
import multiprocessing
import os
import pickle
import resource
import shlex
import signal
import subprocess
import sys
import time
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from typing import Any, NoReturn

import jsonschema
import pytest
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import FAMILIES
from minkref.degeneracies.family import NothingDrawn
from minkref.degeneracies.plane.case_document import Degenerate
from minkref.errors import Refusal
from minkref.schemas import schema
from minkref.verbs import generate
from processes import program, started

SECONDS = 60.0  # more than enough for what ends at once


@pytest.mark.parametrize(
    ("words", "code", "told"),
    [
        (["fits-hole", "--count", "2"], 0, "2 cases"),
        (["invalid-self-intersection", "--count", "3"], 0, "3 cases"),
        (["invalid-empty-file", "--count", "12"], 0, "10 different"),
        (["invalid-not-a-case", "--count", "12"], 0, "12 cases"),
        (["comb"], 2, "`minkref families` lists all families"),
        (["fits-hole", "--count", "0"], 2, "--count"),
    ],
)
def test_generate(minkref: Any, tmp_path: Path, words: list[str], code: int, told: str) -> None:
    words = [*words, "--jobs", "1"]
    ran = minkref("generate", *words, "-o", str(tmp_path / "out"))
    assert (ran.code, told in ran.out + ran.err) == (code, True)
    if words[0].startswith("invalid"):
        files = [path for path in (tmp_path / "out").rglob("*") if path.is_file()]
        assert len({path.name.split(".")[0] for path in files}) == len(files) / 2
        for path in (tmp_path / "out").rglob("*.refusal.json"):
            told = json.loads(path.read_text(encoding="utf-8"))
            bad = minkref("sum", str(path.with_name(told["operand"])), "g1")
            assert bad.code == 2 and all(place in bad.err for place in told["place"])
    elif code == 0:
        assert minkref("check", str(tmp_path / "out")).code == 0
        value = minkref("generate", *words, "-o", str(tmp_path / "out"), "--json").json
        assert [Path(row["case"]).exists() for row in value["cases"]] == [True, True]
    else:
        assert not (tmp_path / "out").exists()


def test_a_case_can_be_verified(minkref: Any) -> None:
    (path,) = list((lint.CORPUS / "fits-slot").glob("*.json"))[:2][:1]
    name = str(path).replace(".cert.json", ".json")
    ran = minkref("verify", "minkref", "--case", name, "--json")
    assert ran.code == 0


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ('{"schema": "case-v1", "id"', "syntax"),
        ('{"schema": "case-v9", "id": "x", "dimension": 2}', "unsupported-version"),
        (
            '{"schema": "case-v1", "id": "x", "dimension": 2, "scales": ["1"], '
            '"P": {"polygons": [{"outer": [["0","0"],["0","0"],["1","0"],["0","1"]]}]}, '
            '"Q": {"polygons": []}}',
            "zero-length-edge",
        ),
    ],
)
def test_a_bad_case_in_a_corpus_is_refused(
    minkref: Any, tmp_path: Path, text: str, code: str
) -> None:
    """Bad files are refused, not silently skipped."""
    path = tmp_path / "bad.json"
    path.write_text(text, encoding="utf-8")
    words = ("verify", "minkref", "--suite", "corpus", "--corpus", str(tmp_path), "--json")
    ran = minkref(*words)
    assert (ran.code, ran.json["error"]["code"]) == (2, code)
    ran = minkref("verify", "minkref", "--case", str(path), "--json")
    assert ran.code == 2 and "bad.json" in ran.out


def test_an_empty_scale_is_no_scale(minkref: Any) -> None:
    assert minkref("verify", "minkref", "--case", "g1+g2@").code == 2


def files(folder: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file()
    }


def test_a_refusal_comes_whole_out_of_another_process() -> None:
    refusal = Refusal("what", "where", "mend", "code")
    again = pickle.loads(pickle.dumps(refusal))
    assert (type(again), str(again)) == (Refusal, str(refusal))
    assert again.document() == refusal.document()


def test_neither_processes_nor_their_number_change_the_files(minkref: Any, tmp_path: Path) -> None:
    """Rows come by family in name order, then by number."""
    rows = []
    for jobs in "12":
        words = ("fits-slot", "invalid-empty-file", "--count", "4", "--jobs", jobs, "--json")
        ran = minkref("generate", *words, "-o", tmp_path / jobs)
        rows.append([(row["family"], row["index"], row["id"]) for row in ran.json["cases"]])
    assert rows[0] == rows[1]
    names = ("fits-slot", "invalid-empty-file")
    assert [row[:2] for row in rows[0]] == list(itertools.product(names, range(4)))
    assert files(tmp_path / "1") == files(tmp_path / "2")


def test_members_that_are_the_same_case_are_counted_once(minkref: Any, tmp_path: Path) -> None:
    ran = minkref("generate", "invalid-empty-file", "--count", "12", "-o", tmp_path, "--json")
    jsonschema.validate(ran.json, schema("generate"))
    rows, ids = ran.json["cases"], {row["id"] for row in ran.json["cases"]}
    assert len(rows) == 12 > len(ids) == ran.json["different"]
    assert ran.json["bytes"] == sum(map(len, files(tmp_path).values()))
    sizes = {row["id"]: row["bytes"] for row in rows}
    assert [row["bytes"] for row in rows] == [sizes[row["id"]] for row in rows]


@pytest.mark.parametrize("jobs", [1, 2])
def test_members_are_not_asked_for_long_before_they_are_taken(jobs: int) -> None:
    """However many there are; and who takes no more leaves no process behind."""
    before = set(multiprocessing.active_children())
    asked = itertools.count()
    tasks = (("invalid-empty-file", 1, next(asked), None) for _ in itertools.repeat(None))
    with closing(generate._made(tasks, jobs)) as members:
        assert [made.index for made in itertools.islice(members, 3)] == [0, 1, 2]
    assert next(asked) <= 3 + generate.AHEAD * jobs
    assert set(multiprocessing.active_children()) <= before


@pytest.mark.parametrize(
    "words",
    [
        ("fits-hole", "--seed", "5", "--index", "2"),
        ("fits-slot", "--seed", "1", "--index", "1", "--size", "12"),
        ("invalid-syntax", "--seed", "3", "--index", "2"),
    ],
)
def test_the_source_of_a_case_is_the_command_that_makes_it(
    minkref: Any, tmp_path: Path, words: tuple[str, ...]
) -> None:
    """A single member equals the same member of a whole run."""
    assert minkref("generate", *words, "--jobs", "1", "-o", tmp_path / "one").code == 0
    one = files(tmp_path / "one")
    assert len(one) == 2
    told = next(
        value
        for value in (json.loads(text) for name, text in one.items() if name.endswith(".json"))
        if "source" in value
    )
    assert shlex.split(told["source"]) == ["minkref", "generate", *words]
    if "--size" not in words:
        index = words.index("--index")
        all_of_them = (*words[:index], "--count", "3", "--jobs", "1", "-o", tmp_path / "all")
        assert minkref("generate", *all_of_them).code == 0
        both = files(tmp_path / "all")
        assert {name: both.get(name) for name in one} == one


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["fits-hole", "--count", "1000000000"], "--count"),
        (["fits-hole", "--index", "-1"], "--index"),
        (["fits-hole", "--index", "3", "--count", "10"], "--count 10 and --index 3"),
        (["fits-hole", "--size", "7"], "--size"),
        (["fits-hole", "--size", "2001"], "--size"),
        (["all", "invalid-syntax", "--size", "20"], "invalid-syntax"),
        (["invalid", "--size", "20"], "--size 20"),
        (["fits-hole", "--jobs", "100000"], "--jobs"),
        (["fits-hole", "-o", ""], "-o ''"),
    ],
)
def test_what_cannot_be_meant_is_refused_and_makes_nothing(
    minkref: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: list[str], told: str
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = minkref("generate", *words)
    assert (ran.code, told in ran.err, "fix: " in ran.err) == (2, True, True)
    assert not list(tmp_path.iterdir())


def test_a_size_that_nothing_drawn_has_is_refused(
    minkref: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def nothing(*_: Any) -> NoReturn:
        raise NothingDrawn

    family = replace(FAMILIES["fits-hole"], draw=nothing)
    monkeypatch.setitem(FAMILIES, "fits-hole", family)
    words = ("generate", "fits-hole", "--count", "1", "-o", tmp_path / "out")
    ran = minkref(*words, "--size", "2000", "--json")
    assert (ran.code, ran.json["error"]["code"]) == (2, "nothing-drawn")
    assert "fits-hole --seed 1 --index 0 --size 2000" in ran.err
    assert minkref(*words).code == 70  # without a size it is a fault of ours
    assert not (tmp_path / "out").exists()


def occupied(folder: Path) -> Path:
    (folder / "fits-slot").touch()
    return folder


def leading_nowhere(folder: Path) -> Path:
    (folder / "fits-slot").symlink_to(folder / "nowhere")
    return folder


def below_a_file(folder: Path) -> Path:
    (folder / "file").touch()
    return folder / "file" / "out"


@pytest.mark.parametrize("jobs", ["1", "2"])
@pytest.mark.parametrize(
    "made",
    [
        occupied,
        leading_nowhere,
        below_a_file,
        lambda folder: below_a_file(folder).parent,
        lambda folder: folder / ("x" * 300),
        lambda _: Path("/proc/x"),
    ],
)
def test_a_folder_that_cannot_be_made_is_refused(
    minkref: Any, tmp_path: Path, made: Any, jobs: str
) -> None:
    """The refusal comes before any member of the first family."""
    folder = made(tmp_path)
    before = sorted(tmp_path.rglob("*"))
    words = ("fits-hole", "fits-slot", "--count", "1", "--jobs", jobs, "--json")
    ran = minkref("generate", *words, "-o", folder)
    assert (ran.code, ran.json["error"]["code"]) == (2, "cannot-write")
    assert str(folder).split("/fits-slot")[0] in ran.err or "file" in ran.err
    assert sorted(tmp_path.rglob("*")) == before


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_a_full_disk_is_refused_and_leaves_no_half_of_a_member(
    minkref: Any, tmp_path: Path, jobs: str
) -> None:
    """The limit leaves room for only the smaller of two files."""
    words = ("generate", "fits-slot", "--count", "3", "--jobs")
    assert minkref(*words, "1", "-o", tmp_path / "whole").code == 0
    limit = min(map(len, files(tmp_path / "whole").values()))
    assert max(map(len, files(tmp_path / "whole").values())) > 2 * limit
    ran = subprocess.run(
        [sys.executable, "-m", "minkref", *words, jobs, "-o", str(tmp_path / "out")],
        capture_output=True,
        text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2 * limit, 2 * limit)),
    )
    assert (ran.returncode, "cannot be written: File too large" in ran.stderr) == (2, True)
    assert not files(tmp_path / "out")


@pytest.mark.parametrize("text", ["case_text", "certificate_text"])
def test_a_certificate_is_not_written_without_its_case(
    minkref: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str
) -> None:
    """No file is written before both texts exist."""

    def broken(_: Degenerate) -> NoReturn:
        raise RuntimeError("a fault of ours")

    monkeypatch.setattr(Degenerate, text, property(broken))
    ran = minkref("generate", "fits-slot", "--count", "1", "-o", tmp_path / "out")
    assert (ran.code, "fits-slot --seed 1 --index 0" in ran.err) == (70, True)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL])
def test_processes_end_with_the_command(tmp_path: Path, number: signal.Signals) -> None:
    """Output closes only after all processes have gone. Files are whole, and no temporary file
    remains."""
    words = ("generate", "fits-slot", "--count", "10000000", "--jobs", "2", "-o", str(tmp_path))
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    with started(program(*words), **streams) as running:
        until = time.monotonic() + SECONDS
        while not list(tmp_path.rglob("*.json")) and time.monotonic() < until:
            time.sleep(0.05)
        running.send_signal(number)
        running.communicate(timeout=SECONDS)
    assert running.returncode == (-number if number == signal.SIGKILL else 128 + number)
    if number == signal.SIGTERM:
        assert not [path for path in tmp_path.rglob("*") if path.name.startswith(".minkref")]
    assert all(json.loads(path.read_text(encoding="utf-8")) for path in tmp_path.rglob("*.json"))


KILLED = """
import operator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import active_children, get_context
from minkref.verbs.generate import _kill

if __name__ == "__main__":
    pool = ProcessPoolExecutor(2, get_context("spawn"))
    results = [pool.submit(operator.mul, b"x", 8 << 20) for _ in range(200)]
    results[0].result()
    _kill(pool, active_children())
    pool.shutdown(cancel_futures=True)
"""


def test_a_pool_ends_though_a_result_was_half_written(tmp_path: Path) -> None:
    program = tmp_path / "killed.py"
    program.write_text(KILLED, encoding="utf-8")
    subprocess.run([sys.executable, program], check=True, timeout=SECONDS, capture_output=True)


@pytest.mark.parametrize("name", ["space/a b", "it's $HOME", "-x"])
def test_the_command_that_checks_can_be_pasted_into_a_shell(
    minkref: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = minkref("generate", "fits-slot", "--count", "1", "-o", name)
    told = ran.out.splitlines()[-1].removeprefix("check them: ")
    assert shlex.split(told)[:2] == ["minkref", "check"]
    assert os.path.samefile(shlex.split(told)[-1], name)
    assert minkref(*shlex.split(told)[1:]).code == 0
