"""`minkref sweep --repair literal` in space: the paper's own repair, readings, arithmetics, the
trace, and the truth beside it."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import schema

Minkref = Callable[..., Any]
SIMPLEX = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"


@pytest.fixture
def operands(tmp_path: Path) -> tuple[Path, Path, str, Path]:
    simplex, scalings = tmp_path / "simplex.off", tmp_path / "scalings.txt"
    simplex.write_text(SIMPLEX, encoding="utf-8")
    scalings.write_text("1\n1,2,2\n3,1,1/3\n", encoding="utf-8")
    return simplex, simplex, "--scales", scalings


def test_the_proven_repair_is_the_default(minkref: Minkref, operands: Any) -> None:
    default, named = (
        minkref("sweep", *operands, *more, "--json").json for more in ((), ("--repair", "proven"))
    )
    for value in (default, named):
        jsonschema.validate(value, schema("sweep"))
        assert "repair" not in value
        assert all(row["digest"] and "exact" not in row for row in value["rows"])


def test_all_corrected_is_the_exact_sum(minkref: Minkref, operands: Any) -> None:
    words = ("--repair", "literal", "--form", "corrected", "--json")
    value = minkref("sweep", *operands, *words).json
    jsonschema.validate(value, schema("sweep"))
    exact = minkref("sweep", *operands, "--json").json
    assert [row["volume"] for row in value["rows"]] == [row["volume"] for row in exact["rows"]]
    assert all(row["exact"]["same_facets"] for row in value["rows"])
    assert all(row["exact"]["ulps"] == 0 and row["trace"] is None for row in value["rows"])


def test_as_printed_the_sum_is_lost_with_a_witness(minkref: Minkref, operands: Any) -> None:
    value = minkref("sweep", *operands, "--repair", "literal", "--json").json
    jsonschema.validate(value, schema("sweep"))
    assert value["readings"]["degree"] == "printed"
    first, second, _ = value["rows"]
    assert first["exact"]["same_facets"]
    assert second["exact"]["fault"] == "not-supporting"
    assert second["exact"]["facet"]["kind"] in ("fv", "vf", "ee")
    assert len(second["exact"]["vertex"]) == 2
    told = minkref("sweep", *operands, "--repair", "literal").out
    assert "is above it" in told


def test_a_trace_has_degrees_witnesses_and_steps(minkref: Minkref, operands: Any) -> None:
    words = ("--repair", "literal", "--form", "corrected", "--reading", "degree=printed", "--trace")
    value = minkref("sweep", *operands, *words, "--json").json
    jsonschema.validate(value, schema("sweep"))
    assert value["readings"]["degree"] == "printed"
    assert value["readings"]["search"] == "everywhere"
    errors = [error for row in value["rows"] for error in row["trace"]["errors"]]
    assert all(error["steps"] for error in errors)
    assert all(Fraction(step["squared_degree"]) > 0 for e in errors for step in e["steps"])
    endless = [error for error in errors if error["end"] is None]
    assert len(endless) == sum(row["without_end"] for row in value["rows"]) > 0
    told = minkref("sweep", *operands, *words).out
    assert "no end" in told
    assert "IC²" in told


def test_rounded_coordinates_are_a_little_off(minkref: Minkref, operands: Any) -> None:
    words = ("--repair", "literal", "--form", "corrected", "--arithmetic", "mpfr:24", "--json")
    value = minkref("sweep", *operands, *words).json
    jsonschema.validate(value, schema("sweep"))
    assert value["arithmetic"] == "mpfr:24"
    assert 0 < value["rows"][-1]["exact"]["ulps"] < 2


def test_scalings_beyond_doubles(minkref: Minkref, operands: Any, tmp_path: Path) -> None:
    """In doubles coordinates overflow, in MPFR no more than a place far behind the last is lost."""
    scalings = tmp_path / "far.txt"
    scalings.write_text("1e400,1,1\n1e-400,1,3\n", encoding="utf-8")
    line = ("sweep", *operands[:2], "--scales", scalings, "--repair", "literal", "--form")
    ran = minkref(*line, "corrected", "--arithmetic", "double", "--json")
    assert (ran.code, ran.json["error"]["code"]) == (2, "not-a-number")
    ran = minkref(*line, "corrected", "--arithmetic", "mpfr:53", "--json")
    jsonschema.validate(ran.json, schema("sweep"))
    assert all(row["exact"]["same_facets"] for row in ran.json["rows"])
    told = minkref(*line, "corrected", "--arithmetic", "mpfr:53").out
    assert "the same facets" in told


def test_claimed_facets_are_written(minkref: Minkref, operands: Any, tmp_path: Path) -> None:
    folder = tmp_path / "sums"
    words = ("--repair", "literal", "-o", folder, "--format", "off", "--json")
    value = minkref("sweep", *operands, *words).json
    jsonschema.validate(value, schema("sweep"))
    for row in value["rows"]:
        head = (folder / row["file"]).read_text(encoding="utf-8").split()[1:3]
        assert head == [str(row["vertices"]), str(row["facets"])]


@pytest.mark.parametrize(
    ("words", "what"),
    [
        (("--repair", "right"), "there is no repair"),
        (("--form", "printed"), "the proven repair is exact"),
        (("--reading", "degree=printed"), "the proven repair is exact"),
        (("--arithmetic", "double"), "the proven repair is exact"),
        (("--trace",), "the proven repair is exact"),
        (("--repair", "literal", "--reading", "solve=printed"), "there is no reading"),
        (("--repair", "literal", "--reading", "degree=right"), "there is no reading"),
        (("--repair", "literal", "--arithmetic", "mpfr:1"), "out of range"),
    ],
)
def test_misuse_is_refused(
    minkref: Minkref, operands: Any, words: tuple[str, ...], what: str
) -> None:
    ran = minkref("sweep", *operands, *words)
    assert ran.code == 2
    assert what in ran.err


def test_a_point_and_the_plane_have_no_repair(
    minkref: Minkref, operands: Any, tmp_path: Path
) -> None:
    point = tmp_path / "point.off"
    point.write_text("OFF\n1 0 0\n1 2 3\n", encoding="utf-8")
    ran = minkref("sweep", point, *operands[1:], "--repair", "literal", "--json")
    assert (ran.code, ran.json["error"]["code"]) == (2, "not-solid")
    window = ("--from", "1", "--to", "2", "--steps", "2")
    for words in (("--repair", "literal"), ("--trace",)):
        ran = minkref("sweep", "g1", "g2", *window, *words)
        assert ran.code == 2
        assert "a sum in the plane has no repair" in ran.err
