"""`minkref view P --features`: the document, the page and its data, refusals."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.disc.features import Features
from minkref.plane.operand import read_operand
from minkref.schemas import result_schema, schema
from page_decoder import data_of

Minkref = Callable[..., Any]
U = "POLYGON ((0 0, 6 0, 6 6, 4 6, 4 1, 2 1, 2 6, 0 6, 0 0))"


def test_the_document_follows_the_published_schema(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    ran = minkref("view", "g1", "--features", "-o", page, "--json")
    assert (ran.code, ran.err) == (0, "")
    jsonschema.validate(ran.json, result_schema("view_of_features"))
    jsonschema.validate(ran.json, schema("view"))
    assert ran.json["bytes"] == page.stat().st_size
    found = Features(read_operand("g1").set)
    assert ran.json["bars"] == len(found.bars)
    assert ran.json["nodes"] == len(found.tree)
    assert ran.json["features"] is True


def test_the_page_is_small_and_needs_nothing_else(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    assert minkref("view", "glyph275", "--features", "-o", page).code == 0
    text = page.read_text(encoding="utf-8")
    assert page.stat().st_size < 500_000
    assert "default-src 'none'" in text
    for outside in ("<link", "src=", "@import", "fetch(", "https:"):
        assert outside not in text


def test_the_window_is_one_of_diameters(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    ran = minkref("view", U, "--features", "--from", "1/2", "--to", "3", "-o", page, "--json")
    assert (ran.json["from"], ran.json["to"]) == ("1/2", "3")
    data = data_of(page.read_text(encoding="utf-8"))
    assert data["window"] == [["1/4", 0.25], ["3/2", 1.5]]
    first, end = data["inside"]
    assert [radius for radius in data["radii"] if 0.25 <= radius <= 1.5] == data["radii"][first:end]


def test_every_node_of_the_tree_has_one_bar_but_for_roots(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    minkref("view", "glyph275", "--features", "-o", page)
    data = data_of(page.read_text(encoding="utf-8"))
    passed: list[int] = []
    for leaf, birth, death, end, _ in data["bars"]:
        node = leaf
        while node != end:
            passed.append(node)
            assert birth <= data["tree"][node][1] < death
            node = data["tree"][node][2]
    roots = [k for k, (_, _, parent) in enumerate(data["tree"]) if parent is None]
    assert sorted(passed + roots) == list(range(len(data["tree"])))
    numbers = data["numbers"]
    assert all(data["tree"][t][1] <= numbers[k] for k, t in enumerate(data["owners"]))


def test_an_index_gives_the_same_page(minkref: Minkref, tmp_path: Path) -> None:
    index, page, other = (tmp_path / name for name in ("P.json", "page.html", "other.html"))
    assert minkref("index", "g1", "disc", "-o", index).code == 0
    assert minkref("view", "g1", "--features", "-o", page).code == 0
    assert minkref("view", "g1", "--features", "--index", index, "-o", other).code == 0
    assert page.read_text(encoding="utf-8") == other.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "code", "told"),
    [
        (["g1", "disc", "--features"], "usage", "give P alone"),
        (["g1", "g2", "--features"], "usage", "give P alone"),
        (["g1", "--features", "--erode"], "usage", "with --features"),
        (["g1", "--features", "--from", "2", "--to", "1"], "empty-window", "from 2 to 1"),
    ],
)
def test_refusals(minkref: Minkref, tmp_path: Path, words: list[str], code: str, told: str) -> None:
    page = tmp_path / "page.html"
    ran = minkref("view", *words, "-o", page, "--json")
    assert ran.code == 2
    assert ran.json["error"]["code"] == code
    assert told in " ".join(map(str, ran.json["error"].values()))
    assert not page.exists()


@pytest.mark.parametrize("member", ["schema", "robot", "copies"])
def test_an_operand_with_a_member_of_a_scene_is_an_operand(
    minkref: Minkref, tmp_path: Path, member: str
) -> None:
    """GeoJSON may have more members; readers leave them out."""
    ring = [[0, 0], [9, 0], [9, 9], [5, 2], [0, 9], [0, 0]]
    P = tmp_path / "set.json"
    P.write_text(json.dumps({"type": "Polygon", "coordinates": [ring], member: []}))
    ran = minkref("view", P, "--features", "-o", tmp_path / "page.html")
    assert (ran.code, ran.err) == (0, "")
