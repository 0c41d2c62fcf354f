"""--index and the route index of `view`: a page shows the same by both routes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from index_runs import Minkref, Window, ask, build, operands, window_options
from minkref.plane.operand import read_operand
from minkref.reports.evidence.pages.view import difference, true_polygons
from page_decoder import Decoder, data_of


def page_data(minkref: Minkref, page: Path, *arguments: str | Path) -> tuple[Any, dict[str, Any]]:
    value = ask(minkref, "view", *arguments, "-o", page)
    return value, data_of(page.read_text(encoding="utf-8"))


@pytest.mark.parametrize("window", [(None, None), ("1/2", "2")])
@pytest.mark.parametrize("name", ["letters", "islands", "several components"])
def test_a_page_shows_the_same_by_both_routes(
    minkref: Minkref, tmp_path: Path, name: str, window: Window
) -> None:
    P, Q = operands(tmp_path, name)
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q, "--from", window[0] or "1/10", "--to", window[1] or "10")
    pages = [
        page_data(minkref, tmp_path / "page.html", P, Q, *route)
        for route in (
            ["--index", path],
            [*window_options(window), "--route", "index"],
            [*window_options(window), "--route", "dynamic"],
        )
    ]
    assert [value["route"] for value, _ in pages] == ["index", "index", "dynamic"]
    moved, expected = pages[-1]
    counts = ("from", "to", "segments", "boundary_events", "topology_events", "holes",
              "components", "tracks")  # fmt: skip
    for value, data in pages[:-1]:
        assert [value[field] for field in counts] == [moved[field] for field in counts]
        for field in ("window", "P", "Q", "S", "T", "scales", "about", "kinds", "holes",
                      "components"):  # fmt: skip
            assert data[field] == expected[field], field
        # Compares without places, which each route may choose freely.
        topology = [[row[:-1] for row in page["topology"]] for page in (data, expected)]
        assert topology[0] == topology[1]
        decoders = Decoder(data), Decoder(expected)
        assert len(data["states"]) == len(expected["states"])
        ends = [expected["window"][0][1], *expected["about"], expected["window"][1][1]]
        for state in range(0, len(expected["states"]), 1 + len(expected["states"]) // 20):
            scale = (ends[state] + ends[state + 1]) / 2
            assert drawn(decoders[0], state, scale) == drawn(decoders[1], state, scale)


def drawn(page: Decoder, state: int, scale: float) -> Any:
    """A state's rings as points, with their features, in a fixed order."""
    rings = []
    for is_hole, component, hole, tracks in page.rings(state).values():
        points = [page.point(track, scale) for track in tracks]
        least = points.index(min(points))
        rings.append((is_hole, component, hole, points[least:] + points[:least]))
    return sorted(rings)


def test_a_page_of_a_part_of_the_window_shows_that_part(
    minkref: Minkref, letters: Path, tmp_path: Path
) -> None:
    window = ("--from", "1/3", "--to", "5/2")
    page = tmp_path / "page.html"
    value, data = page_data(minkref, page, "g1", "g2", "--index", letters, *window)
    moved, expected = page_data(minkref, page, "g1", "g2", "--route", "dynamic", *window)
    assert data["scales"] == expected["scales"]
    assert data["kinds"] == expected["kinds"]
    for field in ("boundary_events", "topology_events", "holes", "components"):
        assert value[field] == moved[field], field
    P, Q = read_operand("g1").set, read_operand("g2").set
    decoder = Decoder(data)
    for scale in (0.334, 0.5123, 1.0077, 1.77, 2.4987):
        assert difference(decoder.polygons(scale), true_polygons(P, Q, scale)) < 1e-9


def test_a_view_of_an_open_index_begins_and_ends_where_views_do(
    minkref: Minkref, tmp_path: Path
) -> None:
    path = tmp_path / "sums.index"
    build(minkref, path, "g3", "g1")
    value = ask(minkref, "view", "g3", "g1", "--index", path, "-o", tmp_path / "page.html")
    assert (value["from"], value["to"]) == ("1/10", "10")
