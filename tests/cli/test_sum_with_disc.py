"""`minkref sum` with a disc."""

from __future__ import annotations

import json
import math
import re
import sys
from collections.abc import Callable
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

import ezdxf
import jsonschema
import mpmath
import pytest
from minkref import _core
from minkref.disc.disc import Disc, read_disc
from minkref.disc.polygons import polygon_near
from minkref.exact import digest
from minkref.schemas import schema
from thoroughness import some

Minkref = Callable[..., Any]

SQUARE = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"
FRAME = "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 2 6, 6 6, 6 2, 2 2))"


def test_a_square_grows_by_steiner(minkref: Minkref) -> None:
    ran = minkref("sum", SQUARE, "disc:1/2", "--json")
    assert ran.code == 0
    jsonschema.validate(ran.json, schema("sum"))
    assert (ran.json["components"], ran.json["holes"], ran.json["curves"]) == (1, 0, 8)
    assert ran.json["radius"] == "1/2"
    area = ran.json["area"]
    assert area["low"] <= 16 + 8 + math.pi / 4 <= area["high"]
    text = json.dumps(ran.json["result"], separators=(",", ":"))
    assert ran.json["digest"] == digest(text)
    assert ran.json["result"]["components"][0]["outer"][:2] == [
        ["arc", "0", "0"], ["line", "1", "0", "0"],
    ]  # fmt: skip


def test_the_first_operand_is_scaled(minkref: Minkref) -> None:
    by_polygon = minkref("sum", SQUARE, "disc:1", "--scale", "3/2", "--json").json
    whole = minkref("sum", "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0))", "disc:1", "--json").json
    assert by_polygon["digest"] == whole["digest"]
    by_disc = minkref("sum", "disc:2", SQUARE, "--scale", "1/2", "--json").json
    assert by_disc["digest"] == minkref("sum", SQUARE, "disc:1", "--json").json["digest"]


@pytest.mark.parametrize(
    ("radius", "told", "holes"),
    [("sqrt:2", "sqrt:2", 1), ("sqrt:4", "2", 0), ("1.99", "199/100", 1), ("2", "2", 0)],
)
def test_a_hole_closes(minkref: Minkref, radius: str, told: str, holes: int) -> None:
    ran = minkref("sum", FRAME, f"disc:{radius}", "--json")
    assert (ran.json["radius"], ran.json["holes"]) == (told, holes)


@pytest.mark.parametrize("radius", ["sqrt:2", "2", "1/3", "9"])
def test_both_routes_give_one_digest(minkref: Minkref, radius: str) -> None:
    ran = minkref("sum", FRAME, f"disc:{radius}", "--route", "paper", "--json")
    assert ran.code == 0
    jsonschema.validate(ran.json, schema("sum"))
    other = minkref("sum", FRAME, f"disc:{radius}", "--json").json
    assert (ran.json["route"], other["route"]) == ("paper", "definition")
    for key in ("digest", "result", "components", "holes", "curves", "radius"):
        assert ran.json[key] == other[key]
    assert ran.json["area"]["low"] <= other["area"]["high"]
    assert other["area"]["low"] <= ran.json["area"]["high"]


@pytest.mark.parametrize("route", ["definition", "paper"])
def test_a_picture_by_each_route(minkref: Minkref, tmp_path: Path, route: str) -> None:
    file = tmp_path / "sum.svg"
    assert minkref("sum", FRAME, "disc:1", "--route", route, "-o", file).code == 0
    assert len(re.findall("A[0-9]", file.read_text(encoding="utf-8"))) == 4


