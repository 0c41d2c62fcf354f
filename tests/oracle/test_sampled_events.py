"""The judge of boundary events alone: hand-computed events, and laws that it must keep."""

from __future__ import annotations

import json
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import pytest
from minkref.fuzz.judges.plane.sampled_events import SampledEvents
from minkref.fuzz.plane.families.lattice_pairs import lattice_pair

Ring = list[tuple[int, int]]
SEED = 71


def rings(*polygons: list[Ring]) -> dict[str, Any]:
    return {"polygons": [{"outer": outer, "holes": holes} for outer, *holes in polygons]}


@pytest.fixture(scope="module")
def server() -> Iterator[SampledEvents]:
    with SampledEvents() as found:
        yield found


@pytest.fixture
def ask(server: SampledEvents) -> Any:
    def asked(P: Any, Q: Any, **members: Any) -> dict[str, Any]:
        return server.ask("sampled-events", {"P": P, "Q": Q}, **members)

    return asked


UNIT = rings([[(0, 0), (1, 0), (1, 1), (0, 1)]])
FRAME = rings([[(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (1, 2), (2, 2), (2, 1)]])
SQUARE, WITH_HOLE, GONE = [1, 4, 1, 0], [2, 8, 1, 1], [1, 4, 1, 0]


def test_a_square_fills_the_hole_of_a_frame_at_scale_one(ask: Any) -> None:
    found = ask(UNIT, FRAME)
    event = {"s": "1", "below": WITH_HOLE, "at": GONE, "above": SQUARE, "same": False}
    assert (found["before"], found["events"]) == (WITH_HOLE, [event])


def test_a_hole_dies_where_three_edges_meet_in_a_point(ask: Any) -> None:
    """The example of docs/definitions.md, where no two edges begin or cease to meet."""
    P = rings([[(-3, -2), (4, -1), (1, 3)]])
    frame: Ring = [(-40, -40), (40, -40), (40, 40), (-40, 40)]
    found = ask(P, rings([frame, [(0, 20), (17, -11), (-19, -9)]]))
    assert [event["s"] for event in found["events"]] == ["541/186"]
    assert [found["events"][0][name][3] for name in ("below", "at", "above")] == [1, 0, 0]


SHRINKING = rings([[(-1, -1), (0, -1), (0, 0)]], [[(1, 1), (0, 2), (0, 1)]])
GROWING = rings([[(0, 2), (0, 0), (1, 0)]], [[(-2, 1), (-3, -1), (-2, 0)]])


def test_an_edge_that_shrinks_to_a_point_and_grows_again_reversed_is_an_event(ask: Any) -> None:
    """Below and above the event the moving boundary is the same."""
    found = ask(SHRINKING, GROWING, **{"from": "7/5", "to": "8/5"})
    (event,) = found["events"]
    vertices = [event[name][1] for name in ("below", "at", "above")]
    assert (event["s"], vertices, event["same"]) == ("3/2", [21, 20, 21], True)


def box(x: int, y: int) -> list[Ring]:
    return [[(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]]


def test_parts_that_touch_corner_to_corner_at_one_scale_only_have_an_event(ask: Any) -> None:
    """The box from (0,0) to (s+1,s+1), and a box with least corner (10s-8,13-11s): the second box
    lies above the first for s < 1, and right of it for s > 1. At s = 1 both boxes share the corner
    (2,2). The other two boxes are far away."""
    P, Q = rings(box(0, 0), box(10, -11)), rings(box(0, 0), box(-8, 13))
    found = ask(P, Q, **{"from": "9/10", "to": "11/10"})
    state = [4, 16, 4, 0]
    event = {"s": "1", "below": state, "at": state, "above": state, "same": True}
    assert found["events"] == [event]


def test_a_segment_and_a_ring_that_touches_another(ask: Any) -> None:
    """Along (2,0) the hole is 3 wide at y = 1, between (-3,1) and (0,1), and narrower elsewhere."""
    triangle: list[Ring] = [[(0, 7), (-5, -3), (1, 0)], [(-3, 1), (0, 1), (0, 0)]]
    found = ask(rings([[(0, 0), (2, 0)]]), rings(triangle))
    assert [(e["s"], e["below"][3], e["above"][3]) for e in found["events"]] == [("3/2", 1, 0)]


def test_a_point_moves_the_other_operand_and_nothing_happens(ask: Any) -> None:
    for P, Q in ((rings([[(3, 5)]]), FRAME), (FRAME, rings([[(3, 5)]]))):
        found = ask(P, Q)
        assert (found["events"], found["before"]) == ([], WITH_HOLE)


def test_windows_are_closed_and_tell_the_state_outside(ask: Any) -> None:
    whole = ask(SHRINKING, GROWING)["events"]
    scales = [Fraction(event["s"]) for event in whole]
    for k, low in enumerate(scales):
        for m, high in enumerate(scales[k:], start=k):
            found = ask(SHRINKING, GROWING, **{"from": str(low), "to": str(high)})
            assert found["events"] == whole[k : m + 1]
            assert found["before"] == whole[k]["below"]


def operands(number: int) -> tuple[Any, Any]:
    pair = lattice_pair(SEED, number)
    return json.loads(pair.P), json.loads(pair.Q)


def test_candidates_within_the_sum_are_no_events(ask: Any) -> None:
    """Left out or not, the events are the same."""
    left_out = 0
    for number in range(150):
        P, Q = operands(number)
        few, all_of_them = ask(P, Q), ask(P, Q, all=True)
        assert few["events"] == all_of_them["events"], (SEED, number)
        left_out += all_of_them["candidates"] - few["candidates"]
    assert left_out > 0


@pytest.mark.parametrize(("factor", "bits"), [(1, 64), (10**9, 128), (10**40, 0)])
def test_the_width_of_the_integers_changes_nothing(ask: Any, factor: int, bits: int) -> None:
    def enlarged(operand: Any) -> Any:
        return rings(
            *[
                [
                    [(int(x) * factor, int(y) * factor) for x, y in ring]
                    for ring in (p["outer"], *p["holes"])
                ]
                for p in operand["polygons"]
            ]
        )

    def as_text(operand: dict[str, Any]) -> Any:
        return json.loads(json.dumps(operand), parse_int=str)

    for number in range(12):
        P, Q = operands(number)
        found = ask(as_text(enlarged(P)), as_text(enlarged(Q)))
        assert found["bits"] == bits
        assert found["events"] == ask(P, Q)["events"], (SEED, number)


def test_scales_are_inverted_where_the_operands_change_places(ask: Any) -> None:
    """sP + Q is s (P + Q / s)."""
    for number in range(40):
        P, Q = operands(number)
        one, other = ask(P, Q)["events"], ask(Q, P)["events"]
        assert [(e["s"], e["at"]) for e in one] == [
            (str(1 / Fraction(e["s"])), e["at"]) for e in reversed(other)
        ], (SEED, number)


@pytest.mark.parametrize(
    ("P", "Q", "status"),
    [
        (rings([[(0, 0), (1, 1)]]), rings([[(2, 2)]]), "skipped"),
        (rings([[(0, 0), (1, 0), (1, 1), (0, 0)]]), UNIT, "errored"),
        (rings([[(0, 0), (2, 2), (2, 0), (0, 2)]]), UNIT, "errored"),
        ({"polygons": [{"outer": [["0", "x"]]}]}, UNIT, "errored"),
        ({}, UNIT, "errored"),
    ],
)
def test_what_is_no_question_has_a_reason(ask: Any, P: Any, Q: Any, status: str) -> None:
    found = ask(P, Q)
    assert found["status"] == status and found["reason"]
