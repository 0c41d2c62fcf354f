"""`minkref view`: the document, the file, refusals, degenerate operands."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.reports.evidence.pages.view import difference, true_polygons
from minkref.schemas import result_schema
from page_decoder import Decoder, data_of

Minkref = Callable[..., Any]


def page_data(path: Path) -> dict[str, Any]:
    return data_of(path.read_text(encoding="utf-8"))


def test_document_follows_the_published_schema(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    ran = minkref("view", "g1", "g2", "-o", page, "--json")
    assert (ran.code, ran.err) == (0, "")
    jsonschema.validate(ran.json, result_schema("view"))
    data = page_data(page)
    assert ran.json["bytes"] == page.stat().st_size
    assert ran.json["boundary_events"] == len(data["scales"]) > 100
    assert ran.json["topology_events"] == len(data["topology"]) > 0
    assert ran.json["holes"] == len(data["holes"]) - 1
    assert ran.json["segments"] == {"S": len(data["S"]) // 2, "T": len(data["T"]) // 2}
    assert (ran.json["from"], ran.json["to"]) == ("1/10", "10")


def test_the_page_is_view_html_unless_named(
    minkref: Minkref, squares: tuple[Path, Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = minkref("view", *squares)
    assert (ran.code, ran.err) == (0, "")
    assert "view.html" in ran.out
    assert sorted(path.name for path in tmp_path.glob("*.html")) == ["view.html"]


def test_the_page_needs_nothing_else(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    assert minkref("view", "g1", "g2", "-o", page).code == 0
    text = page.read_text(encoding="utf-8")
    assert "default-src 'none'" in text
    links = re.findall(r"https?://[^\s\"'`<>)]*", text)
    assert set(links) <= {"http://www.w3.org/2000/svg"}  # a name, never fetched
    assert not re.search(r"<link|<img|<iframe|src=|@import|fetch\(", text)


def test_names_of_files_are_texts(minkref: Minkref, tmp_path: Path) -> None:
    name = tmp_path / "<b onclick=x>&.wkt"
    name.write_text("POLYGON((0 0,2 0,2 2,0 2,0 0))", encoding="utf-8")
    page = tmp_path / "page.html"
    assert minkref("view", name, name, "-o", page).code == 0
    text = page.read_text(encoding="utf-8")
    assert "<b onclick" not in text
    assert "&lt;b onclick=x&gt;&amp;.wkt" in text


@pytest.mark.parametrize(
    ("options", "word"),
    [
        (["--from", "0"], "zero"),
        (["--from", "2", "--to", "1"], "empty or a single scale"),
        (["--from", "1", "--to", "1"], "empty or a single scale"),
        (["--to", "x"], "not a number"),
        (["--to", "1e999"], "beyond the range of doubles"),
        (["--from", "1e-999"], "too small"),
        (["--from", "1", "--to", "1.0000000000001"], "too narrow"),
        (["-o", "page.svg"], "ending"),
        (["-o", "no/such/folder/page.html"], "does not exist"),
    ],
)
def test_a_bad_option_is_refused_with_a_mend(
    minkref: Minkref,
    squares: tuple[Path, Path],
    options: list[str],
    word: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = minkref("view", *squares, *options)
    assert (ran.code, ran.out) == (2, "")
    assert word in ran.err
    assert "fix:" in ran.err
    assert list(tmp_path.glob("*.html")) == []


def test_coordinates_beyond_doubles_are_refused(minkref: Minkref, tmp_path: Path) -> None:
    far = tmp_path / "far.wkt"
    far.write_text("POLYGON((0 0,1e400 0,0 1e400,0 0))", encoding="utf-8")
    ran = minkref("view", far, "g1", "-o", tmp_path / "page.html")
    assert ran.code == 2
    assert "beyond the range of doubles" in ran.err


def test_two_points_are_refused(minkref: Minkref, tmp_path: Path) -> None:
    point = tmp_path / "point.wkt"
    point.write_text("POINT(1 2)", encoding="utf-8")
    ran = minkref("view", point, point, "-o", tmp_path / "page.html")
    assert ran.code == 2
    assert not (tmp_path / "page.html").exists()


@pytest.mark.parametrize("shape", ["POINT(1 2)", "LINESTRING(0 0,3 1)"])
@pytest.mark.parametrize("first", [True, False])
def test_a_point_and_a_segment_are_operands(
    minkref: Minkref, tmp_path: Path, shape: str, first: bool
) -> None:
    from minkref.plane.operand import read_operand

    thin = tmp_path / "thin.wkt"
    thin.write_text(shape, encoding="utf-8")
    names = (str(thin), "g1") if first else ("g1", str(thin))
    page = tmp_path / "page.html"
    assert minkref("view", *names, "-o", page).code == 0
    decoded = Decoder(page_data(page))
    P, Q = (read_operand(name).set for name in names)
    for scale in (0.1234, 0.9, 5.4321):
        assert difference(decoded.polygons(scale), true_polygons(P, Q, scale)) < 1e-9


def test_an_empty_operand_gives_a_page_of_an_empty_sum(minkref: Minkref, tmp_path: Path) -> None:
    empty = tmp_path / "empty.wkt"
    empty.write_text("POLYGON EMPTY", encoding="utf-8")
    page = tmp_path / "page.html"
    ran = minkref("view", empty, "g1", "-o", page, "--json")
    assert ran.code == 0
    assert (ran.json["boundary_events"], ran.json["tracks"]) == (0, 0)
    data = page_data(page)
    assert data["states"] == [[]]
    assert Decoder(data).polygons(1.0) == []
