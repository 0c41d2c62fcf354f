"""`minkref sum` of general polyhedra."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import schema
from written_solids import (
    SQUARE,
    L,
    cube,
    cubed,
    frame,
    hollow_cube,
    moved,
    off,
    polygon,
    prism,
    together,
)

Minkref = Callable[..., Any]
GENERAL = ("edges", "definition")
CONVEX = ("traversal", "brute-force", "dynamic")


@pytest.fixture
def write(tmp_path: Path) -> Callable[[str, str], Path]:
    def call(name: str, text: str) -> Path:
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return call


def summed(minkref: Minkref, *words: Any) -> dict[str, Any]:
    ran = minkref("sum", *words, "--json")
    assert ran.code == 0, ran.out
    jsonschema.validate(ran.json, schema("sum"))
    value: dict[str, Any] = ran.json
    text = json.dumps(value["result"], separators=(",", ":"))
    assert value["digest"] == hashlib.sha256(text.encode()).hexdigest()
    return value


@pytest.mark.parametrize("route", GENERAL)
def test_an_angle_and_a_cube(minkref: Minkref, write: Any, route: str) -> None:
    P, Q = write("l.off", prism(L)), write("cube.off", cube())
    value = summed(minkref, P, Q, "--route", route)
    assert (value["volume"], value["convex"], value["route"]) == ("16", False, route)
    assert len(value["result"]["planes"]) == 8
    assert value["vertex_parents"] is None
    again = summed(minkref, P, Q, "--scale", "1,1,1")
    assert (again["digest"], again["route"]) == (value["digest"], "edges")
    signs, counts = again["signs"], again["statistics"]
    assert signs["total"] == signs["by_float"] + signs["by_integer"] > 0
    assert counts["convolution_facets"] > 0 and counts["candidates"] > 0


def test_scaling_along_each_axis(minkref: Minkref, write: Any) -> None:
    P, Q = write("l.off", prism(L)), write("cube.off", cube())
    digests = set()
    for route in GENERAL:
        value = summed(minkref, P, Q, "--scale", "2,1/2,3", "--route", route)
        # [0,5] x [0,2] without (3,5] x (3/2,2], four high
        assert value["volume"] == str((Fraction(10) - 1) * 4)
        digests.add(value["digest"])
    assert len(digests) == 1


def test_a_convex_sum_has_one_form_by_all_routes(minkref: Minkref, write: Any) -> None:
    P, Q = write("tent.off", prism([(0, 0), (3, 0), (1, 2)], "5/2")), write("cube.off", cube())
    values = [summed(minkref, P, Q, "--scale", "1,2/3,1", "--route", r) for r in CONVEX + GENERAL]
    assert len({value["digest"] for value in values}) == 1
    assert all(value["convex"] and value["result"] == values[0]["result"] for value in values)
    # A non-convex operand may have a convex sum: the cavity is filled.
    hollow, big = write("hollow.off", hollow_cube()), write("big.off", cube(2))
    filled = summed(minkref, hollow, big)
    assert filled["convex"] and filled["volume"] == "125"
    assert filled["digest"] == summed(minkref, write("three.off", cube(3)), big)["digest"]


def test_a_cavity_shrinks(minkref: Minkref, write: Any) -> None:
    hollow, Q = write("hollow.off", hollow_cube()), write("cube.off", cube("1/2"))
    for route in GENERAL:
        value = summed(minkref, hollow, Q, "--route", route)
        assert Fraction(value["volume"]) == cubed("7/2") - cubed("1/2")
        assert len(value["result"]["planes"]) == 12
        shape = value["components"], value["cavities"], value["tunnels"]
        assert shape == (1, 1, 0)
        assert (value["vertices"], value["edges"], value["facets"]) == (16, 24, 12)


@pytest.mark.parametrize(("scale", "tunnels"), [("1", 1), ("3/2", 1), ("1/2", 0)])
def test_a_tunnel_closes(minkref: Minkref, write: Any, scale: str, tunnels: int) -> None:
    P, Q = write("frame.off", frame()), write("cube.off", cube())
    for route in GENERAL:
        value = summed(minkref, P, Q, "--scale", scale, "--route", route)
        assert value["tunnels"] == tunnels == 1 - value["convex"]
        s = Fraction(scale)
        hole = max(2 * s - 1, Fraction(0)) ** 2
        flat = (4 * s + 1) ** 2 - hole
        assert Fraction(value["volume"]) == flat * (s + 1)
        assert Fraction(value["projected_areas"][2]) == 2 * flat


def test_a_component_for_each_body(minkref: Minkref, write: Any, tmp_path: Path) -> None:
    P = write("two.off", together(cube(), moved(prism(L, "3/2"), 9)))
    Q = write("cube.off", cube())
    value = summed(minkref, P, Q)
    assert (value["components"], value["volume"]) == (2, str(8 + 8 * Fraction(5, 2)))
    assert summed(minkref, P, Q, "--scale", "1,1,1/9")["components"] == 2
    touching = tmp_path / "touching.off"
    value = summed(minkref, P, write("big.off", cube(8)), "-o", touching)
    assert value["components"] == 2
    origin = write("origin.off", "OFF\n1 0 0\n0 0 0\n")
    assert refused(minkref, "sum", touching, origin)["code"] == "non-manifold-vertex"
    assert summed(minkref, P, write("big.off", cube(9)))["components"] == 1


def test_parents_lie_in_the_plane_of_their_facet(minkref: Minkref, write: Any) -> None:
    wedge = prism([(0, 0), (3, 1), (1, 2)], "2/3")
    P, Q = write("l.off", prism(L)), write("wedge.off", wedge)
    value = summed(minkref, P, Q, "--scale", "1,3/2,2")
    scaling = [Fraction(factor) for factor in value["scale"]]
    points = {
        name: [[Fraction(c) for c in point] for point in value["operands"][name]["vertices"]]
        for name in "PQ"
    }
    kinds = set()
    for facet in value["surface"]["facets"]:
        plane = value["result"]["planes"][facet["plane"]]
        normal = [int(c) for c in plane["normal"]]
        assert facet["parents"]
        for pair in facet["parents"]:
            kinds.add((min(len(pair["P"]), 3), min(len(pair["Q"]), 3)))
            for p in pair["P"]:
                for q in pair["Q"]:
                    place = [
                        s * x + y
                        for s, x, y in zip(scaling, points["P"][p], points["Q"][q], strict=True)
                    ]
                    height = sum(n * x for n, x in zip(normal, place, strict=True))
                    assert height == Fraction(plane["offset"])
    assert kinds == {(3, 1), (1, 3), (2, 2)}


def test_a_mesh_that_is_written_is_an_operand_again(
    minkref: Minkref, write: Any, tmp_path: Path
) -> None:
    P, Q = write("frame.off", frame()), write("cube.off", cube("1/2"))
    origin = write("origin.off", "OFF\n1 0 0\n0 0 0\n")
    expected = summed(minkref, P, Q)["digest"]
    for ending in ("off", "obj", "stl", "ply", "json"):
        path = tmp_path / f"sum.{ending}"
        value = summed(minkref, P, Q, "-o", path)
        assert value["output_exact"] is (ending != "stl")  # which has triangles only
        assert summed(minkref, path, origin)["digest"] == expected
    ran = minkref("sum", P, Q, "-o", "-")
    assert (ran.code, ran.out) == (0, (tmp_path / "sum.off").read_text())


def test_a_plane_polygon_on_either_side_turned_either_way(minkref: Minkref, write: Any) -> None:
    solid = write("cube.off", cube())
    for name, ring in (("up.off", L), ("down.off", L[::-1])):
        flat = write(name, polygon(ring, "1/2"))
        for words in ((flat, solid), (solid, flat)):
            value = summed(minkref, *words)
            assert (value["volume"], value["route"]) == ("8", "edges")
    square = write("square.off", polygon(SQUARE))
    brick = write("brick.off", prism([(0, 0), (2, 0), (2, 2), (0, 2)]))
    nothing = write("point.off", "OFF\n1 0 0\n0 0 0\n")
    value = summed(minkref, square, solid)
    assert value["digest"] == summed(minkref, brick, nothing)["digest"]


def test_points_segments_and_nothing(minkref: Minkref, write: Any) -> None:
    P = write("l.off", prism(L))
    point = write("point.off", "OFF\n1 0 0\n1/3 0 -1\n")
    segment = write("segment.off", "OFF\n2 0 0\n0 0 0\n0 0 2\n")
    empty = write("empty.off", "OFF\n0 0 0\n")
    for route in GENERAL:
        assert summed(minkref, P, point, "--scale", "2", "--route", route)["volume"] == "24"
        assert summed(minkref, segment, P, "--route", route)["volume"] == "9"
    for words in ((P, empty), (empty, P)):
        value = summed(minkref, *words)
        assert value["result"] == {"faces": [], "vertices": []}
        assert summed(minkref, *words, "--route", "edges")["digest"] == value["digest"]


def refused(minkref: Minkref, *words: Any) -> dict[str, str]:
    ran = minkref(*words, "--json")
    assert ran.code == 2
    jsonschema.validate(ran.json, schema(str(words[0])))
    error: dict[str, str] = ran.json["error"]
    return error


def test_what_has_no_volume_is_refused(minkref: Minkref, write: Any) -> None:
    flat, solid = write("flat.off", polygon(L)), write("l.off", prism(L))
    segment = write("segment.off", "OFF\n2 0 0\n0 0 0\n0 0 2\n")
    for words in ((flat, flat), (flat, segment), (segment, segment)):
        assert refused(minkref, "sum", *words)["code"] == "not-solid"
    assert "edges" in refused(minkref, "sum", solid, flat, "--route", "definition")["mend"]


def test_routes_for_convex_operands_say_so(minkref: Minkref, write: Any) -> None:
    P, Q = write("l.off", prism(L)), write("cube.off", cube())
    for route in CONVEX:
        error = refused(minkref, "sum", Q, P, "--route", route)
        assert (error["code"], error["where"]) == ("not-convex", f"--route {route}")
        assert str(P) in error["what"] and "edges" in error["mend"]


def test_commands_for_convex_operands_say_what_takes_others(
    minkref: Minkref, write: Any, tmp_path: Path
) -> None:
    P, Q = write("l.off", prism(L)), write("cube.off", cube())
    scales = write("scales.txt", "1\n")
    before = sorted(tmp_path.iterdir())
    for words in (("sweep", P, Q, "--scales", scales), ("convolution", Q, P)):
        error = refused(minkref, *words)
        assert error["code"] == "not-convex"
        assert str(P) in error["where"] and "minkref sum" in error["mend"]
    assert sorted(tmp_path.iterdir()) == before


def test_a_certificate_is_written_and_verified(
    minkref: Minkref, write: Any, tmp_path: Path
) -> None:
    P, Q = write("l.off", prism(L)), write("cube.off", cube())
    path = tmp_path / "sum.cert.json.gz"
    ran = minkref("certify", P, Q, "--scale", "1,2,1/2", "-o", path, "--json")
    assert ran.code == 0
    jsonschema.validate(ran.json, schema("certify"))
    assert ran.json["verified"] is True
    checked = minkref("check", path, "--json").json
    assert [row["verdict"] for row in checked["files"]] == ["verified"]
    digests = [claim["digest"] for claim in ran.json["claims"]]
    assert digests == [minkref("sum", P, Q, "--scale", "1,2,1/2", "--json").json["digest"]]


def test_what_has_no_volume_has_no_certificate(
    minkref: Minkref, write: Any, tmp_path: Path
) -> None:
    solid, square = write("l.off", prism(L)), write("square.off", polygon(SQUARE))
    before = sorted(tmp_path.iterdir())
    for words in ((solid, square), (square, solid)):
        error = refused(minkref, "certify", *words, "-o", tmp_path / "x.cert.json")
        assert (error["code"], error["where"]) == ("not-solid", str(square))
    assert refused(minkref, "certify", solid, solid, "--event", "2", "-o", tmp_path / "x.cert.json")
    assert sorted(tmp_path.iterdir()) == before


def test_invalid_surfaces_are_refused(minkref: Minkref, write: Any, tmp_path: Path) -> None:
    solid, output = write("cube.off", cube()), tmp_path / "sum.off"
    bow = write("bow.off", polygon([(0, 0), (3, 3), (2, 0), (0, 2)]))
    assert refused(minkref, "sum", bow, solid, "-o", output)["code"] == "face-not-simple"
    two = off([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
    cut = write("cut.off", two)
    assert refused(minkref, "sum", cut, solid, "-o", output)["code"] == "open-mesh"
    lost = write("lost.off", off([(0, 0, 0), (1, 0, 0), (0, 1, 0), (5, 5, 5)], [(0, 1, 2)]))
    assert refused(minkref, "sum", lost, solid, "-o", output)["code"] == "unused-vertex"
    twice = frame().replace("4 0 1 9 8", "4 1 0 8 9")
    assert refused(minkref, "sum", write("w.off", twice), solid)["code"] == "wrong-orientation"
    assert not output.exists()


def test_people_read_the_same(minkref: Minkref, write: Any) -> None:
    ran = minkref("sum", write("l.off", prism(L)), write("cube.off", cube()))
    assert ran.code == 0
    for word in ("edges, exact", "16", "1, 0, 0", "signs"):
        assert word in ran.out


def test_projected_areas_are_the_same_by_all_routes(minkref: Minkref, write: Any) -> None:
    P, Q = write("tent.off", prism([(0, 0), (3, 0), (1, 2)], "5/2")), write("cube.off", cube())
    for route in CONVEX + GENERAL:
        areas = summed(minkref, P, Q, "--route", route)["projected_areas"]
        # the shadows of the sum, once for each side
        assert areas == [str(2 * (3 * Fraction(7, 2))), str(2 * (4 * Fraction(7, 2))), "18"]
