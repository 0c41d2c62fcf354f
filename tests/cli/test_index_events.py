"""`events` with --index or the route index lists the same events as dynamic update."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from index_runs import (
    SEVERAL,
    Minkref,
    account,
    ask,
    between,
    build,
    event_scales,
    operands,
    window_options,
)
from minkref import _core
from minkref.plane.operand import read_operand

# Pairs whose holes are born, die, merge and split.
EVENTFUL = ("letters", "islands", "several components")


@pytest.mark.parametrize("kind", ["boundary", "topology"])
@SEVERAL
def test_events_are_those_by_dynamic_update(
    minkref: Minkref, tmp_path: Path, name: str, kind: str
) -> None:
    P, Q = operands(tmp_path, name)
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q)
    by_default, by_file, alone = (
        ask(minkref, "events", P, Q, "--kind", kind, *route)
        for route in ([], ["--index", path], ["--route", "index"])
    )
    assert (by_default["route"], by_file["route"], alone["route"]) == ("dynamic", "index", "index")
    assert account(by_file) == account(alone) == account(by_default)
    assert by_file["pairs"] is None and by_default["pairs"] > 0
    if name in EVENTFUL:
        assert by_file["count"] >= 5


@pytest.mark.parametrize("kind", ["boundary", "topology"])
@pytest.mark.parametrize("name", EVENTFUL)
def test_events_of_a_window_include_those_at_its_ends(
    minkref: Minkref, tmp_path: Path, name: str, kind: str
) -> None:
    P, Q = operands(tmp_path, name)
    scales = event_scales(P, Q, kind)
    window = (scales[len(scales) // 4], scales[3 * len(scales) // 4])
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q, *window_options(window))
    moved = ask(
        minkref, "events", P, Q, "--kind", kind, *window_options(window), "--route", "dynamic"
    )
    found = ask(minkref, "events", P, Q, "--kind", kind, "--index", path)
    assert account(found) == account(moved)
    assert (found["events"][0]["s"], found["events"][-1]["s"]) == window


@pytest.mark.parametrize("name", EVENTFUL)
def test_a_window_may_be_narrower_than_that_of_the_index(
    minkref: Minkref, tmp_path: Path, name: str
) -> None:
    P, Q = operands(tmp_path, name)
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q)
    scales = event_scales(P, Q, "topology")
    low, high = scales[len(scales) // 3], scales[2 * len(scales) // 3]
    for window in ((low, high), (low, None), (None, high), (between(low, high), "1000")):
        for kind in ("boundary", "topology"):
            options = ("--kind", kind, *window_options(window))
            narrow = ask(minkref, "events", P, Q, *options, "--index", path)
            moved = ask(minkref, "events", P, Q, *options, "--route", "dynamic")
            assert account(narrow, names=False) == account(moved, names=False)
            # A feature keeps its name from the index's window.
            whole = ask(minkref, "events", P, Q, "--kind", kind, "--index", path)
            kept = [
                {**event, "rank": None}
                for event in whole["events"]
                if (window[0] is None or Fraction(event["s"]) >= Fraction(window[0]))
                and (window[1] is None or Fraction(event["s"]) <= Fraction(window[1]))
            ]
            assert [{**event, "rank": None} for event in narrow["events"]] == kept


def test_a_window_that_is_not_given_is_that_of_the_index(
    minkref: Minkref, letters: Path, tmp_path: Path
) -> None:
    kind = ("--kind", "topology", "--index", letters)
    for given in ([], ["--from", "1/4"], ["--to", "4"]):
        value = ask(minkref, "events", "g1", "g2", *kind, *given)
        assert (value["from"], value["to"]) == ("1/4", "4")
    value = ask(minkref, "events", "g1", "g2", *kind, "--from", "1/2")
    assert (value["from"], value["to"]) == ("1/2", "4")
    page = tmp_path / "page.html"
    value = ask(minkref, "view", "g1", "g2", "--index", letters, "-o", page)
    assert (value["from"], value["to"]) == ("1/4", "4")
    value = ask(minkref, "view", "g1", "g2", "--index", letters, "--to", "3", "-o", page)
    assert (value["from"], value["to"]) == ("1/4", "3")


def test_events_written_to_a_file_are_those_that_are_printed(
    minkref: Minkref, letters: Path, tmp_path: Path
) -> None:
    file = tmp_path / "events.json"
    options = ("g1", "g2", "--kind", "topology", "--index", letters)
    printed = ask(minkref, "events", *options)
    assert ask(minkref, "events", *options, "-o", file)["events"] is None
    assert json.loads(file.read_text("utf-8"))["events"] == printed["events"]
    seen = minkref("events", *options)
    assert seen.code == 0
    assert "index" in seen.out and "hole" in seen.out


def segment(row: Any, P: Any, Q: Any, scale: Fraction) -> Any:
    """Both ends of a convolution edge."""
    kind, _, edge_ring, edge, vertex_ring, vertex = row
    own, other = (P, Q) if kind == "S" else (Q, P)
    ring = own[edge_ring]
    of_edge, of_vertex = (scale, 1) if kind == "S" else (1, scale)
    v = other[vertex_ring][vertex]
    return [
        tuple(of_edge * a + of_vertex * b for a, b in zip(end, v, strict=True))
        for end in (ring[edge], ring[(edge + 1) % len(ring)])
    ]


def passes_through(ends: Any, point: tuple[Fraction, Fraction]) -> bool:
    (ax, ay), (bx, by) = ends
    on_line = (bx - ax) * (point[1] - ay) == (by - ay) * (point[0] - ax)
    in_box = min(ax, bx) <= point[0] <= max(ax, bx) and min(ay, by) <= point[1] <= max(ay, by)
    return bool(on_line and in_box)


def exact_rings(operand: _core.PolygonSet) -> list[list[tuple[Fraction, Fraction]]]:
    polygons = json.loads(operand.to_json())["polygons"]
    return [
        [(Fraction(x), Fraction(y)) for x, y in ring]
        for polygon in polygons
        for ring in (polygon["outer"], *polygon["holes"])
    ]


@SEVERAL
def test_parents_by_index_are_some_of_those_by_dynamic_update_and_meet_in_the_place(
    minkref: Minkref, tmp_path: Path, name: str
) -> None:
    P, Q = operands(tmp_path, name)
    rings = exact_rings(read_operand(P).set), exact_rings(read_operand(Q).set)
    edges = {
        (row[0], *row[2:]): row
        for row in _core.reduced_convolution(read_operand(P).set, read_operand(Q).set)
    }
    found, moved = (
        ask(minkref, "events", P, Q, "--kind", "boundary", "--route", route)["events"]
        for route in ("index", "dynamic")
    )
    for event, other in zip(found, moved, strict=True):
        scale, at = Fraction(event["s"]), (Fraction(event["at"][0]), Fraction(event["at"][1]))
        parents, every = (
            {(edge["kind"], *edge["edge"], *edge["vertex"]) for edge in one["parents"]}
            for one in (event, other)
        )
        assert len(parents) == len(event["parents"])
        assert parents <= every, event["s"]
        through = [
            edge for edge in parents if passes_through(segment(edges[edge], *rings, scale), at)
        ]
        assert len(through) >= 2, (event["s"], event["at"])


@SEVERAL
def test_features_are_born_and_die_in_the_same_place(
    minkref: Minkref, tmp_path: Path, name: str
) -> None:
    P, Q = operands(tmp_path, name)
    found, moved = (
        [
            (event["s"], event["feature"], event["change"], event["at"])
            for event in ask(minkref, "events", P, Q, "--kind", "topology", "--route", route)[
                "events"
            ]
            if event["change"] in ("birth", "death")
        ]
        for route in ("index", "dynamic")
    )
    assert found == moved
