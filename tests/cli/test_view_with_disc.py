"""`minkref view P disc`: the document, the page and its data, refusals."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from disc_page_decoder import DiscDecoder
from minkref import _core
from minkref.disc.page import picture
from minkref.plane.operand import read_operand
from minkref.reports.evidence.pages.disc_rings import ring_difference, true_rings
from minkref.schemas import result_schema, schema
from page_decoder import data_of

Minkref = Callable[..., Any]

FRAME = "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 2 6, 6 6, 6 2, 2 2))"
TWO = "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((4 0, 6 0, 6 2, 4 2, 4 0)))"
ISLAND = (
    "MULTIPOLYGON (((0 0, 90 0, 90 80, 0 80, 0 0), (10 10, 10 70, 80 70, 80 10, 10 10)), "
    "((30 30, 40 33, 35 45, 30 30)))"
)
FAR = "POLYGON ((1e6 1e6, 1000004 1e6, 1000001 1000001, 1e6 1000004, 1e6 1e6))"
SHAPES = ("g1", "g3", "glyph275", FRAME, TWO, ISLAND, FAR, "POINT (1 2)", "LINESTRING (0 0, 3 1)")


def page_of(minkref: Minkref, folder: Path, P: str, *options: str) -> tuple[dict[str, Any], str]:
    page = folder / "page.html"
    ran = minkref("view", P, "disc", "-o", page, *options)
    assert (ran.code, ran.err) == (0, "")
    text = page.read_text(encoding="utf-8")
    return data_of(text), text


def test_the_document_follows_the_published_schema(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    ran = minkref("view", "g1", "disc", "-o", page, "--json")
    assert (ran.code, ran.err) == (0, "")
    jsonschema.validate(ran.json, result_schema("view_with_disc"))
    jsonschema.validate(ran.json, schema("view"))
    assert ran.json["bytes"] == page.stat().st_size
    found = _core.diagram_events(read_operand("g1").set)
    kinds = found.kinds()
    assert ran.json["events"] == {kind: kinds.count(kind) for kind in ran.json["events"]}
    index = _core.disc_index(read_operand("g1").set)
    assert ran.json["radii_of_events"] == len(index)
    assert ran.json["holes"] == len(index.holes())


def test_the_page_has_every_event_with_its_features(minkref: Minkref, tmp_path: Path) -> None:
    data, _ = page_of(minkref, tmp_path, "glyph275")
    rows = _core.diagram_events(read_operand("glyph275").set).rows(0, 10**6)
    assert len(rows) == len(data["kinds"]) > 100
    for event, (kind, _, _, (low, high), place, features) in enumerate(rows):
        assert data["kinds"][event] == kind[0]
        assert low <= data["radii"][data["numbers"][event] - 1] <= high
        at = [data["places"][2 * event + k] + data["origin"][k] for k in (0, 1)]
        assert at == list(place)
        near = [data["features"][number] for number in data["near"][event]]
        assert len(near) == len(features)
        for got, (name, first, second) in zip(near, features, strict=True):
            if name == "edge":
                assert got[2:] == [int(first), int(second)]
                continue
            vertex = [got[k] + data["origin"][k] for k in (0, 1)]
            assert vertex == [float(Fraction(first)), float(Fraction(second))]


@pytest.mark.parametrize("shape", SHAPES)
def test_rings_and_counts_read_from_the_data_are_those_of_the_sum(
    minkref: Minkref, tmp_path: Path, shape: str
) -> None:
    data, _ = page_of(minkref, tmp_path, shape)
    decoder, P = DiscDecoder(data), read_operand(shape).set
    print("seed 2012")
    dice = random.Random(2012)
    ends = [about for _, about in data["window"]]
    near = [
        dice.choice(data["radii"]) * dice.uniform(0.9, 1.2)
        for _ in range(12 if data["radii"] else 0)
    ]
    for radius in (*ends, *near):
        offset = _core.offset(P, str(Fraction(radius) ** 2))
        assert ring_difference(decoder.rings(radius), true_rings(P, radius)) < 1e-9, radius
        assert decoder.counts(radius) == (offset.components, offset.holes), radius


def test_holes_are_named_with_birth_and_end(minkref: Minkref, tmp_path: Path) -> None:
    data, _ = page_of(minkref, tmp_path, FRAME)
    (hole,) = data["holes"]
    birth, end, born_at, ends_at, origin = hole
    assert (birth, born_at, origin) == (0, None, 0)
    assert data["radii"][end - 1] == 2
    place = [data["places"][2 * ends_at + k] + data["origin"][k] for k in (0, 1)]
    assert place == [4, 4]


def test_components_join_at_the_radius_at_which_edges_face_each_other(
    minkref: Minkref, tmp_path: Path
) -> None:
    data, _ = page_of(minkref, tmp_path, TWO)
    ((number, at_radius, _, *polygons),) = data["joins"]
    assert data["radii"][number - 1] == 1
    assert (at_radius, sorted(polygons)) == (1, [0, 1])


def test_a_window_bounds_the_events_exactly(minkref: Minkref, tmp_path: Path) -> None:
    data, _ = page_of(minkref, tmp_path, FRAME, "--from", "1", "--to", "2")
    assert data["window"] == [["1", 1.0], ["2", 2.0]]
    assert data["inside"] == [0, 1]
    data, _ = page_of(minkref, tmp_path, FRAME, "--from", "2", "--to", "3")
    assert data["inside"] == [0, 1]
    data, _ = page_of(minkref, tmp_path, FRAME, "--from", "1", "--to", "199/100")
    assert data["inside"] == [0, 0]
    data, _ = page_of(minkref, tmp_path, FRAME, "--from", "50")
    assert data["window"] == [["50", 50.0], ["500", 500.0]]


def test_the_page_needs_nothing_else(minkref: Minkref, tmp_path: Path) -> None:
    name = tmp_path / "<b onclick=x>&.wkt"
    name.write_text(FRAME, encoding="utf-8")
    _, text = page_of(minkref, tmp_path, str(name))
    assert "default-src 'none'" in text
    assert set(re.findall(r"https?://[^\s\"'`<>)]*", text)) <= {"http://www.w3.org/2000/svg"}
    assert not re.search(r"<link|<img|<iframe|src=|@import|fetch\(", text)
    assert "<b onclick" not in text
    assert "&lt;b onclick=x&gt;&amp;.wkt" in text


def test_an_empty_operand_gives_a_page_of_an_empty_sum(minkref: Minkref, tmp_path: Path) -> None:
    data, _ = page_of(minkref, tmp_path, "POLYGON EMPTY")
    assert (data["sides"], data["point"]) == ([], None)
    assert DiscDecoder(data).rings(1.0) == []


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("disc", "g1"), "minkref view P disc"),
        (("g1", "disc:2"), "minkref view P disc"),
        (("disc", "disc"), "minkref view P disc"),
        (("g1", "disc", "--route", "dynamic"), "--route"),
        (("g1", "disc", "--scale", "2"), "--scale"),
        (("g1", "disc", "--index", "x"), "cannot be read"),
        (("g1", "disc", "--from", "0"), "zero"),
        (("g1", "disc", "--from", "2", "--to", "1"), "empty or a single radius"),
        (("g1", "disc", "--from", "1", "--to", "1.0000000000001"), "too narrow"),
        (("g1", "disc", "--to", "1e999"), "beyond the range of doubles"),
        (("g1", "disc", "--from", "1e-999"), "too small"),
        (("g1", "disc", "-o", "page.svg"), "ending"),
        (("POLYGON((0 0,1e400 0,0 1e400,0 0))", "disc"), "beyond the range of doubles"),
    ],
)
def test_refusals(
    minkref: Minkref,
    arguments: tuple[str, ...],
    said: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = minkref("view", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert said in ran.err
    assert "fix:" in ran.err
    assert list(tmp_path.glob("*.html")) == []


def test_a_diagram_too_large_for_a_page_is_refused(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(picture, "MOST_PARTS", 10)
    ran = minkref("view", "g1", "disc", "-o", tmp_path / "page.html")
    assert ran.code == 2
    assert "a page holds 10" in ran.err


def test_the_page_names_the_edge_that_is_nearest_of_those_on_one_line(
    minkref: Minkref, tmp_path: Path
) -> None:
    comb = (
        "POLYGON ((0 0, 9 0, 9 4, 8 4, 8 1, 7 1, 7 4, 6 4, 6 2, 3 2, 3 4, 2 4, 2 2, 1 2, "
        "1 4, 0 4, 0 0))"
    )
    data, _ = page_of(minkref, tmp_path, comb)
    lines = sum(len(feature) == 4 for feature in data["features"])
    rows = _core.diagram_events(read_operand(comb).set).rows(0, 10**6)
    for near, row in zip(data["near"], rows, strict=True):
        edges = [data["features"][k] for k in near if len(data["features"][k]) > 2]
        names = [(int(ring), int(k)) for kind, ring, k in row[5] if kind == "edge"]
        assert [tuple(edge[2:4]) for edge in edges] == names
    (further,) = [feature for feature in data["features"] if feature[2:4] == [0, 12]]
    assert lines < len(data["features"]) and len(data["features"][further[4]]) == 4
