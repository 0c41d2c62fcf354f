"""`minkref convolution`, in the plane."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import _core
from minkref.plane.commands import convolution as command
from minkref.plane.operand import read_operand
from minkref.schemas import schema

Minkref = Callable[..., Any]
SVG = "{http://www.w3.org/2000/svg}"
DENTED = "POLYGON ((0 0, 4 0, 4 4, 2 1, 0 4, 0 0))"
TRIANGLE = "POLYGON ((0 0, 1 0, 0 1, 0 0))"


@pytest.mark.parametrize("more", [(), ("--full",), ("--compatible", "open")])
def test_the_document_has_every_edge_with_its_parents(
    minkref: Minkref, more: tuple[str, ...]
) -> None:
    ran = minkref("convolution", "g1", "g2", "--scale", "7/5", *more, "--json")
    assert (ran.code, ran.err) == (0, "")
    value = ran.json
    jsonschema.validate(value, schema("convolution"))
    P, Q = (read_operand(name).set for name in ("g1", "g2"))
    rows = _core.full_convolution(P, Q) if "--full" in more else _core.reduced_convolution(P, Q)
    told = [(e["kind"], e["sign"], *e["edge"], *e["vertex"]) for e in value["edges"]]
    if "--compatible" in more:
        assert set(told) <= set(rows)
    else:
        assert told == rows
    kinds = {kind: sum(row[0] == kind for row in told) for kind in "ST"}
    assert (value["count"], value["segments"]) == (len(told), kinds)
    assert value["negative"] == sum(row[1] < 0 for row in told)
    assert (value["negative"] > 0) == ("--full" in more)


def test_two_parallel_edges_by_hand(minkref: Minkref) -> None:
    """The bottom sides: Q's side begins at the start of 2 P's side, which follows Q's."""
    outer = [["10", "1/3"], ["11", "1/3"], ["10", "2"]]
    Q = json.dumps({"polygons": [{"holes": [], "outer": outer}]})
    edges = minkref("convolution", TRIANGLE, Q, "--scale", "2", "--json").json["edges"]
    assert [edge for edge in edges if edge["edge"] == [0, 0]] == [
        {
            "kind": "S", "edge": [0, 0], "vertex": [0, 1], "sign": 1,
            "start": ["11", "1/3"], "end": ["13", "1/3"], "direction": ["2", "0"],
        },
        {
            "kind": "T", "edge": [0, 0], "vertex": [0, 0], "sign": 1,
            "start": ["10", "1/3"], "end": ["11", "1/3"], "direction": ["1", "0"],
        },
    ]  # fmt: skip


def test_two_squares_by_each_reading(minkref: Minkref, squares: tuple[Path, Path]) -> None:
    for compatible, count in (("half-open", 8), ("open", 0), ("closed", 16)):
        value = minkref("convolution", *squares, "--compatible", compatible, "--json").json
        jsonschema.validate(value, schema("convolution"))
        assert (value["compatible"], value["count"], len(value["edges"])) == (
            compatible, count, count,
        )  # fmt: skip


def test_people_see_a_table(minkref: Minkref) -> None:
    ran = minkref("convolution", DENTED, TRIANGLE, "--full")
    assert (ran.code, ran.err) == (0, "")
    assert "full, half-open" in ran.out
    assert "of the sign -1" in ran.out
    assert "more: --json or -o FILE gives all" not in ran.out
    ran = minkref("convolution", "g1", "g2", "--limit", "3")
    assert "more: --json or -o FILE gives all" in ran.out


def test_a_file_holds_the_document(minkref: Minkref, tmp_path: Path) -> None:
    path = tmp_path / "edges.json"
    ran = minkref("convolution", "g1", "g2", "-o", path, "--json")
    printed, written = ran.json, json.loads(path.read_text())
    jsonschema.validate(printed, schema("convolution"))
    jsonschema.validate(written, schema("convolution"))
    assert printed["edges"] is None and len(written["edges"]) == written["count"]
    assert (printed["output"], printed["output_exact"]) == (str(path), True)
    on_output = minkref("convolution", "g1", "g2", "-o", "-").json
    assert on_output["edges"] == written["edges"]


