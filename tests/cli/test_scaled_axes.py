"""`minkref sum`, `convolution`, `sweep` and `certify` in the plane with a factor for each axis."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import schema

Minkref = Callable[..., Any]

FRAME = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))"
TRIANGLE = "POLYGON ((0 0, 1 0, 0 1, 0 0))"
ROUTES = ("paper", "winding", "definition", "dynamic", "index")


def test_a_square_is_scaled_along_each_axis(minkref: Minkref) -> None:
    square = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"
    ran = minkref("sum", square, square, "--scale", "2,1/3", "--json")
    jsonschema.validate(ran.json, schema("sum"))
    assert ran.json["scale"] == ["2", "1/3"]
    assert ran.json["result"]["polygons"][0]["outer"][2] == ["3", "4/3"]


@pytest.mark.parametrize(("scale", "holes", "passages"), [("2/3,3", 1, 0), ("1/2,3", 0, 1)])
def test_all_routes_give_one_digest_and_one_list_of_passages(
    minkref: Minkref, scale: str, holes: int, passages: int
) -> None:
    """At 1/2,3 the triangle is as wide as the hole."""
    found = [
        minkref("sum", FRAME, TRIANGLE, "--scale", scale, "--route", route, "--json").json
        for route in ROUTES
    ]
    assert len({value["digest"] for value in found}) == 1
    assert all(value["tight_passages"] == found[0]["tight_passages"] for value in found)
    assert (found[0]["holes"], len(found[0]["tight_passages"])) == (holes, passages)


def test_convex_operands_take_the_update_of_section_6(minkref: Minkref) -> None:
    """The route dynamic; the frame above reduces to a sum from scratch."""
    pair = ("sum", TRIANGLE, TRIANGLE, "--scale", "3,1/2", "--json")
    by_update, by_paper = minkref(*pair, "--route", "dynamic").json, minkref(*pair).json
    for name in ("digest", "area", "components", "holes", "vertices", "tight_passages"):
        assert by_update[name] == by_paper[name]


def test_equal_factors_are_one_scale(minkref: Minkref) -> None:
    one, two = (
        minkref("sum", FRAME, TRIANGLE, "--scale", scale, "--json").json for scale in ("2", "2,2")
    )
    assert one["scale"] == two["scale"] == "2"
    assert one["digest"] == two["digest"]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--scale", "1,2,3"), "give one positive number, or two: SX,SY"),
        (("--scale", "1,-2"), "the scale is negative"),
        (("--scale", "1,0"), "the scale is zero"),
        (("--scale", "1,"), "not a number"),
        (("--scale", "1,2", "--route", "paper-update"), "uniform scales only"),
        (("--scale", "1,2", "--index", "absent.index"), "an index has uniform scales"),
    ],
)
def test_other_scales_are_refused(minkref: Minkref, options: tuple[str, ...], words: str) -> None:
    ran = minkref("sum", FRAME, TRIANGLE, *options)
    assert ran.code == 2
    assert words in " ".join(ran.err.split())


def test_commands_of_one_scale_name_those_of_two(minkref: Minkref) -> None:
    ran = minkref("events", FRAME, TRIANGLE, "--from", "1,2")
    assert ran.code == 2
    assert "this takes one scale" in " ".join(ran.err.split())


def test_the_convolution_has_the_scaled_edges(minkref: Minkref) -> None:
    ran = minkref("convolution", TRIANGLE, TRIANGLE, "--scale", "2,1/3", "--json")
    jsonschema.validate(ran.json, schema("convolution"))
    directions = {tuple(edge["direction"]) for edge in ran.json["edges"] if edge["kind"] == "S"}
    assert directions == {("2", "0"), ("-2", "1/3"), ("0", "-1/3")}


def test_a_sweep_of_convex_operands_gives_the_static_sums(minkref: Minkref, tmp_path: Path) -> None:
    scales = tmp_path / "scales.txt"
    scales.write_text("1\n2,1/3\n1/3,2  # the other way\n5,5\n", encoding="utf-8")
    other = "POLYGON ((0 0, 3 0, 4 2, 1 5, 0 0))"
    ran = minkref("sweep", TRIANGLE, other, "--scales", scales, "--json")
    jsonschema.validate(ran.json, schema("sweep"))
    assert [row["scale"] for row in ran.json["rows"]] == ["1", ["2", "1/3"], ["1/3", "2"], "5"]
    for row in ran.json["rows"]:
        given = row["scale"] if isinstance(row["scale"], str) else ",".join(row["scale"])
        static = minkref("sum", TRIANGLE, other, "--scale", given, "--json").json
        assert row["digest"] == static["digest"]
    assert sum(row["ev_errors"] for row in ran.json["rows"]) > 0


def test_a_sweep_refuses_what_has_no_update(minkref: Minkref, tmp_path: Path) -> None:
    scales = tmp_path / "scales.txt"
    scales.write_text("2,1/3\n", encoding="utf-8")
    ran = minkref("sweep", FRAME, TRIANGLE, "--scales", scales)
    assert ran.code == 2
    assert "only sums of convex polygons are updated" in " ".join(ran.err.split())
    ran = minkref("sweep", TRIANGLE, TRIANGLE, "--scales", scales, "--route", "index")
    assert ran.code == 2
    assert "the route index has uniform scales only" in " ".join(ran.err.split())


def test_a_proof_is_checked_and_names_the_factors(minkref: Minkref, tmp_path: Path) -> None:
    path = tmp_path / "sum.cert.json"
    ran = minkref("certify", FRAME, TRIANGLE, "--scale", "2,1/3", "-o", path)
    assert ran.code == 0
    ran = minkref("check", path)
    assert ran.code == 0
    assert "P by 2,1/3: sum" in ran.out
