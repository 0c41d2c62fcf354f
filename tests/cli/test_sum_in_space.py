"""`minkref sum` and `minkref sweep` of convex polyhedra."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.exact import digest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.generators.convex import box, random_hull
from minkref.fuzz.space.hull import convex_hull, sum_of_convex
from minkref.schemas import schema

Minkref = Callable[..., Any]

ZERO, ONE = Fraction(0), Fraction(1)


def off(polyhedron: Polyhedron) -> str:
    lines = ["OFF", f"{len(polyhedron.vertices)} {len(polyhedron.faces)} 0"]
    lines += [" ".join(str(c) for c in vertex) for vertex in polyhedron.vertices]
    lines += [" ".join(map(str, (len(face), *face))) for face in polyhedron.faces]
    return "\n".join(lines) + "\n"


def canonical(polyhedron: Polyhedron) -> str:
    """A hull's text with ascending vertices and rings that start at their least vertex."""
    vertices = [[str(c) for c in vertex] for vertex in polyhedron.vertices]
    faces = sorted(polyhedron.faces)
    return json.dumps({"faces": faces, "vertices": vertices}, separators=(",", ":"))


@pytest.fixture
def cubes(tmp_path: Path) -> tuple[Path, Path]:
    """Files of two cubes, with sides 2 and 1."""
    paths = tmp_path / "two.off", tmp_path / "one.off"
    for path, side in zip(paths, (2, 1), strict=True):
        corner = (Fraction(side), Fraction(side), Fraction(side))
        path.write_text(off(box((ZERO, ZERO, ZERO), corner)), encoding="utf-8")
    return paths


def test_cubes_scaled_along_each_axis(minkref: Minkref, cubes: tuple[Path, Path]) -> None:
    ran = minkref("sum", *cubes, "--scale", "1,1/2,0.25", "--json")
    assert ran.code == 0
    jsonschema.validate(ran.json, schema("sum"))
    assert ran.json["scale"] == ["1", "1/2", "1/4"]
    assert ran.json["volume"] == "9"
    assert (ran.json["vertices"], ran.json["edges"], ran.json["facets"]) == (8, 12, 6)
    assert all(len(face["P"]) == len(face["Q"]) == 4 for face in ran.json["facet_parents"])


def test_one_factor_is_that_of_all_axes(minkref: Minkref, cubes: tuple[Path, Path]) -> None:
    values = [
        minkref("sum", *cubes, "--scale", scale, "--json").json for scale in ("3/2", "1.5,3/2,1.5")
    ]
    assert values[0]["digest"] == values[1]["digest"]
    assert values[0]["volume"] == "64"


@pytest.mark.parametrize("seed", range(8))
def test_all_routes_give_the_hull_of_all_sums_of_vertices(
    minkref: Minkref, tmp_path: Path, seed: int
) -> None:
    dice = random.Random(seed)
    P, Q = random_hull(dice, 8, 3), random_hull(dice, 8, 3)
    scaling = (Fraction(dice.randint(1, 9), 4), Fraction(dice.randint(1, 9), 4), ONE)
    paths = tmp_path / "P.off", tmp_path / "Q.off"
    for path, operand in zip(paths, (P, Q), strict=True):
        path.write_text(off(operand), encoding="utf-8")
    text = ",".join(map(str, scaling))
    expected = canonical(sum_of_convex(P, Q, scaling))
    for route in ("traversal", "brute-force", "dynamic"):
        value = minkref("sum", *paths, "--scale", text, "--route", route, "--json").json
        assert value["digest"] == digest(expected)
        assert value["result"] == json.loads(expected)


def test_what_is_written_is_read_again(
    minkref: Minkref, cubes: tuple[Path, Path], tmp_path: Path
) -> None:
    for ending in ("off", "obj", "stl", "ply", "json"):
        path = tmp_path / f"sum.{ending}"
        ran = minkref("sum", *cubes, "-o", path)
        assert (ran.code, ran.err) == (0, "")
        assert str(path) in ran.out
        again = minkref("sum", path, cubes[1], "--json").json
        assert again["volume"] == "64"