@pytest.mark.parametrize(("scale", "exact"), [("5/4", True), ("1/3", False)])
def test_geojson_has_a_line_for_each_edge(
    minkref: Minkref, tmp_path: Path, scale: str, exact: bool
) -> None:
    path = tmp_path / "edges.geojson"
    words = ("convolution", DENTED, TRIANGLE, "--scale", scale, "--full")
    ran = minkref(*words, "-o", path, "--json")
    assert (ran.code, ran.json["output_exact"]) == (0, exact)
    edges = minkref(*words, "--json").json["edges"]
    collection = json.loads(path.read_text(), parse_float=str, parse_int=str)
    assert collection["type"] == "FeatureCollection"
    assert len(collection["features"]) == len(edges) > 0
    for feature, edge in zip(collection["features"], edges, strict=True):
        assert feature["geometry"]["type"] == "LineString"
        told = json.loads(json.dumps(edge), parse_int=str)
        assert feature["properties"] == told
        for at, end in zip(feature["geometry"]["coordinates"], ("start", "end"), strict=True):
            numbers = [_number(text) for text in edge[end]]
            assert [float(text) for text in at] == numbers
    told = minkref(*words, "-o", "-", "--format", "geojson")
    assert told.out == path.read_text()
    assert ("rounded" in told.err) == (not exact)


def _number(text: str) -> float:
    above, _, below = text.partition("/")
    return int(above) / int(below or 1)


def test_an_empty_convolution_is_written_too(minkref: Minkref, tmp_path: Path) -> None:
    for form in ("json", "geojson", "svg"):
        ran = minkref("convolution", "POLYGON EMPTY", "g1", "-o", "-", "--format", form)
        assert (ran.code, ran.err) == (0, "")
        if form == "svg":
            assert "the empty set" in ran.out
        else:
            document = json.loads(ran.out)
            assert document["edges" if form == "json" else "features"] == []


def panes(text: str) -> tuple[list[str], list[list[tuple[str, str]]]]:
    """The captions, and the classes and data of each picture's paths."""
    root = ElementTree.fromstring(text)
    captions = [str(node.text) for node in root.findall(f"{SVG}text")]
    pictures = [
        [(path.get("class", ""), path.get("d", "")) for path in inner.iter(f"{SVG}path")]
        for inner in root.iter(f"{SVG}svg")
        if inner is not root
    ]
    return captions, pictures


@pytest.mark.parametrize("unit", ["", "e400", "e-400"])
def test_a_picture_has_s_and_t_edges_in_styles_of_their_own(minkref: Minkref, unit: str) -> None:
    P = f"POLYGON ((0 0, 4{unit} 0, 4{unit} 4{unit}, 2{unit} 1{unit}, 0 4{unit}, 0 0))"
    Q = f"POLYGON ((0 0, 1{unit} 0, 0 1{unit}, 0 0))"
    ran = minkref("convolution", P, Q, "--scale", "3/2", "--full", "-o", "-", "--format", "svg")
    assert (ran.code, ran.err) == (0, "")
    edges = minkref("convolution", P, Q, "--scale", "3/2", "--full", "--json").json["edges"]
    captions, pictures = panes(ran.out)
    counts = {kind: sum(edge["kind"] == kind for edge in edges) for kind in "ST"}
    assert f"S-edges, solid: {counts['S']}; T-edges, dashed: {counts['T']}" in captions
    assert "full convolution" in captions
    assert len(pictures) == 3
    drawn = {style: data.count("M") for style, data in pictures[2] if "head" not in style}
    expected = {
        kind + (" negative" if sign < 0 else ""): sum(
            (edge["kind"], edge["sign"]) == (kind, sign) for edge in edges
        )
        for kind in "ST"
        for sign in (1, -1)
    }
    assert drawn == {style: count for style, count in expected.items() if count}
    assert any(style == "S head" and data for style, data in pictures[2])
    assert "dasharray" in ran.out


