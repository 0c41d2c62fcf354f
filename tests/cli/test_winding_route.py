"""`--route winding` follows the full convolution: all events of the reduced one, and the same
sums."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import jsonschema
import pytest
from index_runs import Minkref, ask
from minkref import _core
from minkref.exact import set_json
from minkref.plane.operand import read_operand
from minkref.schemas import schema

FRAME = [([(0, 0), (8, 0), (8, 8), (0, 8)], [[(3, 3), (3, 5), (5, 5), (5, 3)]])]
WINDOW = ("--from", "1/2", "--to", "2")


def frame(folder: Path) -> Path:
    path = folder / "frame.json"
    path.write_text(set_json(FRAME), encoding="utf-8")
    return path


def account(value: dict[str, Any], *names: str) -> list[tuple[Any, ...]]:
    return [tuple(str(event[name]) for name in names) for event in value["events"]]


@pytest.mark.parametrize("kind", ["pair", "parallel", "triple", "arrangement"])
def test_the_full_convolution_has_all_events_of_the_reduced_one(
    minkref: Minkref, kind: str
) -> None:
    few = ask(minkref, "events", "g1", "g2", "--kind", kind, *WINDOW)
    many = ask(minkref, "events", "g1", "g2", "--kind", kind, *WINDOW, "--route", "winding")
    jsonschema.validate(many, schema("events"))
    assert (few["route"], many["route"]) == (None, "winding")
    names = ("s", "kind", "change", "parents", "at")
    assert set(account(few, *names)) <= set(account(many, *names))
    assert many["segments"]["S"] > few["segments"]["S"]
    assert many["count"] > few["count"] or kind == "parallel"


@pytest.mark.parametrize("kind", ["boundary", "topology"])
def test_the_boundary_has_the_same_events(minkref: Minkref, kind: str) -> None:
    by_collisions, by_numbers = (
        ask(minkref, "events", "g1", "g3", "--kind", kind, *WINDOW, "--route", route)
        for route in ("dynamic", "winding")
    )
    for name in ("events", "count", "holes", "components"):
        assert by_collisions[name] == by_numbers[name], name


def test_parents_are_numbered_along_the_rings_of_a_cut_operand(
    minkref: Minkref, tmp_path: Path
) -> None:
    options = ("events", frame(tmp_path), "g1", "--route", "winding", "--limit", "5")
    value = ask(minkref, *options)
    jsonschema.validate(value, schema("events"))
    assert value["cut"]["Q"] is None
    (ring,) = value["cut"]["P"]
    assert len(ring) == 4 + 4 + 2
    for event in value["events"]:
        for edge in event["parents"]:
            number = edge["edge"] if edge["kind"] == "S" else edge["vertex"]
            assert number[0] == 0 and number[1] < len(ring)
    assert "cut along slits" in minkref(*options).out
    assert ask(minkref, "events", "g1", "g2", "--limit", "1")["cut"] is None


def test_sums_are_those_of_minkref_sum(minkref: Minkref, tmp_path: Path) -> None:
    for P, Q in (("g1", "g2"), (frame(tmp_path), "g4")):
        value = ask(minkref, "sweep", P, Q, *WINDOW, "--steps", "4", "--route", "winding")
        jsonschema.validate(value, schema("sweep"))
        assert value["route"] == "winding"
        for row in value["rows"]:
            alone = ask(minkref, "sum", P, Q, "--scale", row["scale"])
            assert row["digest"] == alone["digest"], row["scale"]


@pytest.mark.parametrize("route", ["dynamic", "winding"])
def test_a_sum_may_begin_at_another_scale(minkref: Minkref, route: str) -> None:
    options = ("sum", "g1", "g2", "--scale", "7/5", "--route", route)
    there = ask(minkref, *options, "--from", "1/2")
    back = ask(minkref, "sum", "g1", "g2", "--scale", "1/2", "--route", route, "--from", "7/5")
    jsonschema.validate(there, schema("sum"))
    alone = ask(minkref, *options)
    assert (alone["from"], alone["step"], there["from"]) == (None, None, "1/2")
    for name in ("digest", "result", "tight_passages"):
        assert there[name] == alone[name], name
    assert there["step"]["insertions"] == back["step"]["deletions"] > 0


def test_what_the_route_does_not_have_is_refused(minkref: Minkref) -> None:
    for words, told in (
        (("sum", "g1", "g2", "--from", "1"), "--from 1"),
        (("events", "g1", "g2", "--route", "winding", "--least-precision"), "--least-precision"),
        (("events", "g1", "g2", "--route", "winding", "--arithmetic", "double"), "--arithmetic"),
        (("events", "g1", "g2", "--route", "wind"), "dynamic, winding"),
    ):
        done = minkref(*words)
        assert done.code == 2 and told in done.err, words


def test_winding_numbers_beside_an_edge_change_by_the_signs_of_what_it_meets() -> None:
    P, Q = (read_operand(name).set for name in ("g1", "g2"))
    sums = _core.DynamicSum(P, Q, route="winding")
    sums.move_to("1")
    beside = [
        numbers for edge in range(len(sums.edges())) for numbers in sums.winding_numbers(edge)
    ]
    assert (1, 0) in beside
    assert max(max(numbers) for numbers in beside) > 1
    reduced = _core.DynamicSum(P, Q)
    reduced.move_to("1")
    assert reduced.winding_numbers(0) == []
