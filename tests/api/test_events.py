"""Events as values: the same events as the command lists, by both routes."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

import minkref
import pytest
from minkref import Event, PolygonSet, events
from minkref.cli.cli import run
from minkref.plane.event_values import KINDS, ROUTED_KINDS
from minkref.plane.operand import read_operand

FRAME = PolygonSet([[(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (1, 3), (3, 3), (3, 1)]])
SQUARE = PolygonSet([(0, 0), (1, 0), (1, 1), (0, 1)])
G1, G2 = (read_operand(name).set for name in ("g1", "g2"))


def as_document(event: Event) -> dict[str, Any]:
    """As `minkref events --json` has it."""
    more: dict[str, Any] = {}
    if event.kind == "topology":
        more = {"feature": event.feature, "parts": event.parts}
        more |= {"before": list(event.before), "after": list(event.after)}
    return {
        "s": str(event.scale),
        "rank": event.rank,
        "kind": event.kind,
        "change": event.change,
        "parents": [
            {"kind": edge.kind, "edge": list(edge.edge), "vertex": list(edge.vertex)}
            for edge in event.parents
        ],
        "at": [str(coordinate) for coordinate in event.at],
        "to": [str(coordinate) for coordinate in event.to] if event.to else None,
        **more,
    }


@pytest.mark.parametrize("kind", KINDS)
def test_events_are_those_of_the_command(kind: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["events", "g1", "g2", "--kind", kind, "--from", "1/2", "--to", "2", "--json"]
    assert run(words) == 0
    told = json.loads(capsys.readouterr().out)
    found = events(G1, G2, kind, "1/2", 2)
    assert [as_document(event) for event in found] == told["events"]
    assert (len(found), found.distinct) == (told["count"], told["distinct"])
    if kind == "topology":
        for name, lives in (("holes", found.holes), ("components", found.components)):
            said = [(life["id"], life["birth"], life["death"]) for life in told[name]]
            ends = [(s and str(s) for s in (life.birth, life.death)) for life in lives]
            assert [(life.number, *end) for life, end in zip(lives, ends, strict=True)] == said


@pytest.mark.parametrize("kind", ROUTED_KINDS)
def test_all_routes_give_the_same_values(kind: str) -> None:
    for route in ("index", "winding"):
        assert list(events(G1, G2, kind, route=route)) == list(events(G1, G2, kind)), route


@pytest.mark.parametrize("kind", ["pair", "parallel", "triple"])
def test_the_full_convolution_has_all_events_of_the_reduced_one(kind: str) -> None:
    few, many = (events(G1, G2, kind, 1, 2, route=route) for route in ("dynamic", "winding"))
    found = {(event.scale, event.change, event.parents) for event in many}
    assert {(event.scale, event.change, event.parents) for event in few} <= found


def test_a_list_of_events_is_a_sequence() -> None:
    found = events(G1, G2, "pair")
    assert found[0] == next(iter(found)) and found[-1] == found[len(found) - 1]
    assert found[2:5] == list(found)[2:5] and found[0] in found
    assert sorted(found, key=lambda event: event.scale) == list(found)
    assert len({*found}) == len(found)
    with pytest.raises(IndexError, match=f"there are {len(found)} events"):
        found[len(found)]


def test_a_hole_is_born_where_the_square_stops_to_fit_it() -> None:
    (born,) = events(FRAME, SQUARE, "topology")
    assert (born.scale, born.feature, born.change) == (Fraction(1, 2), "hole", "birth")
    assert born.at == (Fraction(3, 2), Fraction(3, 2))
    assert not events(FRAME, SQUARE, "topology", from_scale="0.6")
    assert len(events(FRAME, SQUARE, "topology", where="change = birth and s <= 1/2")) == 1
    assert repr(events(FRAME, SQUARE, "topology")) == "<Events: 1 topology events at 1 scales>"


@pytest.mark.parametrize(
    ("wrong", "code"),
    [
        ({"kind": "x"}, "unknown-kind"),
        ({"route": "paper"}, "unknown-route"),
        ({"form": "x"}, "unknown-form"),
        ({"kind": "pair", "route": "index"}, "usage"),
        ({"form": "printed"}, "usage"),
    ],
    ids=str,
)
def test_what_there_is_not_is_refused(wrong: dict[str, str], code: str) -> None:
    with pytest.raises(minkref.Refusal) as refused:
        events(FRAME, SQUARE, **wrong)
    assert refused.value.code == code and refused.value.mend


def test_empty_windows_and_invalid_operands_are_refused() -> None:
    with pytest.raises(minkref.BadInput, match="the window"):
        events(FRAME, SQUARE, "boundary", 2, 1)
    with pytest.raises(minkref.BadInput, match="cross"):
        events(PolygonSet([(0, 0), (1, 1), (1, 0), (0, 1)], validate=False), SQUARE)
    with pytest.raises(minkref.Refusal, match="boundary events know no holes"):
        _ = events(FRAME, SQUARE).holes
