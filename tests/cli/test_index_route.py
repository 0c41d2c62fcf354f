"""`sum` and `sweep` with --index or the route index: the other routes' sums; all operands."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

import jsonschema
import pytest
from index_runs import (
    SEVERAL,
    SUM,
    THIN,
    Minkref,
    account,
    ask,
    between,
    build,
    event_scales,
    operands,
    told,
    written,
)
from minkref.fuzz.plane.families.random_pairs import random_pair
from minkref.output.documents import lasting
from minkref.plane.operand import read_operand
from minkref.schemas import result_schema

STEPS = ("insertions", "deletions", "swaps", "updated", "event_scales", "update_seconds")


@pytest.mark.parametrize("name", ["several components", "touching components"])
def test_documents_of_the_route_index_follow_the_published_schemas(
    minkref: Minkref, tmp_path: Path, name: str
) -> None:
    P, Q = operands(tmp_path, name)
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q)
    sums = ["--from", "1", "--to", "2", "--steps", "2", "-o", str(tmp_path / "sums")]
    for command, *options in (
        ["sum", "--scale", "1"],
        ["sweep", *sums],
        ["events", "--kind", "boundary"],
        ["events", "--kind", "topology", "-o", str(tmp_path / "events.json")],
        ["events", "--kind", "topology"],
        ["view", "-o", str(tmp_path / "page.html")],
    ):
        value = ask(minkref, command, P, Q, *options, "--index", path)
        jsonschema.validate(value, result_schema(command))
        assert value["route"] == "index"


@SEVERAL
def test_sums_are_those_of_the_other_routes(minkref: Minkref, tmp_path: Path, name: str) -> None:
    P, Q = operands(tmp_path, name)
    topology = event_scales(P, Q, "topology")
    events = event_scales(P, Q)
    assert events
    first, last = events[0], str(max(Fraction(events[-1]), Fraction(events[0]) + 1))
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q, "--from", first, "--to", last)
    scales = {first, last, between(first, last), *events[:: 1 + len(events) // 2], *topology[:2]}
    for scale in scales:
        routes = (["--index", path], ["--route", "dynamic"], ["--route", "paper"])
        read_off, moved, static = (
            told(minkref, P, Q, "--scale", scale, *route) for route in routes
        )
        assert read_off == moved == static, scale


def test_a_sum_by_the_route_index_needs_no_file(minkref: Minkref) -> None:
    value = ask(minkref, "sum", "g1", "g2", "--scale", "1/4", "--route", "index")
    assert value["route"] == "index"
    assert value["signs"] is None
    static = ask(minkref, "sum", "g1", "g2", "--scale", "1/4")
    assert static["route"] == "paper"
    assert [value[name] for name in SUM] == [static[name] for name in SUM]


@pytest.mark.parametrize("ending", ["json", "wkt", "svg"])
def test_the_file_of_a_sum_is_that_of_the_static_route(
    minkref: Minkref, letters: Path, tmp_path: Path, ending: str
) -> None:
    files = [tmp_path / f"{name}.{ending}" for name in ("index", "paper")]
    value = ask(minkref, "sum", "g1", "g2", "--scale", "7/5", "--index", letters, "-o", files[0])
    ask(minkref, "sum", "g1", "g2", "--scale", "7/5", "-o", files[1])
    assert value["route"] == "index"
    assert files[0].read_bytes() == files[1].read_bytes()


@pytest.mark.parametrize("number", range(8))
def test_random_pairs_by_the_route_index_and_by_paper(
    minkref: Minkref, tmp_path: Path, number: int
) -> None:
    pair = random_pair(6, 31 * number)
    names = []
    for name, text in (("P", pair.P), ("Q", pair.Q)):
        file = tmp_path / f"{name}.json"
        file.write_text(text, encoding="utf-8")
        names.append(str(file))
    path = tmp_path / "sums.index"
    build(minkref, path, *names)
    events = event_scales(names[0], names[1])
    for scale in {pair.scale, *events[:: 1 + len(events) // 3]}:
        read_off = told(minkref, *names, "--scale", scale, "--index", path)
        assert read_off == told(minkref, *names, "--scale", scale), scale


def test_the_ends_of_an_open_window_are_as_far_as_scales_go(
    minkref: Minkref, tmp_path: Path
) -> None:
    path = tmp_path / "sums.index"
    build(minkref, path, "g3", "g1")
    for scale in ("1e-300", "1e400", "1/340282366920938463463374607431768211507"):
        read_off = told(minkref, "g3", "g1", "--scale", scale, "--index", path)
        assert read_off == told(minkref, "g3", "g1", "--scale", scale), scale


@pytest.mark.parametrize("scale", ["1", "14/29"])
def test_a_window_may_be_one_scale(minkref: Minkref, tmp_path: Path, scale: str) -> None:
    P, Q = operands(tmp_path, "several components")
    path = tmp_path / "sums.index"
    value = build(minkref, path, P, Q, "--from", scale, "--to", scale)
    assert value["from"] == value["to"] == scale
    assert set(value["checked"]["scales"]) == {scale}
    read_off = told(minkref, P, Q, "--scale", scale, "--index", path)
    assert read_off == told(minkref, P, Q, "--scale", scale)
    assert minkref("sum", P, Q, "--scale", "2", "--index", path).code == 2
    for kind in ("boundary", "topology"):
        window = ("--from", scale, "--to", scale, "--kind", kind)
        moved = ask(minkref, "events", P, Q, *window, "--route", "dynamic")
        assert account(ask(minkref, "events", P, Q, "--kind", kind, "--index", path)) == account(
            moved
        )


@pytest.mark.parametrize("window", [("1/3", "4", "5"), ("3", "1/2", "4"), ("1", "1", "1")])
@pytest.mark.parametrize("name", ["letters", "several components"])
def test_rows_of_a_sweep_are_those_by_dynamic_update(
    minkref: Minkref, tmp_path: Path, name: str, window: tuple[str, str, str]
) -> None:
    P, Q = operands(tmp_path, name)
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q, "--from", "1/3", "--to", "4")
    scales = ["--from", window[0], "--to", window[1], "--steps", window[2]]
    by_file = ask(minkref, "sweep", P, Q, *scales, "--index", path)
    by_default = ask(minkref, "sweep", P, Q, *scales)
    moved = ask(minkref, "sweep", P, Q, *scales, "--route", "dynamic")
    assert (by_file["route"], by_default["route"], moved["route"]) == ("index", "index", "dynamic")
    for value in (by_file, by_default):
        assert len(value["rows"]) == int(window[2])
        for row, other in zip(value["rows"], moved["rows"], strict=True):
            assert [row[field] for field in ("scale", *SUM)] == [
                other[field] for field in ("scale", *SUM)
            ]
            assert [row[field] for field in STEPS] == [None] * len(STEPS)
            assert None not in [other[field] for field in STEPS]


def test_a_sweep_by_index_visits_events_in_the_order_of_its_file(
    minkref: Minkref, letters: Path, tmp_path: Path
) -> None:
    events = [s for s in event_scales("g1", "g2") if Fraction(1, 4) <= Fraction(s) <= 4]
    scales = [*events[5::9], "1/4", "4", *events[:20:7]]
    file = tmp_path / "scales.txt"
    file.write_text("\n".join(scales), encoding="utf-8")
    rows = ask(minkref, "sweep", "g1", "g2", "--scales", file, "--index", letters)["rows"]
    assert [row["scale"] for row in rows] == scales
    moved = ask(minkref, "sweep", "g1", "g2", "--scales", file, "--route", "dynamic")["rows"]
    for row, other in zip(rows, moved, strict=True):
        assert [row[field] for field in SUM] == [other[field] for field in SUM], row["scale"]


def test_the_files_of_a_sweep_are_the_same_by_both_routes(
    minkref: Minkref, letters: Path, tmp_path: Path
) -> None:
    scales = ["--from", "1/3", "--to", "3", "--steps", "3"]
    for folder, route in (("a", ["--index", letters]), ("b", ["--route", "dynamic"])):
        value = ask(minkref, "sweep", "g1", "g2", *scales, *route, "-o", tmp_path / folder)
        assert json.loads((tmp_path / folder / "index.json").read_text("utf-8")) == lasting(value)
    for number in (1, 2, 3):
        name = f"sum-{number:04}.json"
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()


# Operands of all kinds.


@pytest.mark.parametrize("first", [True, False])
@pytest.mark.parametrize("shape", THIN)
def test_operands_without_area(minkref: Minkref, tmp_path: Path, shape: str, first: bool) -> None:
    thin = written(tmp_path, "thin", THIN[shape])
    P, Q = (thin, "g1") if first else ("g1", thin)
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q)
    for scale in ("1/3", "1", "7"):
        read_off = told(minkref, P, Q, "--scale", scale, "--index", path)
        assert read_off == told(minkref, P, Q, "--scale", scale)
    for kind in ("boundary", "topology"):
        found = ask(minkref, "events", P, Q, "--kind", kind, "--index", path)
        assert account(found) == account(ask(minkref, "events", P, Q, "--kind", kind))
    rows = ask(minkref, "sweep", P, Q, "--from", "1", "--to", "2", "--steps", "3", "--index", path)[
        "rows"
    ]
    assert {row["components"] for row in rows} == {0 if shape == "empty" else 1}
    page = tmp_path / "page.html"
    assert ask(minkref, "view", P, Q, "--index", path, "-o", page)["components"] == (
        0 if shape == "empty" else 1
    )


def test_the_same_operand_in_another_file_is_the_same(minkref: Minkref, tmp_path: Path) -> None:
    path = tmp_path / "sums.index"
    build(minkref, path, "g1", "g3")
    copy = tmp_path / "copy.json"
    copy.write_text(read_operand("g1").set.to_json(), encoding="utf-8")
    read_off = told(minkref, copy, "g3", "--index", path)
    assert read_off == told(minkref, "g1", "g3")
