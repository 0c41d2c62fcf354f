"""Sums in space on the front page: by three routes, compared with each other, and drawn."""

from __future__ import annotations

import operator
import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref import _core
from minkref.fuzz.judges.space.space_nef import NefJudge
from minkref.fuzz.judges.space.space_planes import PlaneFaces, planes_of_solid, planes_of_text
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.generators.convex import box
from minkref.reports.conformance import space_showcase
from minkref.reports.conformance.page import write_report
from minkref.reports.conformance.solid_view import PAD, solid_view
from minkref.reports.conformance.space_showcase import (
    DEFINITION,
    EDGES,
    NEF,
    PAIRS,
    space_showcases,
    told,
)
from thoroughness import THOROUGH

WIDTH = 60


def block(*corners: tuple[int, int, int]) -> list[PlaneFaces]:
    low, high = (tuple(Fraction(n) for n in corner) for corner in corners)
    return planes_of_solid(box((low[0], low[1], low[2]), (high[0], high[1], high[2])))


def areas(svg: str) -> dict[str, int]:
    """Counts of grid points by shade."""
    found = {}
    for shade, runs in re.findall(r'class="sum (lit\d)" d="([^"]*)"', svg):
        found[shade] = sum(int(wide) for wide in re.findall(r"h(\d+)v", runs))
    return found


def test_a_cube_shows_three_faces_of_one_size() -> None:
    seen = areas(solid_view(block((0, 0, 0), (5, 5, 5)), "sum", "cube", WIDTH))
    rim = seen.pop("lit6")
    assert len(seen) == 3 and max(seen.values()) - min(seen.values()) < 40
    side = (WIDTH - 2 * PAD) / 2  # of the hexagon that it is seen as
    hexagon = 1.5 * 3**0.5 * side * side
    assert abs(rim + sum(seen.values()) - hexagon) < 0.06 * hexagon


def test_what_is_behind_is_hidden() -> None:
    front = block((4, 4, 4), (9, 9, 9))
    behind = block((0, 0, 0), (5, 5, 5))
    alone = solid_view(front, "sum", "cube", WIDTH)
    assert solid_view([*behind, *front], "sum", "cube", WIDTH) == alone
    assert solid_view(behind, "sum", "cube", WIDTH) == alone  # the same cube, moved


def test_planes_of_a_text_are_those_of_the_solid() -> None:
    solid = box((Fraction(0),) * 3, (Fraction(1), Fraction(2), Fraction(3)))
    body = core_polyhedron(solid)
    text = _core.edge_sum_in_space(body, body, ("1", "1", "1")).canonical_json()
    double = planes_of_solid(solid.scaled(Fraction(2)))
    key = operator.attrgetter("normal")
    assert sorted(planes_of_text(text), key=key) == sorted(double, key=key)


def test_nothing_is_drawn_of_the_empty_set() -> None:
    assert "<path" not in solid_view([], "sum", "a < b")
    assert "a &lt; b" in solid_view([], "sum", "a < b")


def test_all_give_the_same_sums_and_the_page_shows_them(
    made: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pairs = {title: PAIRS[title] for title in (PAIRS if THOROUGH else ("torus + L", "cup + L"))}
    monkeypatch.setattr(space_showcase, "NEF_SECONDS", 300.0)  # whatever the machine does beside
    monkeypatch.setattr(space_showcase, "PAIRS", pairs)
    shown = space_showcases()
    assert [show.title for show in shown] == list(pairs)
    with NefJudge(1) as nef:
        absent = nef.absence
    for show in shown:
        assert show.differ == []
        assert show.seconds[EDGES] and show.seconds[DEFINITION]
        assert (show.seconds[NEF] is None) == bool(absent)
        assert len(show.pictures) == 3
    line = told(shown)
    assert f"{len(pairs)} sums by edges, definition" in line and "all the same" in line
    wrong = [*shown[1:], replace(shown[0], differ=[DEFINITION])]
    assert f"NOT the same of {shown[0].title}" in told(wrong)
    write_report(tmp_path, made.run, made.groups, made.value, solids=shown)
    for name in ("index.html", "report.html"):
        html = (tmp_path / name).read_text(encoding="utf-8")
        assert '<h2 id="space">Sums in space</h2>' in html
        assert all(show.pictures[2][1] in html for show in shown)


@pytest.mark.parametrize("name", ["index.html", "report.html"])
def test_without_them_there_is_no_heading(made: Any, tmp_path: Path, name: str) -> None:
    write_report(tmp_path, made.run, made.groups, made.value)
    assert "Sums in space" not in (tmp_path / name).read_text(encoding="utf-8")
