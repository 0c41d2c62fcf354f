"""`minkref erode`, `opening`, `closing`, `nofit`, `innerfit`, and `--erode`: documents, routes,
files, refusals; in the plane, with a disc and in space."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import minkref as package
import pytest
from minkref import _core
from minkref.schemas import schema
from minkref.verbs.erode_request import DISC_ROUTES, ROUTES, SPACE_ROUTES
from written_solids import cube, prism

Minkref = Callable[..., Any]
ROOMS = "POLYGON((0 0,30 0,30 9,36 9,36 0,70 0,70 30,36 30,36 19,30 19,30 30,0 30,0 0))"
BOX = "POLYGON((0 0,10 0,10 10,0 10,0 0))"
HOLED = "POLYGON((0 0,9 0,9 9,0 9,0 0),(3 3,5 3,5 5,3 5,3 3))"
SQUARE = "POLYGON((0 0,2 0,2 2,0 2,0 0))"


def test_the_document_has_the_region_and_its_remnants(minkref: Minkref) -> None:
    value = minkref("erode", ROOMS, BOX, "--json").json
    jsonschema.validate(value, schema("erode"))
    assert (value["area"], value["components"], value["holes"]) == ("880", 2, 0)
    (remnant,) = value["remnants"]
    assert remnant["points"] == [["20", "9"], ["36", "9"]]
    (contacts,) = remnant["contacts"]
    sills = [each["edge"] for each in contacts if each["kind"] == "S"]
    sides = [each["edge"] for each in contacts if each["kind"] == "T"]
    assert (sills, sides) == ([[0, 2], [0, 8]], [[0, 0], [0, 2]])  # of the door, and of the box
    assert "(20, 9) (36, 9)" in minkref("erode", ROOMS, BOX).out


@pytest.mark.parametrize("route", ROUTES)
@pytest.mark.parametrize("scale", ["1", "3/2", "1/4", "2,1"])
def test_routes_agree(minkref: Minkref, route: str, scale: str) -> None:
    words = ("erode", ROOMS, BOX, "--scale", scale, "--json")
    value, expected = minkref(*words, "--route", route).json, minkref(*words).json
    same = ("digest", "components", "holes", "remnants", "area")
    assert [value[name] for name in same] == [expected[name] for name in same]


def test_an_index_and_a_sweep_have_the_erosions(minkref: Minkref, tmp_path: Path) -> None:
    index = str(tmp_path / "rooms.index")
    value = minkref("index", ROOMS, BOX, "--erode", "-o", index, "--json").json
    jsonschema.validate(value, schema("index"))
    scales = [Fraction(k, 4) for k in (1, 2, 4, 5, 8)]
    digests = []
    for scale in scales:
        words = ("erode", ROOMS, BOX, "--scale", str(scale), "--json")
        read = minkref(*words, "--index", index).json
        assert read["route"] == "index"
        digests.append(minkref(*words).json["digest"])
        assert read["digest"] == digests[-1]
    (tmp_path / "scales.txt").write_text("\n".join(map(str, scales)))
    for route in ("index", "dynamic"):
        words = ("--scales", str(tmp_path / "scales.txt"), "--route", route, "--json")
        swept = minkref("sweep", ROOMS, BOX, "--erode", *words).json
        jsonschema.validate(swept, schema("sweep"))
        assert [row["digest"] for row in swept["rows"]] == digests
    assert minkref("erode", ROOMS, SQUARE, "--index", index).code == 2


@pytest.mark.parametrize("route", ["dynamic", "index"])
def test_events_are_those_of_the_erosion(minkref: Minkref, route: str) -> None:
    words = ("--erode", "--kind", "topology", "--route", route, "--json")
    value = minkref("events", ROOMS, BOX, *words).json
    jsonschema.validate(value, schema("events"))
    told = [(e["s"], e["feature"], e["change"], e["before"], e["after"]) for e in value["events"]]
    assert told == [
        ("1/3", "component", "birth", [], [0]),
        ("1/3", "component", "birth", [], [1]),
        ("1", "component", "merge", [0, 1], [0]),
    ]
    holed = minkref("events", HOLED, SQUARE, *words).json
    assert [life["id"] for life in holed["holes"]] == [1]
    (ring,) = [event for event in holed["events"] if event["feature"] == "hole"]
    assert (ring["s"], ring["change"], ring["before"], ring["after"]) == (
        "2/3",
        "split",
        [0],
        [0, 1],
    )


def test_parents_of_events_are_edges_of_both_operands(minkref: Minkref) -> None:
    """At the scale of a birth the named contacts meet at the place."""
    value = minkref("events", HOLED, SQUARE, "--erode", "--json").json
    P, Q = (package.read_text(text, "wkt") for text in (HOLED, SQUARE))
    rings, own = ([ring for one in each.rings() for ring in one] for each in (P, Q))
    for event in value["events"]:
        s, x = Fraction(event["s"]), [Fraction(c) for c in event["at"]]
        met = 0
        for parent in event["parents"]:
            (r, k), (t, m) = parent["edge"], parent["vertex"]
            of_P = parent["kind"] == "S"
            ring, corner = (rings[r], own[t][m]) if of_P else (own[r], rings[t][m])
            by, other = (s, -1) if of_P else (-1, s)
            a, b = (
                [by * c + other * v for c, v in zip(ring[i % len(ring)], corner, strict=True)]
                for i in (k, k + 1)
            )
            cross = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0])
            met += cross == 0
        assert met, event  # others come to other places of the same scale


@pytest.mark.parametrize("form", ["wkt", "geojson", "poly", "json", "svg"])
def test_regions_are_written(minkref: Minkref, tmp_path: Path, form: str) -> None:
    file = tmp_path / f"places.{form}"
    assert minkref("erode", ROOMS, BOX, "-o", str(file)).code == 0
    if form == "svg":
        assert "2 components" in file.read_text() and "1 remnant" in file.read_text()
    else:
        assert package.read_file(file).area() == "880"
    assert minkref("erode", ROOMS, BOX, "-o", "-", "--format", form).out.strip()


def test_opening_and_closing(minkref: Minkref) -> None:
    opened = minkref("opening", ROOMS, BOX, "--json").json
    closed = minkref("closing", ROOMS, BOX, "--json").json
    for value in (opened, closed):
        jsonschema.validate(value, schema(value["command"]))
    assert (opened["area"], opened["components"]) == (str(30 * 30 + 34 * 30 + 60), 1)
    assert Fraction(closed["area"]) > Fraction(opened["area"])
    chord = minkref("opening", "POLYGON((0 -2,2 0,0 2,-2 0,0 -2))", "LINESTRING(0 0,4 0)", "--json")
    assert chord.json["remnants"] == [{"points": [["-2", "0"], ["2", "0"]], "contacts": [[]]}]
    jsonschema.validate(chord.json, schema("opening"))


def test_no_fit_and_inner_fit(minkref: Minkref) -> None:
    no_fit = minkref("nofit", HOLED, SQUARE, "--json").json
    jsonschema.validate(no_fit, schema("nofit"))
    assert (no_fit["A"], no_fit["area"], no_fit["holes"]) == (HOLED, "121", 0)
    assert [fit["points"] for fit in no_fit["exact_fits"]] == [[["3", "3"]]]
    inner = minkref("innerfit", ROOMS, BOX, "--json").json
    jsonschema.validate(inner, schema("innerfit"))
    assert (inner["part"], inner["area"]) == (BOX, "880")
    assert inner["digest"] == minkref("erode", ROOMS, BOX, "--json").json["digest"]


@pytest.mark.parametrize("route", DISC_ROUTES)
def test_the_inset_of_a_disc(minkref: Minkref, route: str, tmp_path: Path) -> None:
    value = minkref("erode", ROOMS, "disc:5", "--route", route, "--json").json
    jsonschema.validate(value, schema("erode"))
    assert (value["components"], value["holes"], value["result"]["inward"]) == (2, 0, True)
    assert [one["points"] for one in value["remnants"]] == [[["30", "14"], ["36", "14"]]]
    square = minkref("erode", "POLYGON((0 0,9 0,9 9,0 9,0 0))", "disc:1", "--json").json
    assert square["area"] == {"low": 49.0, "high": 49.0}
    assert square["length"] == {"low": 28.0, "high": 28.0}
    for form in ("svg", "json"):
        file = tmp_path / f"inset.{form}"
        assert minkref("erode", ROOMS, "disc:4", "-o", str(file)).code == 0
        assert file.read_text()
    polygon = tmp_path / "inset.wkt"
    minkref("erode", ROOMS, "disc:4", "--tolerance", "1/100", "-o", str(polygon))
    area = Fraction(package.read_file(polygon).area())
    whole = minkref("erode", ROOMS, "disc:4", "--json").json["area"]
    assert whole["low"] - 5 < area < whole["low"]
    minkref("erode", ROOMS, "disc:4", "--tolerance", "1/100", "--outside", "-o", str(polygon))
    assert whole["high"] < Fraction(package.read_file(polygon).area()) < whole["high"] + 5


def test_the_inradius_has_the_features_that_bound_it(minkref: Minkref) -> None:
    value = minkref("events", "POLYGON((0 0,4 0,0 3,0 0))", "disc", "--erode", "--json").json
    jsonschema.validate(value, schema("events"))
    (largest,) = value["inradius"]
    assert (largest["squared_radius"], largest["place"]) == ("1", [1.0, 1.0])
    assert largest["features"] == [{"edge": [0, k]} for k in range(3)]
    told = minkref("events", ROOMS, "disc", "--erode", "--kind", "topology").out
    assert "inradius 15 at (15, 15)" in told and "component 2 leaves component 1" in told
    joined = minkref("events", HOLED, "disc", "--erode", "--kind", "topology").out
    assert "the outside and hole 1 are one" in joined


def test_all_radii_have_a_file_a_sweep_and_a_page(minkref: Minkref, tmp_path: Path) -> None:
    file = str(tmp_path / "rooms.json")
    value = minkref("index", ROOMS, "disc", "--erode", "-o", file, "--json").json
    jsonschema.validate(value, schema("index"))
    words = ("events", ROOMS, "disc", "--erode", "--index", file, "--json")
    assert minkref(*words).json["count"] == value["events"]
    swept = minkref(
        "sweep", ROOMS, "disc", "--erode", "--from", "1", "--to", "15", "--steps", "8", "--json"
    ).json
    jsonschema.validate(swept, schema("sweep"))
    assert [row["components"] for row in swept["rows"]] == [1, 1, 2, 2, 2, 2, 2, 0]
    page = str(tmp_path / "rooms.html")
    for other in ("disc", BOX):
        viewed = minkref("view", ROOMS, other, "--erode", "-o", page, "--json").json
        jsonschema.validate(viewed, schema("view"))
        assert viewed["erode"] and Path(page).stat().st_size > 1000


@pytest.mark.parametrize("route", SPACE_ROUTES)
def test_a_box_in_a_box(minkref: Minkref, route: str, tmp_path: Path) -> None:
    room, box = tmp_path / "room.off", tmp_path / "box.off"
    room.write_text(prism([(0, 0), (9, 0), (9, 8), (0, 8)], 7))
    box.write_text(prism([(1, 1), (3, 1), (3, 4), (1, 4)], 4))
    value = minkref("erode", str(room), str(box), "--route", route, "--json").json
    jsonschema.validate(value, schema("erode"))
    assert (value["volume"], value["vertices"], value["convex"]) == (str(7 * 5 * 3), 8, True)
    fits = minkref("erode", str(room), str(box), "--scale", "2/9,1,1", "--passages", "--json").json
    assert (fits["volume"], len(fits["remnants"]["sheets"])) == ("0", 1)
    none = minkref("erode", str(room), str(box), "--scale", "1/9", "--json").json
    assert (none["volume"], none["remnants"]["sheets"]) == ("0", [])
    file = tmp_path / "places.off"
    assert minkref("erode", str(room), str(box), "-o", str(file)).code == 0
    assert _core.PolyhedralSet(package.read_mesh(file)).volume() == str(7 * 5 * 3)


def test_openings_and_closings_by_a_disc(minkref: Minkref, tmp_path: Path) -> None:
    corners = (4 - math.pi) / 4  # that the disc does not reach
    for command, area in (("closing", 77 + corners), ("opening", 77 - corners)):
        value = minkref(command, HOLED, "disc:1/2", "--json").json
        jsonschema.validate(value, schema(f"{command}_with_disc"))
        assert (value["components"], value["holes"]) == (1, 1)
        assert value["area"]["low"] == pytest.approx(area, abs=1e-12)
        assert len(value["arcs"]) == 4 and len(value["digest"]) == 64
        for ending in ("svg", "json", "dxf", "wkt"):
            path = tmp_path / f"{command}.{ending}"
            tolerance = ("--tolerance", "1/50") if ending == "wkt" else ()
            minkref(command, HOLED, "disc:1/2", "-o", str(path), *tolerance)
            assert path.read_text()
        near = package.read_file(tmp_path / f"{command}.wkt")
        assert float(Fraction(near.area())) <= value["area"]["high"]


def test_openings_and_closings_in_space(minkref: Minkref, tmp_path: Path) -> None:
    """A cube has sheets of places in arms of its width, and a larger one fills the notch."""
    ell = [(0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (0, 4)]
    (tmp_path / "ell.off").write_text(prism(ell, 2))
    for size in (1, 2):
        (tmp_path / f"cube{size}.off").write_text(cube(size))
    two = (str(tmp_path / "ell.off"), str(tmp_path / "cube1.off"))
    left = minkref("opening", *two, "--json", "--passages").json
    jsonschema.validate(left, schema("opening_in_space"))
    assert (left["volume"], left["components"]) == ("0", 0)
    assert len(left["exact_fits"]["sheets"]) == 2
    filled = minkref("closing", two[0], str(tmp_path / "cube2.off"), "--json").json
    jsonschema.validate(filled, schema("closing_in_space"))
    assert (filled["volume"], filled["remnants"]) == ("14", None)
    told = minkref("opening", *two, "--scale", "2", "-o", str(tmp_path / "open.off"))
    assert "exact fits" in told.out and "not looked for" in told.out
    read = minkref("sum", str(tmp_path / "open.off"), two[1], "--json").json
    assert read["components"] == 1


def test_fits_in_space(minkref: Minkref, tmp_path: Path) -> None:
    """A unit cube has one place in itself, and 8 times its volume of places beside itself."""
    file = tmp_path / "cube.off"
    file.write_text(cube())
    fit = minkref("innerfit", str(file), str(file), "--passages", "--json").json
    jsonschema.validate(fit, schema("innerfit_in_space"))
    assert (fit["volume"], len(fit["exact_fits"]["points"])) == ("0", 1)
    no_fit = minkref("nofit", str(file), str(file), "--json").json
    jsonschema.validate(no_fit, schema("nofit_in_space"))
    assert (no_fit["volume"], no_fit["exact_fits"], no_fit["A"]) == ("8", None, str(file))


BAD = {
    ("erode", ROOMS): "Q",
    ("erode", ROOMS, "POLYGON EMPTY"): "empty",
    ("erode", ROOMS, BOX, "--route", "papr"): "paper",
    ("erode", ROOMS, BOX, "--scale", "0"): "positive",
    ("erode", "disc:1", BOX): "disc",
    ("erode", ROOMS, "disc:0"): "radius",
    ("erode", ROOMS, "disc:1", "-o", "x.wkt"): "--tolerance",
    ("erode", ROOMS, "disc:1", "--index", "x.json"): "--index",
    ("erode", ROOMS, BOX, "-o", "x.off"): ".wkt",
    ("opening", "disc:1", ROOMS): "polygons",
    ("opening", "gs3", "gs4", "--plot"): "picture",
    ("closing", "gs3", "ball:1"): "ball",
    ("closing", "POINT(0 0)", "disc:1"): "area",
    ("closing", "disc:1", HOLED): "minkref closing 'POLYGON",
    ("closing", HOLED, "disc:1/2", "-o", "x.wkt"): "--tolerance",
    ("erode", "LINESTRING(0 0,1 0,1 1)", BOX): "segments or points",
    ("nofit", ROOMS, "disc:1"): "polygons",
    ("innerfit", "gs3", "gs4", "--plot"): "picture",
    ("closing", "POINT(0 0)", "POINT(1 1)", "--scale", "-1"): "positive",
    ("closing", "POINT(0 0)", "LINESTRING(0 0,1 1)"): "points or segments",
    ("events", ROOMS, BOX, "--erode", "--kind", "pair"): "boundary",
    ("events", ROOMS, BOX, "--erode", "--kind", "topology", "--route", "winding"): "dynamic",
    ("events", ROOMS, "disc", "--erode", "--kind", "pair"): "boundary",
    ("events", "LINESTRING(0 0,1 1)", "POINT(0 0)", "--erode"): "area",
    ("events", "POINT(0 0)", "disc", "--erode"): "area",
    ("view", ROOMS, BOX, "--erode", "--to", "1/4"): "room",
    ("sweep", ROOMS, BOX, "--erode", "--from", "1", "--to", "2", "--steps", "2", "--route",
     "paper-update"): "erosion",
    ("events", "gs3", "gs4", "--erode", "--from", "1", "--to", "2"): "in space",
    ("erode", "gs3", "gs4", "--plot"): "picture",
}  # fmt: skip


@pytest.mark.parametrize("words", BAD, ids=lambda words: " ".join(words)[:60])
def test_bad_input_is_refused_with_a_way_out(
    minkref: Minkref, words: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    refused = minkref(*words)
    assert refused.code == 2 and "internal error" not in refused.err
    assert BAD[words] in refused.err, refused.err
    assert list(tmp_path.iterdir()) == []
    if "--json" not in words:
        told = minkref(*words, "--json")
        assert json.loads(told.out)["error"]["mend"]
