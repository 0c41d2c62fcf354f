"""`minkref view --route paper-update`: the paper's answers beside the exact sums, step by step."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import _core
from minkref.plane.operand import read_operand
from minkref.plane.page.boundary import Window
from minkref.plane.page.paper_run import slider_scales
from minkref.schemas import result_schema
from page_decoder import data_of as data_in

Minkref = Callable[..., Any]
ROUTE = ("--route", "paper-update")
WINDOW = ("--from", "1/2", "--to", "2", "--steps", "5")


def data_of(page: Path) -> dict[str, Any]:
    return data_in(page.read_text(encoding="utf-8"))


def area(polygons: list[list[list[float]]]) -> float:
    def ring(numbers: list[float]) -> float:
        xs, ys = numbers[::2], numbers[1::2]
        return sum(xs[i - 1] * ys[i] - xs[i] * ys[i - 1] for i in range(len(xs))) / 2

    return sum(ring(numbers) for polygon in polygons for numbers in polygon)


def test_lost_and_added_parts_are_those_of_the_sums(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    ran = minkref(
        "view", "g1", "g2", *ROUTE, *WINDOW, "--arithmetic", "double", "-o", page, "--json"
    )
    jsonschema.validate(ran.json, result_schema("view"))
    run = data_of(page)["paper"]
    scales = [step["scale"] for step in run["steps"]]
    assert (scales[0], scales[-1], len(scales)) == ("1/2", "2", ran.json["steps"])
    assert run["arithmetic"] == ran.json["arithmetic"] == "double"
    assert run["readings"]["observation"] == "printed"
    swept = minkref(
        "sweep", "g1", "g2", *ROUTE, "--arithmetic", "double", "--scales",
        _file(tmp_path, scales), "--json",
    ).json  # fmt: skip
    assert ran.json["first_wrong"] == swept["first_wrong"] == "1/2"
    assert ran.json["events"] == swept["events"]
    P, Q = (read_operand(name).set for name in ("g1", "g2"))
    for step, row in zip(run["steps"], swept["rows"], strict=True):
        assert step["right"] is row["exact"]["same_structure"] is False
        exact = float(Fraction(_core.minkowski_sum(P, Q, step["scale"]).region.area()))
        lost, added = area(step["lost"]), area(step["added"])
        assert exact - lost + added == pytest.approx(float(Fraction(row["area"])), rel=1e-6)
        assert lost + added > 0
        witness = [float(Fraction(axis)) for axis in row["exact"]["witness"]["point"]]
        assert step["witness"] == witness


def test_a_right_program_loses_and_adds_nothing(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    options = ("--form", "corrected", "--arithmetic", "mpfr:200", "-o", page, "--json")
    ran = minkref("view", "g1", "g2", *ROUTE, *WINDOW, *options)
    jsonschema.validate(ran.json, result_schema("view"))
    assert (ran.json["wrong_steps"], ran.json["first_wrong"]) == (0, None)
    for step in data_of(page)["paper"]["steps"]:
        assert step["right"] is True
        assert "ulp off" in step["words"] or step["words"] == "the same set"
        assert (step["lost"], step["added"], step["witness"]) == ([], [], None)


def test_events_that_are_missed_and_invented_have_parents(minkref: Minkref, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    ran = minkref("view", "g1", "g2", *ROUTE, *WINDOW, "-o", page, "--json")
    run = data_of(page)["paper"]
    for what in ("missed", "invented"):
        assert 0 < len(run[what]) <= min(200, ran.json["events"][what])
        scales = [Fraction(event["scale"]) for event in run[what]]
        assert scales == sorted(scales)
        assert Fraction(1, 2) <= scales[0] <= scales[-1] <= 2
        for event in run[what]:
            assert event["change"] in ("birth", "death")
            assert event["a"].split()[0] in ("S", "T") and " at " in event["b"]


def test_what_is_too_much_for_a_page_is_left_out(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("minkref.plane.page.paper_run.MOST_NUMBERS", 5 * 20)
    page = tmp_path / "page.html"
    assert minkref("view", "g1", "g2", *ROUTE, *WINDOW, "-o", page).code == 0
    steps = data_of(page)["paper"]["steps"]
    assert [(step["lost"], step["added"]) for step in steps] == [(None, None)] * 5
    assert all(step["witness"] for step in steps)


@pytest.mark.parametrize(
    ("first", "last", "count"), [("1/10", "10", 61), ("1", "1000001/1000000", 9), ("1/3", "3", 2)]
)
def test_scales_of_the_slider_are_even_and_short(first: str, last: str, count: int) -> None:
    scales = [Fraction(s) for s in slider_scales(Window(first, last), count)]
    assert (scales[0], scales[-1], len(scales)) == (Fraction(first), Fraction(last), count)
    growth = (scales[-1] / scales[0]) ** (1 / (count - 1)) - 1
    for low, high in pairwise(scales):
        assert float(high / low) - 1 == pytest.approx(float(growth), rel=0.1)


def test_a_narrow_window_has_fewer_scales() -> None:
    scales = slider_scales(Window("1", "100000000000001/100000000000000"), 1000)
    assert 2 <= len(scales) < 1000
    assert scales == sorted(set(scales), key=Fraction)


@pytest.mark.parametrize(
    ("options", "word"),
    [
        (["--arithmetic", "double"], "add --route paper-update"),
        (["--steps", "9"], "add --route paper-update"),
        (["--form", "printed"], "add --route paper-update"),
        ([*ROUTE, "--steps", "1"], "choose another N"),
        ([*ROUTE, "--steps", "1001"], "choose another N"),
        ([*ROUTE, "--arithmetic", "mpfr"], "mpfr:BITS"),
        ([*ROUTE, "--reading", "solve=guess"], "least-squares"),
        ([*ROUTE, "--form", "corrected", "--arithmetic", "interval"], "could not decide a sign"),
    ],
)
def test_options_that_do_not_fit_are_refused(
    minkref: Minkref, tmp_path: Path, options: list[str], word: str
) -> None:
    page = tmp_path / "page.html"
    ran = minkref("view", "g1", "g2", *options, "-o", page)
    assert (ran.code, ran.out) == (2, "")
    assert word in ran.err
    assert not page.exists()


def test_in_space_there_is_no_such_program(minkref: Minkref, tmp_path: Path) -> None:
    ran = minkref("view", "gs3", "rod", "--arithmetic", "double", "-o", tmp_path / "page.html")
    assert ran.code == 2
    assert "--arithmetic" in ran.err


def _file(folder: Path, scales: list[str]) -> Path:
    path = folder / "scales.txt"
    path.write_text("\n".join(scales), encoding="utf-8")
    return path
