"""`minkref sum` and `minkref sweep` by the paper's own update: readings, arithmetics, and what is
true beside the answers."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import schema

Minkref = Callable[..., Any]
WINDOW = ("--from", "1", "--to", "2", "--steps", "4")
ROUTE = ("--route", "paper-update")


def test_a_sweep_with_all_formulas_corrected_is_the_exact_one(minkref: Minkref) -> None:
    value = minkref("sweep", "g1", "g2", *WINDOW, *ROUTE, "--form", "corrected", "--json").json
    jsonschema.validate(value, schema("sweep"))
    exact = minkref("sweep", "g1", "g2", *WINDOW, "--json").json
    assert [row["digest"] for row in value["rows"]] == [row["digest"] for row in exact["rows"]]
    assert all(row["exact"]["ulps"] == 0 for row in value["rows"])
    assert value["statistics"]["undecided"] == 0
    assert (value["first_wrong"], value["events"]["missed"], value["events"]["invented"]) == (
        None, 0, 0
    )  # fmt: skip


def test_a_sweep_in_doubles_is_a_little_off(minkref: Minkref) -> None:
    options = ("--form", "corrected", "--arithmetic", "double", "--json")
    rows = minkref("sweep", "g1", "g2", *WINDOW, *ROUTE, *options).json["rows"]
    assert all(row["exact"]["same_structure"] for row in rows)
    assert any(0 < row["exact"]["ulps"] < 10 for row in rows)


def test_a_sweep_as_printed_is_refuted_by_points(minkref: Minkref) -> None:
    value = minkref("sweep", "g1", "g2", *WINDOW, *ROUTE, "--json").json
    jsonschema.validate(value, schema("sweep"))
    assert value["readings"]["observation"] == "printed"
    assert all(row["exact"]["witness"] is not None for row in value["rows"])
    told = minkref("sweep", "g1", "g2", *WINDOW, *ROUTE).out
    assert "another structure: (" in told


def test_events_that_consistency_misses_and_invents_are_named(minkref: Minkref) -> None:
    """In rational numbers the same program misses none."""
    options = ("--form", "corrected", "--reading", "solve=printed", "--json")
    window = ("--from", "1", "--steps", "1")
    for arithmetic, right in (("rational", True), ("mpfr:100", False)):
        value = minkref(
            "sweep", "g1", "g2", *window, *ROUTE, "--arithmetic", arithmetic, *options
        ).json
        jsonschema.validate(value, schema("sweep"))
        assert (value["first_wrong"] is None) is right
        for what in ("missed", "invented"):
            first = value["events"][f"first_{what}"]
            assert (value["events"][what] == 0) is right
            assert (first is None) is right
            if first is not None:
                assert first["a"] != first["b"]


def test_events_of_the_program_stand_beside_the_exact_ones(minkref: Minkref) -> None:
    window = ("events", "g1", "g2", "--limit", "200", "--json")
    value = minkref(*window, "--arithmetic", "mpfr:200").json
    jsonschema.validate(value, schema("events"))
    literal = value["literal"]
    assert len(literal["rows"]) == 200
    found = [row for row in literal["rows"] if row["exact"] is not None]
    assert len(found) > 100
    for row in found:
        off = abs(Fraction(row["scale"]) - Fraction(row["exact"])) / Fraction(row["exact"])
        assert off < Fraction(1, 2**170)
    assert any(row["scale"] != row["exact"] for row in found)
    # Edges that touch at a single scale are missed; conditions without a slope get a slope by
    # rounding.
    assert 0 < literal["missed"] < 20 < literal["invented"] < 200 < literal["right"]

    rational = minkref(*window, "--reading", "interval=printed").json
    assert rational["literal"]["missed"] > 0
    assert rational["literal"]["misplaced"] > 0  # an end bounds from the other side
    assert rational["trial"]["false_inconsistent"] == 0
    assert minkref(*window).json["literal"] is None


def test_one_reading_beside_a_form(minkref: Minkref) -> None:
    options = ("--form", "corrected", "--reading", "solve=least-squares", "--json")
    value = minkref("sum", "g1", "g2", *ROUTE, "--arithmetic", "mpfr:100", *options).json
    jsonschema.validate(value, schema("sum"))
    assert value["readings"]["solve"] == "least-squares"
    assert value["readings"]["interval"] == "corrected"
    assert value["comparison"]["same_structure"]
    assert value["exact"]["equal"] is False  # the coordinates are rounded


def test_a_sum_in_rational_numbers_says_what_is_true(minkref: Minkref) -> None:
    value = minkref("sum", "g1", "g2", *ROUTE, "--json").json
    jsonschema.validate(value, schema("sum"))
    assert value["exact"]["equal"] is False
    assert value["comparison"]["witness"]["in_sum"] in (True, False)
    assert "another set" in minkref("sum", "g1", "g2", *ROUTE).out


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("sum", "g1", "g2", "--form", "printed"), "the route paper has no readings"),
        (("events", "g1", "g2", "--kind", "triple", "--reading", "order=kept"), "pair events only"),
        (("sweep", "g1", "g2", *WINDOW, "--reading", "solve=printed"), "has no readings"),
        (("sweep", "g1", "g2", *WINDOW, "--arithmetic", "double"), "exact only"),
        (("sum", "g1", "g2", *ROUTE, "--form", "right"), "there is no form 'right'"),
        (("sum", "g1", "g2", *ROUTE, "--reading", "solve"), "--reading solve"),
        (("sum", "g1", "g2", *ROUTE, "--reading", "slove=printed"), "did you mean solve"),
        (("sum", "g1", "g2", *ROUTE, "--reading", "solve=tolerance:x"), "tolerance:EPS"),
        (("sum", "g1", "g2", *ROUTE, "--arithmetic", "mpfr:1"), "out of range"),
        (
            ("sweep", "g1", "g2", *WINDOW, *ROUTE, "--arithmetic", "interval"),
            "could not decide a sign",
        ),
    ],
)
def test_refusals(minkref: Minkref, arguments: tuple[str, ...], says: str) -> None:
    answer = minkref(*arguments)
    assert answer.code == 2
    assert says in answer.err
    assert answer.out == ""


def test_the_picture_shows_what_is_lost_and_added(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "sum.svg"
    options = ("--form", "corrected", "--reading", "solve=printed", "--arithmetic", "mpfr:100")
    minkref("sum", "g1", "g2", *ROUTE, *options, "-o", file)
    text = file.read_text(encoding="utf-8")
    assert all(title in text for title in ("the exact sum", "lost", "added"))
    assert 'class="lost"' in text