def test_the_json_file_is_the_canonical_form(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "sum.json"
    ran = minkref("sum", FRAME, "disc:1", "-o", file, "--json")
    assert ran.json["output_exact"] is True
    assert digest(file.read_text(encoding="utf-8").strip()) == ran.json["digest"]


def test_the_picture_has_arcs(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "sum.svg"
    assert minkref("sum", FRAME, "disc:1", "-o", file).code == 0
    text = file.read_text(encoding="utf-8")
    assert len(re.findall("A[0-9]", text)) == 4
    assert 'class="first"' in text
    minkref("sum", FRAME, "disc:1", "-o", file, "--only-sum")
    assert 'class="first"' not in file.read_text(encoding="utf-8")


def test_tight_passages(minkref: Minkref) -> None:
    ran = minkref("sum", FRAME, "disc:2", "--json")
    (found,) = ran.json["tight_passages"]
    assert (found["points"], found["near"]) == ([["4", "4"]], [[4.0, 4.0]])
    assert sorted(found["contacts"]) == [
        ["line", "-1", "0", "2"], ["line", "0", "-1", "-6"],
        ["line", "0", "1", "2"], ["line", "1", "0", "-6"],
    ]  # fmt: skip
    assert minkref("sum", FRAME, "disc:1", "--json").json["tight_passages"] == []
    told = minkref("sum", FRAME, "disc:2").out
    assert re.search(r"tight passages +1 point", told) and "(4, 4)" in told
    hall = "POLYGON ((0 0, 9 0, 9 6, 0 6, 0 0), (2 2, 2 4, 7 4, 7 2, 2 2))"
    for route in ("definition", "paper"):
        found = minkref("sum", hall, "disc:1", "--route", route, "--json").json["tight_passages"]
        assert [row["points"] for row in found] == [[["3", "3"], ["6", "3"]]]
    assert re.search(r"tight passages +1 segment", minkref("sum", hall, "disc:1").out)


def test_the_tight_point_of_a_triangle(minkref: Minkref) -> None:
    """The incircle's centre of a triangle with sides 3, 4 and 5: lines from three fields."""
    triangle = "POLYGON ((-9 -9, 9 -9, 9 9, -9 9, -9 -9), (0 0, 0 3, 4 0, 0 0))"
    ran = minkref("sum", triangle, "disc:1", "--json")
    assert [row["points"] for row in ran.json["tight_passages"]] == [[["1", "1"]]]
    jsonschema.validate(ran.json, schema("sum"))


SHAPES = (
    SQUARE,
    FRAME,
    "POLYGON ((0 0, 5 1, 7 6, 3 3, 1 7, 0 0))",
    "MULTIPOLYGON (((0 0, 2 1, 1 3, 0 0)), ((3 0, 6 0, 5 2, 3 0)), ((2 4, 5 4, 4 6, 2 4)))",
    "LINESTRING (0 0, 3 1)",
    "POINT (1/3 2)",
)
#: Each shape twice, by either route, with each radius.
SUMS = some(product(SHAPES, ["1/2", "sqrt:2", "3/4"], ["definition", "paper"]), 12)


def value_of(expression: str) -> mpmath.mpf:
    """With 60 digits."""
    number = re.sub(r"(\d+)", r"mpf('\1')", expression)
    return mpmath.mpf(eval(number, {"mpf": mpmath.mpf, "sqrt": mpmath.sqrt}))


@pytest.mark.parametrize(("shape", "radius", "route"), SUMS)
def test_measures_are_sums_of_terms(minkref: Minkref, shape: str, radius: str, route: str) -> None:
    ran = minkref("sum", shape, f"disc:{radius}", "--route", route, "--measures", "--json")
    assert ran.code == 0, ran.err
    jsonschema.validate(ran.json, schema("sum"))
    with mpmath.workdps(60):
        angle = mpmath.mpf(0)
        for row in ran.json["measures"]["angles"]:
            start, end = (mpmath.mpc(*map(value_of, row[name])) for name in ("from", "to"))
            turn = mpmath.arg(end / start) % (2 * mpmath.pi)
            angle += turn if turn > mpmath.mpf(10) ** -50 else 2 * mpmath.pi
        square = value_of(ran.json["squared_radius"])
        length, area = (
            sum((value_of(row["factor"]) * value_of(row["root"]) for row in terms), mpmath.mpf(0))
            for terms in (ran.json["measures"]["length"], ran.json["measures"]["area"])
        )
        length += mpmath.sqrt(square) * angle
        area += square * angle / 2
        for name, found in (("length", length), ("area", area)):
            bounds = ran.json[name]
            assert bounds["low"] <= found <= bounds["high"], (name, found, bounds)


def test_measures_of_a_square(minkref: Minkref) -> None:
    """Steiner's formula."""
    measures = minkref("sum", SQUARE, "disc:sqrt:2", "--measures", "--json").json["measures"]
    assert measures["length"] == [{"factor": "16", "root": "1"}]
    assert {(row["factor"], row["root"]) for row in measures["area"]} == {
        ("16", "1"), ("16", "sqrt(2)"),
    }  # fmt: skip
    assert len(measures["angles"]) == 4
    assert {"from": ["-1", "0"], "to": ["0", "-1"]} in measures["angles"]
    whole = minkref("sum", "POINT (0 0)", "disc:3", "--measures", "--json").json["measures"]
    assert whole["length"] == [] and len(whole["angles"]) == 1
    assert whole["angles"][0]["from"] == whole["angles"][0]["to"]


@pytest.mark.parametrize(("shape", "radius", "route"), SUMS)
def test_a_drawing_has_arcs_as_bulges(
    minkref: Minkref, tmp_path: Path, shape: str, radius: str, route: str
) -> None:
    """ezdxf reads the file again: the ring count, area and length equal the sum's."""
    file = tmp_path / "sum.dxf"
    ran = minkref("sum", shape, f"disc:{radius}", "--route", route, "-o", file, "--json")
    assert (ran.code, ran.json["output_exact"]) == (0, False)
    rings = list(ezdxf.readfile(file).modelspace().query("LWPOLYLINE"))
    components = ran.json["result"]["components"]
    assert len(rings) == sum(1 + len(each["holes"]) for each in components)
    area = length = 0.0
    for ring in rings:
        assert ring.closed and ring.dxf.layer == "SUM"
        points = list(ring.get_points("xyb"))
        for (x0, y0, bulge), (x1, y1, _) in zip(points, [*points[1:], points[0]], strict=True):
            chord, angle = math.hypot(x1 - x0, y1 - y0), 4 * math.atan(bulge)
            area += (x0 * y1 - x1 * y0) / 2
            if bulge == 0:
                length += chord
                continue
            r = chord / (2 * math.sin(angle / 2))
            assert r == pytest.approx(math.sqrt(Fraction(ran.json["squared_radius"])))
            area += r * r * (angle - math.sin(angle)) / 2
            length += r * angle
    assert area == pytest.approx(ran.json["area"]["low"], rel=1e-9)
    assert length == pytest.approx(ran.json["length"]["low"], rel=1e-9)
    text = file.read_bytes()
    minkref("sum", shape, f"disc:{radius}", "--route", route, "-o", file)
    assert file.read_bytes() == text


def test_without_ezdxf_a_drawing_is_refused(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    ran = minkref("sum", SQUARE, "disc:1", "-o", tmp_path / "sum.dxf")
    assert ran.code == 2 and "pip install 'minkref[dxf]'" in ran.err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("outside", [False, True])
def test_a_polygon_within_a_tolerance(minkref: Minkref, tmp_path: Path, outside: bool) -> None:
    file = tmp_path / "sum.wkt"
    options = ["--outside"] if outside else []
    ran = minkref(
        "sum", SQUARE, "disc:sqrt:2", "-o", file, "--tolerance", "1/500", *options, "--json"
    )
    assert (ran.code, ran.json["tolerance"], ran.json["output_exact"]) == (0, "1/500", False)
    exact = 16 + 16 * math.sqrt(2) + 2 * math.pi
    area = float(Fraction(_core.read_file(str(file)).area()))
    assert 0 <= (area - exact if outside else exact - area) <= ran.json["length"]["high"] / 500


@pytest.mark.parametrize("square", ["2", "1/9", "123456789/1000", "1/10000000000000000000001"])
@pytest.mark.parametrize("tolerance", ["1/3", "1/1000"])
def test_polygons_are_inside_and_outside(square: str, tolerance: str) -> None:
    """Their corners and the middles of their sides, exactly."""
    disc = Disc("", Fraction(square))
    low, high = disc.bounds(80)
    assert low**2 <= disc.squared_radius <= high**2
    off = Fraction(tolerance) * high
    gap = min(off, low) / 64
    unit = Fraction(1, 2**200)
    for outside in (False, True):
        (ring,) = [rings[0] for rings in polygon_near(disc, off, outside, gap, unit).rings()]
        corners = [(Fraction(x), Fraction(y)) for x, y in ring]
        for (ax, ay), (bx, by) in zip(corners, [*corners[1:], corners[0]], strict=True):
            across = (ax * by - ay * bx) ** 2 / ((bx - ax) ** 2 + (by - ay) ** 2)
            if outside:
                assert across >= disc.squared_radius
                assert ax**2 + ay**2 <= (low + off) ** 2
            else:
                assert ax**2 + ay**2 <= disc.squared_radius
                assert across >= (high - off) ** 2


@pytest.mark.parametrize(
    ("arguments", "what"),
    [
        (("disc:0",), "the radius is zero"),
        (("disc:-1",), "the radius is negative"),
        (("disc:",), "the radius"),
        (("disc:nan",), "the radius"),
        (("disc:sqrt:x",), "the radius"),
        (("disc:" + "9" * 1001,), "characters"),
        (("disc:1", "--route", "winding"), "--route"),
        (("disc:1", "--route", "dynamic"), "definition, paper, index"),
        (("disc:1", "--arithmetic", "double"), "--arithmetic"),
        (("disc:1", "--plot"), "--plot"),
        (("disc:1", "--tolerance", "1"), "--tolerance"),
        (("disc:1", "--outside"), "--outside"),
        (("disc:1", "-o", "sum.wkt"), "this format has no arcs"),
        (("disc:1", "-o", "sum.wkt", "--tolerance", "0"), "--tolerance"),
        (("disc:1", "-o", "sum.wkt", "--tolerance", "1e-12"), "corners"),
        (("disc:1", "-o", "sum.dwg"), "sum.dwg"),
        (("disc:1", "-o", "sum.dxf", "--tolerance", "1"), "--tolerance"),
        (("disc:1", "--measures"), "--measures"),
        (("g1", "--measures", "--json"), "--measures"),
        (("disc:1", "--point", "1,1"), "add --certify"),
        (("disc:1", "--certify", "sum.json"), "FILE.cert.json"),
        (("g1", "--certify", "sum.cert.json"), "--certify"),
        (("disc:1", "--route", "paper-update", "--certify", "sum.cert.json"), "exact sums only"),
        (("g1", "--tolerance", "1"), "--tolerance"),
    ],
)
def test_what_it_refuses(
    minkref: Minkref,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: tuple[str, ...],
    what: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = minkref("sum", SQUARE, *arguments)
    assert ran.code == 2
    assert what in ran.err
    assert not list(tmp_path.iterdir())


def test_a_proof_of_the_sum(minkref: Minkref, tmp_path: Path) -> None:
    """Written beside its case, scaled, and verified; lines are refused."""
    file = tmp_path / "s.cert.json"
    points = [word for point in ("4,4", "9,9", "8/2,4") for word in ("--point", point)]
    ran = minkref("sum", FRAME, "disc:1/2", "--certify", file, *points, "--scale", "1/2")
    assert ran.code == 0 and "3 claims" in ran.out and "checked: verified" in ran.out, ran.err
    checked = minkref("check", file, "--json")
    assert checked.code == 0 and ran.out.split("digest")[1].split()[0] in checked.out
    assert "point: (4, 4) is inside" in checked.out
    assert "point: (9, 9) is outside" in checked.out
    ran = minkref("sum", FRAME, "disc:sqrt:2", "--certify", tmp_path / "t.cert.json", "--json")
    assert (ran.code, ran.json["certificate"]["verified"]) == (0, True), ran.err
    refused = minkref(
        "sum", "LINESTRING (0 0, 1 1)", "disc:1", "--certify", tmp_path / "l.cert.json"
    )
    assert refused.code == 2 and "regions" in refused.err
    assert not (tmp_path / "l.cert.json").exists()


def test_two_discs_are_refused(minkref: Minkref) -> None:
    ran = minkref("sum", "disc:1", "disc:2")
    assert ran.code == 2
    assert "add their radii" in ran.err


def test_radii_as_texts() -> None:
    assert read_disc("disc:0.25").radius == "1/4"
    assert read_disc("disc:sqrt:9/4").radius == "3/2"
    assert read_disc("disc:sqrt:3").scaled(Fraction(2)).radius == "sqrt:12"
