"""`minkref sum` in a pipe: the sum on standard output, operands as texts."""

from __future__ import annotations

import json
from pathlib import Path
from subprocess import CompletedProcess
from typing import Any

import pytest
from forked import forked
from minkref import _core

TRIANGLE = "POLYGON ((0 0, 2 0, 0 2, 0 0))"
GEOJSON = '{"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [0, 2], [0, 0]]]}'
PLAIN = '{"polygons": [{"outer": [["0", "0"], ["2", "0"], ["0", "2"]], "holes": []}]}'


def run(folder: Path, *words: str, text: str | bytes = "") -> CompletedProcess[str]:
    return forked(folder, "sum", *words, given=text.encode() if isinstance(text, str) else text)


def region(text: str, form: str) -> Any:
    """The set that a text means, in canonical form."""
    point = _core.PolygonSet.from_json('{"polygons":[{"outer":[["0","0"]],"holes":[]}]}')
    sum = _core.minkowski_sum(_core.read_text(text, form, "out"), point, "1")
    return json.loads(sum.region.canonical_json())


@pytest.mark.parametrize("form", ["wkt", "geojson", "poly", "json"])
def test_the_sum_alone_is_on_standard_output(tmp_path: Path, form: str) -> None:
    ran = run(tmp_path, "g1", "g2", "--scale", "7/5", "-o", "-", "--format", form)
    rounded = "" if form == "json" else "warning: standard output is rounded; json is exact\n"
    assert (ran.returncode, ran.stderr) == (0, rounded)
    file = tmp_path / f"sum.{form}"
    written = run(tmp_path, "g1", "g2", "--scale", "7/5", "-o", str(file), "--json")
    if form == "json":
        assert region(ran.stdout, form) == json.loads(written.stdout)["result"]
    assert ran.stdout.rstrip("\n") == file.read_text().rstrip("\n")


def test_a_picture_is_not_called_rounded(tmp_path: Path) -> None:
    ran = run(tmp_path, "g1", "g2", "-o", "-", "--format", "svg")
    assert ran.stdout.startswith("<svg") and ran.stdout.endswith("</svg>\n") and ran.stderr == ""


def test_well_known_text_unless_another_format_is_asked_for(tmp_path: Path) -> None:
    assert run(tmp_path, TRIANGLE, TRIANGLE, "-o", "-").stdout == "POLYGON ((0 0, 4 0, 0 4, 0 0))\n"


@pytest.mark.parametrize("text", [TRIANGLE, GEOJSON, PLAIN, "multipolygon (((0 0,2 0,0 2,0 0)))"])
def test_texts_are_operands(tmp_path: Path, text: str) -> None:
    for words, given in (((text, TRIANGLE), ""), (("-", TRIANGLE), text), ((TRIANGLE, "-"), text)):
        ran = run(tmp_path, *words, "-o", "-", text=given)
        assert ran.stdout == "POLYGON ((0 0, 4 0, 0 4, 0 0))\n", ran.stderr


def test_the_format_of_the_paper_on_standard_input(tmp_path: Path) -> None:
    poly = run(tmp_path, TRIANGLE, TRIANGLE, "-o", "-", "--format", "poly").stdout
    ran = run(tmp_path, "-", TRIANGLE, "-o", "-", text=poly)
    assert ran.stdout == "POLYGON ((0 0, 6 0, 0 6, 0 0))\n", ran.stderr


def test_a_file_wins_over_a_text(tmp_path: Path) -> None:
    (tmp_path / "POINT (1 1)").mkdir()
    assert run(tmp_path, "POINT (1 1)", TRIANGLE, "-o", "-").stdout.startswith("POLYGON ((1 1")


def test_a_long_text_is_no_name_of_a_file(tmp_path: Path) -> None:
    corners = ", ".join(f"{x} {x * x}" for x in range(2000))
    ran = run(tmp_path, f"POLYGON (({corners}, 0 0))", "POINT (0 0)", "--json")
    assert ran.returncode == 0 and json.loads(ran.stdout)["vertices"] == 2000


@pytest.mark.parametrize("command", ["convolution", "events", "index", "sweep", "view", "certify"])
def test_standard_input_is_one_operand_of_every_command(tmp_path: Path, command: str) -> None:
    more = {"sweep": ["--from", "1", "--to", "2", "--steps", "2"], "index": ["-o", "x.index"]}
    more["certify"] = ["-o", "x.cert.json"]
    ran = forked(tmp_path, command, "-", "-", *more.get(command, []), given=TRIANGLE.encode())
    assert ran.returncode == 2 and "it is one operand: name a file" in ran.stderr


def test_in_space(tmp_path: Path) -> None:
    ran = run(tmp_path, "gs3", "rod", "-o", "-")
    written = run(tmp_path, "gs3", "rod", "-o", "sum.data", "--format", "off")
    assert ran.stdout.startswith("OFF\n") and written.returncode == 0
    assert (tmp_path / "sum.data").read_text() == ran.stdout


@pytest.mark.parametrize(
    ("words", "text", "said"),
    [
        (("-", "-"), TRIANGLE, "standard input is one operand"),
        (("-", "g1"), "hello", "in no known format"),
        (("-", "g1"), "", "there is nothing left to read"),
        (("-", "g1"), b"\xff\xfe", "not UTF-8"),
        (("-", "g1"), "[" * 100_000, "in no known format"),
        (("POLYGON ((0 0, 1", "g1"), "", "the text ends"),
        (('{"type": "Polyg', "g1"), "", ""),
        (("g1", "g2", "-o", "-", "--json"), "", "not both"),
        (("g1", "g2", "-o", "-", "--format", "wtk"), "", "did you mean wkt?"),
        (("gs3", "rod", "-o", "-", "--format", "wkt"), "", "no such format"),
        (("g1", "g2", "--format", "wkt"), "", "nothing to write"),
        (("g1", "g2", "-o", "sum.txt"), "", "names no format"),
    ],
)
def test_what_is_refused(
    tmp_path: Path, words: tuple[str, ...], text: str | bytes, said: str
) -> None:
    ran = run(tmp_path, *words, text=text)
    assert ran.returncode == 2 and said in ran.stderr, ran.stderr
    assert "Traceback" not in ran.stderr and list(tmp_path.iterdir()) == []
