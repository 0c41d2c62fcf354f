"""`minkref convolution` of convex polyhedra: facets with their parents."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import _core
from minkref.schemas import schema
from minkref.space.facets import KINDS

Minkref = Callable[..., Any]
SIZES = {"v": 1, "e": 2}
CUBE = "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n" + "".join(
    f"4 {face}\n" for face in ("0 3 2 1", "4 5 6 7", "0 1 5 4", "1 2 6 5", "2 3 7 6", "3 0 4 7")
)
TETRAHEDRON = "OFF\n4 4 0\n0 0 0\n3 1 0\n1 4 1\n1 1 5\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"


@pytest.fixture
def bodies(tmp_path: Path) -> tuple[Path, Path]:
    paths = tmp_path / "cube.off", tmp_path / "tetrahedron.off"
    for path, text in zip(paths, (CUBE, TETRAHEDRON), strict=True):
        path.write_text(text, encoding="utf-8")
    return paths


def test_facets_are_those_of_the_sum(minkref: Minkref) -> None:
    words = ("gs3", "rod", "--scale", "2,1/3,5", "--json")
    ran, value = minkref("convolution", *words), minkref("sum", *words).json
    assert (ran.code, ran.err) == (0, "")
    told = ran.json
    jsonschema.validate(told, schema("convolution"))
    assert [facet["ring"] for facet in told["facets"]] == value["result"]["faces"]
    assert told["vertices"] == value["result"]["vertices"]
    named = [{"P": facet["P"], "Q": facet["Q"]} for facet in told["facets"]]
    assert named == value["facet_parents"]
    kinds = Counter(facet["kind"] for facet in told["facets"])
    assert told["kinds"] == {kind: kinds[kind] for kind in KINDS}
    assert told["count"] == value["facets"] == kinds.total()


@pytest.mark.parametrize("scale", ["1", "2,1/3,5"])
def test_a_facet_is_the_sum_of_its_parents(
    minkref: Minkref, bodies: tuple[Path, Path], scale: str
) -> None:
    value = minkref("convolution", *bodies, "--scale", scale, "--json").json
    jsonschema.validate(value, schema("convolution"))
    factors = [Fraction(s) for s in value["scale"]]
    P, Q = (value["operands"][name]["vertices"] for name in "PQ")
    assert {facet["kind"] for facet in value["facets"]} >= {"fv", "vf", "ee"}
    for facet in value["facets"]:
        for letter, name in zip(facet["kind"], "PQ", strict=True):
            assert SIZES.get(letter, max(3, len(facet[name]))) == len(facet[name])
        corners = {
            tuple(
                s * Fraction(x) + Fraction(y) for s, x, y in zip(factors, P[p], Q[q], strict=True)
            )
            for p in facet["P"]
            for q in facet["Q"]
        }
        ring = {tuple(map(Fraction, value["vertices"][v])) for v in facet["ring"]}
        assert ring <= corners


def test_of_two_cubes_each_facet_is_that_of_two(
    minkref: Minkref, bodies: tuple[Path, Path]
) -> None:
    kinds = minkref("convolution", bodies[0], bodies[0], "--json").json["kinds"]
    assert kinds == dict.fromkeys(KINDS, 0) | {"ff": 6}


def test_ply_has_kind_and_parents_of_each_face(
    minkref: Minkref, bodies: tuple[Path, Path], tmp_path: Path
) -> None:
    path = tmp_path / "facets.ply"
    ran = minkref("convolution", *bodies, "-o", path, "--json")
    told = ran.json
    jsonschema.validate(told, schema("convolution"))
    assert (told["facets"], told["output_exact"]) == (None, True)
    facets = minkref("convolution", *bodies, "--json").json["facets"]
    head, body = path.read_text().split("end_header\n")
    assert head.startswith("ply\nformat ascii 1.0\n")
    assert head.endswith(
        "property uchar kind\nproperty list uchar uint p\nproperty list uchar uint q\n"
    )
    names = list(KINDS)
    assert f"comment kind 0, fv: {KINDS['fv']}\n" in head
    for line, facet in zip(body.splitlines()[-len(facets) :], facets, strict=True):
        words = list(map(int, line.split()))
        ring, rest = words[1 : 1 + words[0]], words[1 + words[0] :]
        count = rest[1]
        p, q = rest[2 : 2 + count], rest[3 + count :]
        assert (names[rest[0]], ring, p, q) == (*(facet[k] for k in ("kind", "ring", "P", "Q")),)
        assert rest[2 + count] == len(q)


@pytest.mark.parametrize("ending", ["ply", "off"])
def test_meshes_are_read_again_as_the_sum(
    minkref: Minkref, bodies: tuple[Path, Path], tmp_path: Path, ending: str
) -> None:
    path = tmp_path / f"facets.{ending}"
    assert minkref("convolution", *bodies, "-o", path).code == 0
    text = minkref("convolution", *bodies, "-o", "-", "--format", ending).out
    assert path.read_text() == text
    surface, warnings = _core.read_mesh_file(str(path))
    assert warnings == []
    result = minkref("sum", *bodies, "--json").json["result"]
    assert json.loads(surface.canonical_json()) == result


def test_off_has_a_colour_for_each_kind(
    minkref: Minkref, bodies: tuple[Path, Path], tmp_path: Path
) -> None:
    path = tmp_path / "facets.off"
    minkref("convolution", *bodies, "-o", path)
    facets = minkref("convolution", *bodies, "--json").json["facets"]
    lines = path.read_text().splitlines()
    told = dict(line[2:].split(":")[0:2] for line in lines if line.startswith("# "))
    colours = {words.split(",")[0].strip(): colour for colour, words in told.items()}
    assert set(colours) == {facet["kind"] for facet in facets}
    for line, facet in zip(lines[-len(facets) :], facets, strict=True):
        assert line.endswith(f" {colours[facet['kind']]}")


def test_people_see_how_many_of_each_kind(minkref: Minkref, bodies: tuple[Path, Path]) -> None:
    ran = minkref("convolution", *bodies)
    assert (ran.code, ran.err) == (0, "")
    assert all(KINDS[kind] in ran.out for kind in ("fv", "vf", "ee"))


@pytest.mark.parametrize("other", ["OFF\n1 0 0\n1 2 3\n", "OFF\n2 0 0\n0 0 0\n1 2 3\n"])
def test_a_point_or_a_segment_on_either_side(
    minkref: Minkref, bodies: tuple[Path, Path], tmp_path: Path, other: str
) -> None:
    path = tmp_path / "other.off"
    path.write_text(other, encoding="utf-8")
    kinds = []
    for operands in ((bodies[0], path), (path, bodies[0])):
        value = minkref("convolution", *operands, "--json").json
        jsonschema.validate(value, schema("convolution"))
        kinds.append({kind[::-1] if operands[0] == path else kind: count
                      for kind, count in value["kinds"].items()})  # fmt: skip
    assert kinds[0] == kinds[1]
    assert kinds[0]["fv"] == 6


def test_the_empty_set_has_no_facets(
    minkref: Minkref, bodies: tuple[Path, Path], tmp_path: Path
) -> None:
    path = tmp_path / "empty.off"
    path.write_text("OFF\n0 0 0\n", encoding="utf-8")
    value = minkref("convolution", bodies[0], path, "--json").json
    jsonschema.validate(value, schema("convolution"))
    assert (value["count"], value["facets"]) == (0, [])
    for form in ("off", "ply"):
        ran = minkref("convolution", bodies[0], path, "-o", "-", "--format", form)
        again = _core.read_mesh_text(ran.out.encode(), form, "it")[0]
        assert (ran.code, again.faces) == (0, 0)


@pytest.mark.parametrize(
    ("options", "code", "said"),
    [
        (("--full",), "usage", "no reflex edges"),
        (("--compatible", "open"), "usage", "ties are broken"),
        (("--limit", "3"), "usage", "all facets"),
        (("--scale", "1,2"), "scale-not-three", "2 factors"),
        (("--scale", "1,0,2"), "scale-zero", "y"),
        (("--scale", "-1"), "scale-negative", "-1"),
        (("-o", "it.svg"), "usage", ".svg"),
        (("-o", "it.stl"), "usage", ".stl"),
        (("-o", "-", "--format", "obj"), "usage", "no such format"),
    ],
)
def test_misuse_is_refused(
    minkref: Minkref, bodies: tuple[Path, Path], options: tuple[str, ...], code: str, said: str
) -> None:
    ran = minkref("convolution", *bodies, *options, "--json")
    assert (ran.code, ran.json["error"]["code"]) == (2, code)
    assert said in json.dumps(ran.json["error"])
