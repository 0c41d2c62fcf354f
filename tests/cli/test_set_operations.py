"""`minkref union`, `intersection` and `difference`: documents, repairs, a law, and refusals."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import _core
from minkref.degeneracies import lint
from minkref.fuzz.plane.families.random_pairs import random_pair
from minkref.schemas import schema

Minkref = Callable[..., Any]
LEFT = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"
RIGHT = "POLYGON ((1 0, 2 0, 2 1, 1 1, 1 0))"
WIDE = "POLYGON ((1/2 0, 3 0, 3 1, 1/2 1, 1/2 0))"
PARCELS = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((1 0, 2 0, 2 1, 1 1, 1 0)))"
BOW = "MULTIPOLYGON (((0 0, 2 2, 2 0, 0 2, 0 0)), ((0 0, 1 0, 1 1, 0 0)))"


@pytest.mark.parametrize(
    ("command", "area", "first"),
    [("union", "3", ["0", "0"]), ("intersection", "1/2", ["1/2", "0"]),
     ("difference", "1/2", ["0", "0"])],
)  # fmt: skip
def test_the_document_has_the_set(
    minkref: Minkref, command: str, area: str, first: list[str]
) -> None:
    value = minkref(command, LEFT, WIDE, "--json").json
    jsonschema.validate(value, schema(command))
    assert (value["area"], value["components"], value["holes"]) == (area, 1, 0)
    assert value["result"]["polygons"][0]["outer"][0] == first


def test_parcels_that_share_an_edge_are_repaired(minkref: Minkref, tmp_path: Path) -> None:
    parcels, repaired = tmp_path / "parcels.wkt", tmp_path / "repaired.wkt"
    parcels.write_text(PARCELS)
    assert "overlap along an edge" in minkref("sum", str(parcels), LEFT).err
    value = minkref("union", str(parcels), "-o", str(repaired), "--json").json
    assert value["operands"] == [{"name": str(parcels), "polygons": 2, "united": True}]
    assert (value["vertices"], value["area"]) == (4, "2")
    assert minkref("sum", str(repaired), LEFT, "--json").json["area"] == "6"
    assert minkref("union", LEFT, RIGHT, "--json").json["digest"] == value["digest"]


@pytest.mark.parametrize(
    "second", ["(2 2, 3 2, 3 3, 2 3, 2 2)", "(9 0, 12 0, 12 9, 9 9, 9 0)",
               "(6 2, 12 2, 12 5, 6 5, 6 2)"],
    ids=("inside", "along an edge", "crossing"),
)  # fmt: skip
def test_the_refusal_of_two_polygons_names_the_command_that_unites_them(
    minkref: Minkref, tmp_path: Path, second: str
) -> None:
    two, one = tmp_path / "two.wkt", tmp_path / "one.wkt"
    two.write_text(f"MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0)), ({second}))")
    refused = minkref("sum", str(two), LEFT)
    assert refused.code == 2
    assert "`minkref union`" in " ".join(refused.err.split())
    minkref("union", str(two), "-o", str(one))
    assert minkref("sum", str(one), LEFT, "--json").json["components"] == 1


def test_a_sum_goes_into_the_parts_of_a_union() -> None:
    """(A or B) + R is (A + R) or (B + R)."""
    for index in range(12):
        pair, third = random_pair(82, index), random_pair(82, index + 40)
        A, B, R = (_core.PolygonSet.from_json(text) for text in (pair.P, pair.Q, third.Q))
        if not all(each.is_region for each in (A, B, R)):
            continue
        whole = _core.combined("union", [A, B])[0]
        parts = [_core.minkowski_sum(each, R, "1", "definition").region for each in (A, B)]
        expected = _core.combined("union", parts)[0]
        found = _core.minkowski_sum(whole, R, "1").region
        assert found.canonical_json() == expected.canonical_json(), index
        both, less = (_core.combined(name, [A, B])[0] for name in ("intersection", "difference"))
        assert Fraction(both.area()) + Fraction(less.area()) == Fraction(A.area())


def test_sets_go_to_files_and_pictures(minkref: Minkref, tmp_path: Path) -> None:
    assert (
        minkref("difference", WIDE, LEFT, "-o", "-").out == "POLYGON ((1 0, 3 0, 3 1, 1 1, 1 0))\n"
    )
    told = minkref("union", LEFT, RIGHT, "--plot").out
    assert "area" in told and len(told.splitlines()) > 8
    svg = tmp_path / "both.svg"
    minkref("union", LEFT, RIGHT, "-o", str(svg))
    assert svg.read_text().startswith("<svg")


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("union", BOW), "two edges of a ring cross"),
        (("union", "POINT (1 2)", LEFT), "no interior"),
        (("union", "-", "-"), "standard input is one operand"),
        (("intersection", LEFT, "nothing.wkt"), "no such file"),
        (("difference",), "Missing argument"),
        (("difference", LEFT), "one set only"),
        (("union", LEFT, "--plot", "--json"), "only one of them"),
        (("union", "gs3", LEFT), "polyhedron"),
    ],
)
def test_wrong_use_is_refused(minkref: Minkref, words: tuple[str, ...], told: str) -> None:
    ran = minkref(*words)
    assert ran.code == 2
    assert told in ran.err


def test_nothing_is_left_of_a_set_without_itself(minkref: Minkref) -> None:
    value = minkref("difference", LEFT, LEFT, "--json").json
    assert (value["area"], value["components"], value["result"]) == ("0", 0, {"polygons": []})


def test_a_union_is_certified(minkref: Minkref, tmp_path: Path) -> None:
    """Documents tell written files; checkers follow them; bad names fail."""
    file = tmp_path / "both.cert.json"
    value = minkref("union", LEFT, RIGHT, "--certify", str(file), "--json").json
    jsonschema.validate(value, schema("union"))
    told = value["certificate"]
    assert (told["output"], told["claims"], told["verified"]) == (str(file), 4, True)
    assert minkref("check", str(file)).code == 0
    case = Path(told["case"]).read_text(encoding="utf-8")
    lint.validator("union-case-v1").validate(json.loads(case))
    assert minkref("union", LEFT, RIGHT, "--json").json["certificate"] is None
    refused = minkref("union", LEFT, "--certify", "made.json")
    assert (refused.code, "FILE.cert.json" in refused.err) == (2, True)