def test_models_are_operands(minkref: Minkref) -> None:
    value = minkref("sum", "gs3", "rod", "--scale", "2,1/3,5", "--json").json
    jsonschema.validate(value, schema("sum"))
    assert value["facets"] > 400


def test_sweep_gives_the_sum_at_every_scaling(
    minkref: Minkref, cubes: tuple[Path, Path], tmp_path: Path
) -> None:
    scalings = tmp_path / "scalings.txt"
    scalings.write_text("1,2,3 # first\n\n1/2\n1,2,3\n", encoding="utf-8")
    folder = tmp_path / "sums"
    line = ("sweep", *cubes, "--scales", scalings, "-o", folder, "--format", "off")
    ran = minkref(*line, "--json")
    assert ran.code == 0
    jsonschema.validate(ran.json, schema("sweep"))
    rows = ran.json["rows"]
    assert [row["scale"] for row in rows] == [["1", "2", "3"], ["1/2"] * 3, ["1", "2", "3"]]
    for row in rows:
        text = ",".join(row["scale"])
        assert row["digest"] == minkref("sum", *cubes, "--scale", text, "--json").json["digest"]
        assert (folder / row["file"]).is_file()
    assert minkref(*line).code == 0  # replaces its own folder


@pytest.mark.parametrize(
    ("options", "code", "words"),
    [
        (("--scale", "1,2"), "scale-not-three", "2 factors"),
        (("--scale", "1,2,0"), "scale-zero", "z"),
        (("--scale", "1,-2,3"), "scale-negative", "y"),
        (("--route", "winding"), "usage", "winding"),
        (("--arithmetic", "double"), "usage", "exact only"),
        (("-o", "sum.svg"), "usage", ".svg"),
    ],
)
def test_misuse_is_refused(
    minkref: Minkref, cubes: tuple[Path, Path], options: tuple[str, ...], code: str, words: str
) -> None:
    ran = minkref("sum", *cubes, *options, "--json")
    assert ran.code == 2
    assert ran.json["error"]["code"] == code
    assert words in json.dumps(ran.json["error"])


def test_an_operand_of_the_plane_beside_one_in_space_is_refused(
    minkref: Minkref, cubes: tuple[Path, Path]
) -> None:
    for names in ((cubes[0], "g1"), ("g1", cubes[0])):
        ran = minkref("sum", *names, "--json")
        assert ran.code == 2
        assert ran.json["error"]["code"] == "mixed-dimensions"


def test_a_dent_is_refused_with_face_vertex_and_line(minkref: Minkref, tmp_path: Path) -> None:
    path = tmp_path / "dent.off"
    path.write_text(
        "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 1/2\n"
        "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n",
        encoding="utf-8",
    )
    ran = minkref("convolution", path, "gs3", "--json")  # `sum` takes polyhedra of any shape
    assert ran.code == 2
    error = ran.json["error"]
    assert error["code"] == "not-convex"
    assert str(path) in error["where"]
    assert "face" in error["where"]
    assert "vertex" in error["where"]
    assert "line" in error["where"]


def test_an_open_mesh_is_refused_and_nothing_written(
    minkref: Minkref, cubes: tuple[Path, Path], tmp_path: Path
) -> None:
    text = cubes[0].read_text(encoding="utf-8").splitlines()
    text[1] = "8 5 0"
    broken, output = tmp_path / "open.off", tmp_path / "sum.off"
    broken.write_text("\n".join(text[:-1]) + "\n", encoding="utf-8")
    ran = minkref("sum", broken, cubes[1], "-o", output, "--json")
    assert ran.code == 2
    assert ran.json["error"]["code"] == "open-mesh"
    assert not output.exists()


