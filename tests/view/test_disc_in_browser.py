"""The page with a disc, with headless Chromium: its arcs against the sum, its controls and
marks."""

from __future__ import annotations

import math
import random
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref import _core
from minkref.plane.operand import read_operand
from minkref.reports.evidence.framework.browser import Browser, absent
from minkref.reports.evidence.pages.disc_rings import ring_difference, true_rings
from minkref.reports.evidence.pages.view import MARKS, OFFSETS
from page_decoder import data_of, page_of
from thoroughness import draws

pytestmark = pytest.mark.skipif(absent() is not None, reason=f"no browser: {absent()}")

SHOTS = Path(__file__).resolve().parents[2] / "build" / "view"
DRAWN = "return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
TEXT = "return document.getElementById(arguments[0]).textContent"
PICTURE = "return document.getElementById('sum').toDataURL()"
FRAME = "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 2 6, 6 6, 6 2, 2 2))"
L = "POLYGON ((0 0, 8 0, 8 1, 1 1, 1 5, 0 5, 0 0))"


def opened(window: Browser, folder: Path, P: str) -> dict[str, Any]:
    """Opens the page of P and a disc, and returns its data."""
    page = page_of(folder, P, "disc")
    window.prefer("light")
    window.open(page)
    window.run(DRAWN)
    return data_of(page.read_text(encoding="utf-8"))


def press(window: Browser, key: str) -> None:
    window.run("dispatchEvent(new KeyboardEvent('keydown', {key: arguments[0]}))", key)
    window.run(DRAWN)


@pytest.mark.parametrize(
    "shape",
    [
        "g1",
        FRAME,
        L,
        "POINT (1 2)",
        "LINESTRING (0 0, 3 1)",
        *(pytest.param(name, marks=pytest.mark.thorough) for name in ("glyph275", "cells1815")),
    ],
)
def test_arcs_lines_and_counts_are_those_of_the_sum(
    window: Browser, tmp_path: Path, shape: str
) -> None:
    data = opened(window, tmp_path, shape)
    P = read_operand(shape).set
    print("seed 2012")
    dice = random.Random(2012)
    radii = [about for _, about in data["window"]]
    radii += [
        dice.choice(data["radii"] or radii) * dice.uniform(0.9, 1.2) for _ in range(draws(5, 15))
    ]
    for radius, got in zip(radii, window.run(OFFSETS, radii), strict=True):
        assert ring_difference(got, true_rings(P, radius)) < 1e-9, radius
        counts = window.run("return window.minkref.counts(arguments[0])", radius)
        offset = _core.offset(P, str(Fraction(radius) ** 2))
        assert counts == {"components": offset.components, "holes": offset.holes}, radius
        rings = window.run("return window.minkref.rings(arguments[0])", radius)
        assert len({ring["hole"] for ring in rings} - {0}) == offset.holes
    assert window.messages() == []


def test_there_is_a_mark_and_a_row_for_each_event(window: Browser, tmp_path: Path) -> None:
    data = opened(window, tmp_path, "glyph275")
    assert window.run(MARKS) == len(data["kinds"]) > 100
    rows = "return document.querySelectorAll('#events tbody tr').length"
    assert window.run(rows) == sum(data["kinds"].count(kind) for kind in "srm")
    window.run("document.getElementById('show-all').click()")
    assert window.run(rows) == len(data["kinds"])
    bars = window.run("return document.querySelectorAll('#barcode .bar').length")
    assert bars == len(data["holes"])


def test_an_event_tells_its_features_and_what_it_changes(window: Browser, tmp_path: Path) -> None:
    opened(window, tmp_path, FRAME)
    press(window, "Home")
    before = window.run(PICTURE)
    press(window, "PageUp")
    assert window.run("return window.minkref.radius") == pytest.approx(2)
    told = window.run(TEXT, "chosen")
    assert "maximum at the radius 2, at (4, 4)" in told
    assert told.count("edge") == 4
    assert "hole 1 ends" in told
    assert "1 component, 0 holes" in window.run(TEXT, "situation")
    assert window.run(PICTURE) != before


