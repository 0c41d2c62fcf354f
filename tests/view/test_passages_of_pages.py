"""Pages and pictures show tight passages: passages have no area, so nothing else shows them."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from minkref.cli.cli import run
from minkref.reports.evidence.framework.browser import Browser, absent
from page_decoder import data_of

#: A unit square in a corridor of width 1 and in a hole of side 1.
SQUARE = "POLYGON((0 0,1 0,1 1,0 1,0 0))"
WALLS = "POLYGON((-9 -9,19 -9,19 9,-9 9,-9 -9),(0 0,0 1,10 1,10 0,0 0),(0 4,0 5,1 5,1 4,0 4))"
SLOT = "POLYGON((-9 -9,19 -9,19 9,-9 9,-9 -9),(0 0,0 2,10 2,10 0,0 0))"


def page(path: Path, *arguments: str) -> dict[str, Any]:
    assert run(["view", *arguments, "-o", str(path), "--json"]) == 0
    return data_of(path.read_text(encoding="utf-8"))


def test_the_page_of_the_plane_has_the_passages_of_each_event(tmp_path: Path) -> None:
    data = page(tmp_path / "v.html", SQUARE, WALLS, "--from", "1/2", "--to", "2")
    at = str(data["scales"].index("1"))
    assert data["passages"] == {at: [[1, 1, 10, 1], [1, 5]]}


def test_the_page_of_a_disc_has_those_of_each_ridge(tmp_path: Path) -> None:
    data = page(tmp_path / "d.html", SLOT, "disc", "--from", "1/2", "--to", "2")
    (passages,) = data["passages"].values()
    x, y = data["origin"]
    assert passages == [[1 - x, 1 - y, 9 - x, 1 - y]]


@pytest.mark.parametrize(("Q", "drawn"), [(WALLS, 2), (SQUARE, 0)])
def test_the_picture_of_a_sum_has_them(tmp_path: Path, Q: str, drawn: int) -> None:
    path = tmp_path / "sum.svg"
    assert run(["sum", SQUARE, Q, "-o", str(path)]) == 0
    text = path.read_text(encoding="utf-8")
    assert len(re.findall('class="tight"', text)) == drawn
    assert ("2 tight passages" in text) == bool(drawn)


def test_the_picture_of_a_sum_with_a_disc_has_them(tmp_path: Path) -> None:
    path = tmp_path / "sum.svg"
    assert run(["sum", SLOT, "disc:1", "-o", str(path)]) == 0
    assert 'class="tight"' in path.read_text(encoding="utf-8")


@pytest.mark.skipif(absent() is not None, reason=f"no browser: {absent()}")
def test_pages_draw_them_and_open_at_their_top(window: Browser, tmp_path: Path) -> None:
    """The page of a path opened scrolled to its list, and cut its last column, on a telephone."""
    files = {
        "plane": (SQUARE, WALLS, "--from", "1/2", "--to", "2"),
        "disc": (SLOT, "disc"),
        "path": (SQUARE, WALLS, "--path", "LINESTRING (1 1, 9 1)"),
    }
    made = {name: page(tmp_path / f"{name}.html", *words) for name, words in files.items()}
    go = {
        "plane": lambda: f"goToEvent({made['plane']['scales'].index('1')})",
        "disc": lambda: "goToRadius(0)",
    }
    drawn = "return new Promise((done) => setTimeout(done, 300))"
    window.viewport(390, 844)
    for name in files:
        window.open(tmp_path / f"{name}.html")
        window.run(drawn)
        assert window.run("return window.scrollY") == 0, name
        wide = "const box = document.getElementById('events');"
        assert window.run(f"{wide} return box.scrollWidth <= box.clientWidth"), name
        assert window.run("return document.documentElement.scrollWidth") <= 390, name
        if name in go:
            window.run(f"window.minkref.{go[name]()}; {drawn}")
            assert window.run("return window.minkref.passages.length") > 0, name
            assert not window.run("return document.getElementById('key-tight').hidden"), name
        assert window.messages() == []