def test_a_certificate_is_written_and_verified(
    minkref: Minkref, cubes: tuple[Path, Path], tmp_path: Path
) -> None:
    path = tmp_path / "sum.cert.json"
    ran = minkref("certify", *cubes, "--scale", "1,2,1/2", "-o", path, "--json")
    assert ran.code == 0
    jsonschema.validate(ran.json, schema("certify"))
    checked = minkref("check", path, "--json").json
    assert [row["verdict"] for row in checked["files"]] == ["verified"]
    digests = [claim["digest"] for claim in ran.json["claims"]]
    assert digests == [minkref("sum", *cubes, "--scale", "1,2,1/2", "--json").json["digest"]]
    refused = minkref("certify", *cubes, "--event", "2", "-o", tmp_path / "e.cert.json")
    assert refused.code == 2
    assert not (tmp_path / "e.cert.json").exists()


@pytest.mark.parametrize("seed", range(4))
def test_a_segment_is_an_operand_on_either_side(
    minkref: Minkref, tmp_path: Path, seed: int
) -> None:
    dice = random.Random(seed)
    body = random_hull(dice, 9, 3)
    a, b = ([dice.randint(-2, 2) for _ in range(3)] for _ in "ab")
    b[0] += 5  # another point than a
    paths = tmp_path / "body.off", tmp_path / "segment.off"
    paths[0].write_text(off(body), encoding="utf-8")
    rows = "\n".join(" ".join(map(str, end)) for end in (a, b))
    paths[1].write_text(f"OFF\n2 0 0\n{rows}\n", encoding="utf-8")
    s = (Fraction(2), Fraction(1, 3), Fraction(5, 4))
    for P, Q in ((paths[0], paths[1]), (paths[1], paths[0])):
        value = minkref("sum", P, Q, "--scale", ",".join(map(str, s)), "--json").json
        jsonschema.validate(value, schema("sum"))
        scale_of_body = s if P == paths[0] else (ONE, ONE, ONE)
        scale_of_ends = (ONE, ONE, ONE) if P == paths[0] else s
        hull = convex_hull(
            (x * f[0] + end[0] * g[0], y * f[1] + end[1] * g[1], z * f[2] + end[2] * g[2])
            for f, g in [(scale_of_body, scale_of_ends)]
            for x, y, z in body.vertices
            for end in (a, b)
        )
        assert value["digest"] == digest(canonical(hull))


def test_a_point_moves_and_the_empty_set_empties(
    minkref: Minkref, cubes: tuple[Path, Path], tmp_path: Path
) -> None:
    point, empty = tmp_path / "point.off", tmp_path / "empty.off"
    point.write_text("OFF\n1 0 0\n1/2 3 -1\n", encoding="utf-8")
    empty.write_text("OFF\n0 0 0\n", encoding="utf-8")
    value = minkref("sum", cubes[1], point, "--scale", "2,1,1", "--json").json
    assert value["result"]["vertices"][0] == ["1/2", "3", "-1"]
    assert value["volume"] == "2"
    value = minkref("sum", cubes[0], empty, "--json").json
    jsonschema.validate(value, schema("sum"))
    assert (value["facets"], value["volume"]) == (0, "0")
    ran = minkref("sum", point, point, "--json")
    assert (ran.code, ran.json["error"]["code"]) == (2, "not-solid")


def test_sweep_beside_a_point_a_segment_or_nothing_gives_the_sums(
    minkref: Minkref, cubes: tuple[Path, Path], tmp_path: Path
) -> None:
    scalings = tmp_path / "scalings.txt"
    scalings.write_text("1\n3,1/2,2\n", encoding="utf-8")
    for text in ("OFF\n1 0 0\n1/2 3 -1\n", "OFF\n2 0 0\n0 0 0\n1 2 3\n", "OFF\n0 0 0\n"):
        other = tmp_path / "other.off"
        other.write_text(text, encoding="utf-8")
        value = minkref("sweep", cubes[0], other, "--scales", scalings, "--json").json
        jsonschema.validate(value, schema("sweep"))
        for row, scale in zip(value["rows"], ("1", "3,1/2,2"), strict=True):
            single = minkref("sum", cubes[0], other, "--scale", scale, "--json").json
            assert (row["digest"], row["volume"]) == (single["digest"], single["volume"])
            assert row["fv_errors"] == row["chains_walked"] == 0