def test_a_hole_is_pointed_at_and_kept(window: Browser, tmp_path: Path) -> None:
    opened(window, tmp_path, FRAME)
    press(window, "Home")
    at_the_middle = (
        "const canvas = document.getElementById('sum'), box = canvas.getBoundingClientRect();"
        "canvas.dispatchEvent(new PointerEvent(arguments[0], {"
        "clientX: box.left + box.width / 2, clientY: box.top + box.height / 2}))"
    )
    window.run(at_the_middle, "pointermove")
    tip = window.run(TEXT, "tip")
    assert "hole 1: a hole of P, there from the start" in tip
    assert "ends at the radius 2" in tip
    window.run(at_the_middle, "pointerup")
    window.run(DRAWN)
    assert "hole 1" in window.run(TEXT, "chosen")


def test_a_mark_is_clicked(window: Browser, tmp_path: Path) -> None:
    data = opened(window, tmp_path, "glyph275")
    window.run(
        "const strip = document.getElementById('strip'), box = strip.getBoundingClientRect();"
        "const mark = document.getElementById('marks-maximum').getAttribute('d');"
        "strip.setPointerCapture = () => {};"
        "strip.dispatchEvent(new PointerEvent('pointerdown', {"
        "clientX: box.left + parseFloat(mark.slice(1)), clientY: box.top + 20}))"
    )
    window.run(DRAWN)
    chosen = window.run("return window.minkref.chosen")
    assert chosen["feature"] == "e"
    number = data["numbers"][chosen["id"]] - 1
    assert window.run("return window.minkref.radius") == data["radii"][number]


@pytest.mark.parametrize("shape", [L, "glyph275"])
def test_places_of_the_diagram_have_two_nearest_points(
    window: Browser, tmp_path: Path, shape: str
) -> None:
    data = opened(window, tmp_path, shape)
    before = window.run(PICTURE)
    window.run("document.getElementById('show-diagram').click()")
    window.run(DRAWN)
    assert window.run(PICTURE) != before
    parts = window.run("return window.minkref.diagram()")
    assert len(parts) == len(data["halves"]) // 2
    assert any(part["bend"] for part in parts)
    edges = [
        tuple(data["features"][vertex] for vertex in (side[1], side[2]))
        for side in data["sides"]
        if not side[3]
    ]
    size = max(math.dist(*edge) for edge in edges)
    for part in parts:
        for share in (0.25, 0.6):
            at = _on_part(part, share)
            feet = sorted((math.dist(at, foot), foot) for foot in (_foot(at, *e) for e in edges))
            least = feet[0][0]
            near = [foot for distance, foot in feet if distance - least < 1e-9 * (size + least)]
            assert max(math.dist(near[0], foot) for foot in near) > 1e-6 * size, part
    SHOTS.mkdir(parents=True, exist_ok=True)
    window.save_screenshot(SHOTS / f"disc-{len(edges)}.png")
    window.prefer("dark")
    window.run(DRAWN)
    window.save_screenshot(SHOTS / f"disc-{len(edges)}-dark.png")
    assert window.messages() == []


def _on_part(part: dict[str, Any], share: float) -> list[float]:
    """A point of a line, or of a curve given by three points."""
    start, end = part["from"], part["to"]
    rest = 1 - share
    if part["bend"] is None:
        return [rest * start[k] + share * end[k] for k in (0, 1)]
    bend = part["bend"]
    return [rest**2 * start[k] + 2 * rest * share * bend[k] + share**2 * end[k] for k in (0, 1)]


def _foot(at: list[float], p: list[float], q: list[float]) -> list[float]:
    """The nearest point on a segment."""
    way = [q[k] - p[k] for k in (0, 1)]
    along = sum((at[k] - p[k]) * way[k] for k in (0, 1)) / sum(w * w for w in way)
    return [p[k] + min(max(along, 0.0), 1.0) * way[k] for k in (0, 1)]


def test_an_empty_operand_has_a_page(window: Browser, tmp_path: Path) -> None:
    opened(window, tmp_path, "POLYGON EMPTY")
    press(window, "ArrowRight")
    press(window, "PageUp")
    assert window.run("return window.minkref.rings(1)") == []
    assert window.messages() == []