def test_a_picture_of_too_many_edges_is_refused_and_of_the_first_is_drawn(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(command, "MOST_DRAWN", 20)
    path = tmp_path / "edges.svg"
    ran = minkref("convolution", "g1", "g2", "-o", path, "--json")
    assert (ran.code, ran.json["error"]["code"]) == (2, "limit")
    assert "--limit 20" in ran.json["error"]["mend"]
    assert not path.exists()
    ran = minkref("convolution", "g1", "g2", "-o", path, "--limit", "20", "--json")
    assert ran.code == 0
    _, pictures = panes(path.read_text())
    assert sum(d.count("M") for style, d in pictures[2] if "head" not in style) == 20
    assert ran.json["count"] > 20


def test_a_limit_leaves_out_edges_but_counts_them(minkref: Minkref) -> None:
    whole = minkref("convolution", "g1", "g2", "--json").json
    part = minkref("convolution", "g1", "g2", "--limit", "7", "--json").json
    assert (part["count"], part["edges"]) == (whole["count"], whole["edges"][:7])
    none = minkref("convolution", "g1", "g2", "--limit", "0", "-o", "-", "--format", "geojson")
    assert json.loads(none.out)["features"] == []


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("g1", "gg1"), "no-such-model", "did you mean g1?"),
        (("missing.wkt", "g1"), "no-such-file", "missing.wkt"),
        (("POINT (0 0)", "POINT (1 1)"), "degenerate-operands", "POINT"),
        (("POLYGON ((0 0, 1 1, 1 0, 0 1, 0 0))", "g1"), "self-intersection", ""),
        (("g1", "gs3"), "mixed-dimensions", "gs3"),
        (("g1", "g2", "--scale", "0"), "scale-zero", "--scale 0"),
        (("g1", "g2", "--scale", "-7/5"), "scale-negative", "--scale -7/5"),
        (("g1", "g2", "--scale", "nan"), "scale-not-finite", "--scale nan"),
        (("g1", "g2", "--scale", "x"), "scale-not-a-number", "--scale x"),
        (("g1", "g2", "--scale", "1,2,3"), "scale-not-uniform", "--scale 1,2,3"),
        (("g1", "g2", "--compatible", "opn"), "usage", "did you mean open?"),
        (("g1", "g2", "--limit", "-1"), "usage", "--limit -1"),
        (("g1", "g2", "--format", "svg"), "usage", "nothing to write"),
        (("g1", "g2", "-o", "it.wkt"), "usage", ".wkt"),
        (("g1", "g2", "-o", "it.svg", "--format", "wkt"), "usage", "no such format"),
        (
            ("g1", "g2", "-o", "none/it.svg"),
            "cannot-write",
            "folder of the output file does not exist",
        ),
        (("g1", "g2", "-o", "-", "--json"), "usage", "not both"),
    ],
)
def test_misuse_is_refused_and_nothing_written(
    minkref: Minkref,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    words: tuple[str, ...],
    code: str,
    said: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = minkref("convolution", *words, "--json")
    assert (ran.code, ran.json["error"]["code"]) == (2, code)
    assert said in json.dumps(ran.json["error"])
    jsonschema.validate(ran.json, schema("convolution"))
    assert list(tmp_path.iterdir()) == []


def test_the_file_of_an_operand_is_kept(minkref: Minkref, tmp_path: Path) -> None:
    path = tmp_path / "P.geojson"
    text = _core.write(read_operand("g1").set, "geojson")
    path.write_text(text)
    ran = minkref("convolution", path, "g2", "-o", path, "--json")
    assert (ran.code, ran.json["error"]["code"]) == (2, "cannot-write")
    assert path.read_text() == text


@pytest.mark.parametrize("output", ["it.geojson", "-"])
def test_coordinates_beyond_doubles_are_refused_in_geojson_before_a_letter_is_written(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, output: str
) -> None:
    monkeypatch.chdir(tmp_path)
    large = "POLYGON ((0 0, 1e400 0, 0 1e400, 0 0))"
    words = ("convolution", large, large, "--scale", "1/3", "-o", output, "--format", "geojson")
    ran = minkref(*words)
    assert (ran.code, ran.out) == (2, "")
    assert "json" in ran.err or "double" in ran.err
    assert list(tmp_path.iterdir()) == []
