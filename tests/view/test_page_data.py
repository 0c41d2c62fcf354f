"""The page's data, decoded by an independent reader, against `minkref sum`."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref import _core
from minkref.fuzz.plane.families.random_pairs import random_pair
from minkref.plane.operand import read_operand
from minkref.plane.page.boundary import Sums, Window
from minkref.plane.page.linear import linear
from minkref.plane.page.picture import picture
from minkref.reports.evidence.pages.view import difference, true_polygons
from page_decoder import Decoder, data_of, page_of, scales
from thoroughness import THOROUGH, draws, some

CLOSE = 1e-9  # diagonals


ROUTES: dict[str, Callable[..., Sums]] = {"index": _core.ScaleIndex, "dynamic": _core.DynamicSum}


def page_data(
    P: _core.PolygonSet, Q: _core.PolygonSet, window: Window, route: str = "index"
) -> dict[str, Any]:
    found = ROUTES[route]
    return picture(
        P, Q, window, lambda: found(P, Q, window.first, window.last), lambda done, total: None
    )


def decoder(P: _core.PolygonSet, Q: _core.PolygonSet, route: str = "index") -> Decoder:
    return Decoder(page_data(P, Q, Window("1/10", "10"), route))


def shape(polygons: str) -> _core.PolygonSet:
    return _core.PolygonSet.from_json(polygons)


@pytest.mark.parametrize("index", some([*range(0, 60, 3), *range(1800, 1820)], 12))
def test_random_pairs_at_fifty_scales(index: int) -> None:
    pair = random_pair(2012, index)
    P, Q = shape(pair.P), shape(pair.Q)
    decoded = decoder(P, Q)
    for scale in scales(draws(20, 50), index):
        assert difference(decoded.polygons(scale), true_polygons(P, Q, scale)) < CLOSE, scale


@pytest.mark.parametrize("index", range(5))
def test_random_pairs_by_the_dynamic_route_too(index: int) -> None:
    pair = random_pair(2012, index)
    P, Q = shape(pair.P), shape(pair.Q)
    by_steps = decoder(P, Q, "dynamic")
    read_off = decoder(P, Q)
    for name in ("scales", "kinds", "holes", "components"):
        assert by_steps.data[name] == read_off.data[name]
    for scale in scales(10, index):
        assert difference(by_steps.polygons(scale), true_polygons(P, Q, scale)) < CLOSE, scale


def test_disc_and_cells_at_fifty_scales(tmp_path: Path) -> None:
    """Or the disc and a glyph, at fewer."""
    names = "disc1", "cells1815" if THOROUGH else "glyph275"
    page = page_of(tmp_path, *names)
    decoded = Decoder(data_of(page.read_text(encoding="utf-8")))
    P, Q = (read_operand(name).set for name in names)
    for scale in scales(draws(8, 50), 7):
        assert difference(decoded.polygons(scale), true_polygons(P, Q, scale)) < CLOSE, scale
    assert page.stat().st_size < 2_000_000


def test_a_state_costs_what_is_new_in_it() -> None:
    decoded = decoder(read_operand("g1").set, read_operand("glyph275").set)
    states = decoded.data["states"]
    stored = sum(len(splice) for state in states for ring in state[1:] for splice in ring[4:])
    whole = sum(
        len(ring[3]) for state in range(len(states)) for ring in decoded.rings(state).values()
    )
    assert len(states) > 200
    assert stored < whole / 20


def test_events_and_lives_are_those_of_the_dynamic_sum() -> None:
    P, Q = read_operand("g1").set, read_operand("g2").set
    data = decoder(P, Q).data
    dynamic = _core.DynamicSum(P, Q, "1/10", "10")
    boundary = dynamic.boundary_events()
    assert data["scales"] == [row[0] for row in boundary]
    assert len(data["kinds"]) == len(data["scales"]) == len(data["states"]) - 1
    assert data["about"] == [float(Fraction(scale)) for scale in data["scales"]]
    changes = [(data["scales"][row[0]], row[2]) for row in data["topology"]]
    assert changes == [(row[0], row[2]) for row in dynamic.topology_events()]
    for life, (born, died) in zip(data["holes"], dynamic.features("hole"), strict=True):
        assert [born and data["scales"].index(born), died and data["scales"].index(died)] == [
            None if life[0] < 0 else life[0],
            None if life[1] == len(data["scales"]) else life[1],
        ]


def test_holes_are_there_from_birth_to_death() -> None:
    decoded = decoder(read_operand("g1").set, read_operand("g2").set)
    for state in range(len(decoded.data["states"])):
        drawn = {ring[2] for ring in decoded.rings(state).values() if ring[0]}
        alive = {
            hole
            for hole, life in enumerate(decoded.data["holes"])
            if hole and life[0] < state <= life[1]
        }
        assert drawn == alive


def test_a_track_lives_from_its_first_state_to_its_last() -> None:
    data = (decoded := decoder(read_operand("g1").set, read_operand("g2").set)).data
    seen: dict[int, list[int]] = {}
    for state in range(len(data["states"])):
        for ring in decoded.rings(state).values():
            for track in ring[3]:
                seen.setdefault(track, [state, state])[1] = state
    assert [seen[track] for track in sorted(seen)] == [
        data["lives"][i : i + 2] for i in range(0, len(data["lives"]), 2)
    ]


def test_events_at_the_ends_of_the_window_are_in_it() -> None:
    P, Q = read_operand("g1").set, read_operand("g2").set
    every = _core.DynamicSum(P, Q, "1/10", "10").boundary_events()
    first, last = every[10][0], every[40][0]
    data = page_data(P, Q, Window(first, last))
    assert data["scales"] == [row[0] for row in every[10:41]]
    middle = float((Fraction(every[20][0]) + Fraction(every[21][0])) / 2)
    assert difference(Decoder(data).polygons(middle), true_polygons(P, Q, middle)) < CLOSE


def test_components_that_touch_at_all_scales_around_a_hole() -> None:
    corners = [(1, 0), (0, 1), (2, 1), (1, 2)]
    squares = ",".join(
        f"(({x} {y},{x + 1} {y},{x + 1} {y + 1},{x} {y + 1},{x} {y}))" for x, y in corners
    )
    P = _core.read_text(f"MULTIPOLYGON({squares})", "wkt", "P")
    Q = _core.read_text("POINT(5 7)", "wkt", "Q")
    decoded = decoder(P, Q)
    assert [life is not None for life in decoded.data["holes"]] == [True, True]
    assert len(decoded.data["components"]) == 4
    assert difference(decoded.polygons(1.3), true_polygons(P, Q, 1.3)) < CLOSE


def test_coordinates_that_cancel_are_given_from_where_they_are_small() -> None:
    a, b = Fraction(10**15, 3), -Fraction(10**15, 7)
    r, m, c = linear(a, b, Fraction(10), Fraction(100))
    assert c == pytest.approx(7 / 3)
    s = 7 / 3 + 1e-13
    assert r + m * (s - c) == pytest.approx(float(a + b * Fraction(s)), rel=1e-12)
    assert linear(Fraction(3), Fraction(-2), Fraction(10), Fraction(5)) == [3.0, -2.0, 0.0]
