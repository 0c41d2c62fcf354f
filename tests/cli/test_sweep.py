"""`minkref sweep`: each sum equals `minkref sum`'s; scales, files and folders."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import _core
from minkref.exact import digest
from minkref.fuzz.plane.families.random_pairs import random_pair
from minkref.output.documents import lasting
from minkref.plane.operand import read_operand
from minkref.schemas import schema
from processes import program, started
from thoroughness import draws

Minkref = Callable[..., Any]


def scales_file(folder: Path, text: str) -> Path:
    path = folder / "scales.txt"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(("P", "Q"), [("g1", "g2"), ("g4", "g3"), ("dog145", "g1")])
def test_each_result_is_that_of_minkref_sum(minkref: Minkref, P: str, Q: str) -> None:
    value = minkref("sweep", P, Q, "--from", "1/3", "--to", "4", "--steps", "5", "--json").json
    jsonschema.validate(value, schema("sweep"))
    assert [row["scale"] for row in value["rows"]] == ["1/3", "5/4", "13/6", "37/12", "4"]
    for row in value["rows"]:
        alone = minkref("sum", P, Q, "--scale", row["scale"], "--json").json
        for name in ("digest", "area", "area_approximate", "components", "holes", "vertices"):
            assert row[name] == alone[name], (row["scale"], name)


def test_scales_of_events_are_visited_too(minkref: Minkref, tmp_path: Path) -> None:
    P, Q = (read_operand(name).set for name in ("g1", "g3"))
    events = [row[0] for row in _core.pair_events(P, Q, "1/2", "2").rows(0, 1000)]
    scales = list(dict.fromkeys(events))[::9]
    assert len(scales) > 20
    file = scales_file(tmp_path, "\n".join(scales))
    value = minkref("sweep", "g1", "g3", "--scales", file, "--json").json
    for row in value["rows"]:
        alone = _core.minkowski_sum(P, Q, row["scale"]).region
        assert row["digest"] == digest(alone.canonical_json()), row["scale"]


def test_order_of_the_file_is_kept_with_comments_and_blank_lines(
    minkref: Minkref, tmp_path: Path
) -> None:
    file = scales_file(tmp_path, "# there and back\n2\n\n0.5  # small\n2\n 7/5\n14/10\n")
    value = minkref("sweep", "g1", "g2", "--scales", file, "--route", "dynamic", "--json").json
    rows = value["rows"]
    assert [row["scale"] for row in rows] == ["2", "1/2", "2", "7/5", "7/5"]
    assert rows[0]["digest"] == rows[2]["digest"]
    assert (rows[4]["event_scales"], rows[4]["insertions"]) == (0, 0)
    assert rows[1]["insertions"] == rows[2]["deletions"]


def test_window_may_run_downwards_and_one_step_is_its_begin(minkref: Minkref) -> None:
    down = minkref("sweep", "g1", "g2", "--from", "2", "--to", "1", "--steps", "3", "--json").json
    assert [row["scale"] for row in down["rows"]] == ["2", "3/2", "1"]
    one = minkref("sweep", "g1", "g2", "--from", "0.1", "--steps", "1", "--json").json
    assert [row["scale"] for row in one["rows"]] == ["1/10"]


@pytest.mark.parametrize("form", ["json", "wkt", "geojson", "poly", "svg"])
def test_folder_holds_a_file_for_each_scale_and_an_index(
    minkref: Minkref, tmp_path: Path, form: str
) -> None:
    folder = tmp_path / "sums"
    options = ["--from", "1/4", "--to", "1/3", "--steps", "2", "-o", folder, "--format", form]
    ran = minkref("sweep", "g1", "g2", *options, "--json")
    assert (ran.code, ran.err) == (0, "")
    index = json.loads((folder / "index.json").read_text(encoding="utf-8"))
    assert index == lasting(ran.json)
    jsonschema.validate(index, schema("sweep"))
    names = [f"sum-0001.{form}", f"sum-0002.{form}"]
    assert [row["file"] for row in index["rows"]] == names
    assert sorted(path.name for path in folder.iterdir()) == sorted(["index.json", *names])
    if form == "svg":
        return
    for row in index["rows"]:
        text = _core.read_file(str(folder / row["file"])).canonical_json()
        assert (digest(text) == row["digest"]) == row["file_exact"]


def test_earlier_sweep_in_the_folder_is_replaced(minkref: Minkref, tmp_path: Path) -> None:
    folder = tmp_path / "sums"
    window = ["--from", "1", "--to", "2", "-o", folder]
    assert minkref("sweep", "g1", "g2", *window, "--steps", "4").code == 0
    assert minkref("sweep", "g1", "g2", *window, "--steps", "2", "--format", "wkt").code == 0
    names = sorted(path.name for path in folder.iterdir())
    assert names == ["index.json", "sum-0001.wkt", "sum-0002.wkt"]


def test_folder_with_files_of_others_is_refused_and_left_alone(
    minkref: Minkref, tmp_path: Path
) -> None:
    (tmp_path / "thesis.tex").touch()
    ran = minkref("sweep", "g1", "g2", "--from", "1", "--steps", "1", "-o", tmp_path)
    assert ran.code == 2
    assert "thesis.tex" in ran.err
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.tex"]


@pytest.mark.parametrize(
    ("text", "line", "what"),
    [
        ("1\n2\nthree\n", 3, "not a number"),
        ("# none\n1 2\n", 2, "not a number"),
        ("1\n\n-1\n", 3, "negative"),
        ("0\n", 1, "zero"),
        ("1/0\n", 1, "denominator"),
    ],
)
def test_bad_scale_is_refused_by_file_and_line(
    minkref: Minkref, tmp_path: Path, text: str, line: int, what: str
) -> None:
    file, folder = scales_file(tmp_path, text), tmp_path / "sums"
    ran = minkref("sweep", "g1", "g2", "--scales", file, "-o", folder)
    assert (ran.code, ran.out) == (2, "")
    assert f"{file}, line {line}" in ran.err
    assert what in ran.err
    assert not folder.exists()


@pytest.mark.parametrize("content", [b"", b"# nothing\n\n", b"\xff\xfe1\n"])
def test_file_without_scales_or_text_is_refused(
    minkref: Minkref, tmp_path: Path, content: bytes
) -> None:
    file = tmp_path / "scales.txt"
    file.write_bytes(content)
    ran = minkref("sweep", "g1", "g2", "--scales", file, "--json")
    assert ran.code == 2
    jsonschema.validate(ran.json, schema("sweep"))
    assert str(file) in ran.json["error"]["where"]


@pytest.mark.parametrize(
    "options",
    [
        [],
        ["--from", "1"],
        ["--from", "1", "--to", "2"],
        ["--from", "1", "--steps", "3"],
        ["--to", "2", "--steps", "3"],
        ["--from", "1", "--to", "2", "--steps", "0"],
        ["--from", "1", "--to", "2", "--steps", "10000000"],
        ["--from", "0", "--to", "2", "--steps", "3"],
        ["--from", "1", "--to", "2", "--steps", "3", "--format", "pdf", "-o", "sums"],
        ["--from", "1", "--to", "2", "--steps", "3", "--format", "svg"],
        ["--from", "1", "--to", "2", "--steps", "3", "-o", "no/such/folder"],
        ["--scales", "no-such-file"],
        ["--scales", "."],
        ["--scales", "scales.txt", "--from", "1"],
    ],
    ids=" ".join,
)
def test_misuse_is_refused(minkref: Minkref, options: list[str]) -> None:
    ran = minkref("sweep", "g1", "g2", *options)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith("minkref: ")


def test_table_for_people_and_silence_of_progress_in_a_pipe() -> None:
    ran = subprocess.run(
        [sys.executable, "-m", "minkref", "sweep", "g1", "g2", "--from", "1", "--to", "2",
         "--steps", "3", "--route", "dynamic"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert ran.stderr == ""
    for text in ("scale", "insertions", "3/2", "all events"):
        assert text in ran.stdout


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_sweep_leaves_whole_files_and_no_index(
    minkref: Minkref, tmp_path: Path, number: signal.Signals
) -> None:
    folder = tmp_path / "sums"
    words = ["sweep", "g1", "g2", "--from", "1", "--to", "2", "--steps", "100000", "-o", folder]
    with started(program(*words), stderr=subprocess.PIPE) as process:
        until = time.monotonic() + 60
        while not (folder / "sum-0003.json").exists() and time.monotonic() < until:
            time.sleep(0.01)
        process.send_signal(number)
        _, errors = process.communicate(timeout=60)
    assert (process.returncode, errors) == (128 + number, b"")
    mark, *files = sorted(folder.iterdir())
    assert mark.name == ".minkref-sweep"
    assert len(files) >= 3
    for count, path in enumerate(files, start=1):
        assert path.name == f"sum-{count:04}.json"
        assert _core.read_file(str(path)).vertices > 0
    # The next sweep recognises the folder by the mark, and replaces its contents.
    once = ("sweep", "g1", "g2", "--from", "1", "--steps", "1", "-o", folder)
    assert minkref(*once).code == 0
    assert sorted(path.name for path in folder.iterdir()) == ["index.json", "sum-0001.json"]


@pytest.mark.parametrize("index", range(draws(4, 12)))
def test_random_pairs_by_the_route_dynamic_and_by_paper(
    minkref: Minkref, tmp_path: Path, index: int
) -> None:
    pair = random_pair(5, index)
    names = []
    for name, text in (("P", pair.P), ("Q", pair.Q)):
        path = tmp_path / f"{name}.json"
        path.write_text(text, encoding="utf-8")
        names.append(path)
    P, Q = (_core.read_file(str(path)) for path in names)
    events = [row[0] for row in _core.pair_events(P, Q, "1/4", "4").rows(0, 1000)]
    for scale in {pair.scale, *events[:: max(1, len(events) // 4)]}:
        one, other = (
            minkref("sum", *names, "--scale", scale, "--route", route, "--json").json
            for route in ("paper", "dynamic")
        )
        jsonschema.validate(other, schema("sum"))
        for name in ("digest", "area", "components", "holes", "vertices", "result",
                     "tight_passages"):  # fmt: skip
            assert one[name] == other[name], (scale, name)


@pytest.mark.parametrize("scale", ["1/3", "1", "541/186"])
def test_models_by_the_route_dynamic_and_by_paper(minkref: Minkref, scale: str) -> None:
    for P, Q in (("g1", "g2"), ("dog145", "g3"), ("disc1", "glyph275")):
        one, other = (
            minkref("sum", P, Q, "--scale", scale, "--route", route, "--json").json
            for route in ("paper", "dynamic")
        )
        assert (one["digest"], one["tight_passages"]) == (other["digest"], other["tight_passages"])
    assert other["signs"] is None
    assert Fraction(other["area"]) > 0


@pytest.mark.parametrize(
    "files",
    [
        {"index.json": '{"name": "a site"}', "sum-0001.json": "precious"},
        {"index.json": '{"name": "a site"}'},
        {"sum-0001.json": "precious"},
        {"index.json": '{"command": "sweep"}'},
        {"sum-0001.json/inside": "precious"},
    ],
    ids=str,
)
def test_files_of_others_survive_whatever_they_are_called(
    minkref: Minkref, tmp_path: Path, files: dict[str, str]
) -> None:
    for name, text in files.items():
        path = tmp_path / "sums" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    ran = minkref("sweep", "g1", "g2", "--from", "1", "--steps", "1", "-o", tmp_path / "sums")
    assert ran.code == 2 and "files of others" in ran.err
    for name, text in files.items():
        assert (tmp_path / "sums" / name).read_text(encoding="utf-8") == text


def test_an_operand_in_the_folder_survives(minkref: Minkref, tmp_path: Path) -> None:
    folder = tmp_path / "sums"
    once = ("--from", "1", "--steps", "1", "-o", folder)
    assert minkref("sweep", "g1", "g2", *once).code == 0
    operand = folder / "sum-0001.json"
    before = operand.read_bytes()
    ran = minkref("sweep", operand, "g2", *once)
    assert ran.code == 2 and "operand" in ran.err
    assert operand.read_bytes() == before
    assert minkref("sweep", "g1", "g2", *once).code == 0
