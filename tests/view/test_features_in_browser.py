"""The page of features, with headless Chromium: its features, bridges, regions and pocket minima
against `Features`, its controls."""

from __future__ import annotations

import math
import random
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref.disc.features import Bridge, Features
from minkref.plane.operand import read_operand
from minkref.reports.evidence.framework.browser import Browser, absent
from page_decoder import data_of, page_of
from thoroughness import draws

pytestmark = pytest.mark.skipif(absent() is not None, reason=f"no browser: {absent()}")

SHOTS = Path(__file__).resolve().parents[2] / "build" / "view"
DRAWN = "return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
TEXT = "return document.getElementById(arguments[0]).textContent"
PICTURE = "return document.getElementById('sum').toDataURL()"
BARS = "return document.querySelectorAll('#barcode .bar').length"
AT = "return window.minkref.features(arguments[0])"
U = "POLYGON ((0 0, 6 0, 6 6, 4 6, 4 1, 2 1, 2 6, 0 6, 0 0))"
FRAME = "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 2 6, 6 6, 6 2, 2 2))"
TWO = "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((4 0, 6 0, 6 2, 4 2, 4 0)))"
ISLAND = (
    "MULTIPOLYGON (((0 0, 90 0, 90 80, 0 80, 0 0), (10 10, 10 70, 80 70, 80 10, 10 10)), "
    "((30 30, 40 33, 35 45, 30 30)))"
)
TOUCHING = "MULTIPOLYGON (((0 0, 4 0, 2 3, 0 0)), ((2 3, 4 6, 0 6, 2 3)))"
SHAPES = (U, FRAME, TWO, ISLAND, TOUCHING, "g1", "glyph275", "LINESTRING (0 0, 3 1)", "POINT (1 2)")


def opened(window: Browser, folder: Path, P: str, *options: str) -> dict[str, Any]:
    """Opens the page of P, and returns its data."""
    page = page_of(folder, P, "--features", *options)
    window.prefer("light")
    window.open(page)
    window.run(DRAWN)
    return data_of(page.read_text(encoding="utf-8"))


def diameters(data: dict[str, Any]) -> list[float]:
    """The ends of the window, and some around events."""
    print("seed 2012")
    dice = random.Random(2012)
    radii = data["radii"] or [about for _, about in data["window"]]
    some = [2 * dice.choice(radii) * dice.uniform(0.9, 1.2) for _ in range(draws(6, 20))]
    return [2 * about for _, about in data["window"]] + some


@pytest.mark.parametrize("shape", SHAPES)
def test_features_bridges_regions_and_pockets_are_those_of_features(
    window: Browser, tmp_path: Path, shape: str
) -> None:
    data = opened(window, tmp_path, shape)
    P = read_operand(shape).set
    found = Features(P)
    size = max(map(abs, P.bounding_box()))
    for alpha in diameters(data):
        close = 1e-9 * (size + alpha)
        got = window.run(AT, alpha)
        alive = {one.bar: one for one in found.at(Fraction(alpha))}
        shown = {one["bar"]: one for one in got if one["bar"] is not None}
        assert shown.keys() == alive.keys(), alpha
        assert sorted(window.run("return window.minkref.bars(arguments[0])", alpha)) == sorted(
            alive
        )
        for bar, one in alive.items():
            bridges, true = shown[bar]["bridges"], one.bridges
            assert len(bridges) == len(true), (alpha, bar)
            for bridge in bridges:
                assert min(_apart(bridge, other) for other in true) < close, (alpha, bar)
            for other in true:
                assert min(_apart(bridge, other) for bridge in bridges) < close, (alpha, bar)
            pocket, leaf = shown[bar]["pocket"], one.deepest
            assert (pocket is None) == (leaf is None)
            if leaf is None:
                continue
            vertex = found.tree[leaf].vertex
            assert vertex is not None
            assert math.dist(pocket["vertex"], tuple(map(float, vertex))) < close, (alpha, bar)
            depth = math.inf if pocket["depth"] is None else pocket["depth"]
            assert one.depth is not None
            assert depth == pytest.approx(one.depth[0], abs=close)
        regions = found.regions(Fraction(alpha)).features
        areas = sorted(region.area[0] for region in regions)
        assert sorted(one["area"] for one in got) == pytest.approx(
            areas, abs=close * (size + alpha)
        )
        by_node = {region.node: region.area[0] for region in regions}
        for bar, one in alive.items():
            assert shown[bar]["area"] == pytest.approx(
                by_node[one.node], abs=close * (size + alpha)
            )
    assert window.messages() == []


def _apart(bridge: list[list[float]], other: Bridge) -> float:
    """How far the feet are from those of the other, either way round, and the centres."""
    feet = min(max(map(math.dist, bridge[:2], ends)) for ends in (other.near, other.near[::-1]))
    return max(feet, math.dist(bridge[2], other.centre))


def test_bars_of_the_page_are_those_of_features(window: Browser, tmp_path: Path) -> None:
    data = opened(window, tmp_path, "glyph275")
    found = Features(read_operand("glyph275").set)
    last = len(data["radii"]) + 1
    assert len(data["bars"]) == len(found.bars)
    for (leaf, birth, death, end, essential), bar in zip(data["bars"], found.bars, strict=True):
        assert (leaf, end, bool(essential)) == (bar.leaf, bar.end, bar.essential)
        for number, (low, high) in ((birth, bar.birth), (death, bar.death)):
            alpha = math.inf if number == last else 2 * data["radii"][number - 1] if number else 0
            assert low <= alpha <= high


def test_the_persistence_hides_shorter_bars_and_their_features(
    window: Browser, tmp_path: Path
) -> None:
    opened(window, tmp_path, "glyph275")
    found = Features(read_operand("glyph275").set)
    window.run("window.minkref.moveTo(2)")
    window.run(DRAWN)
    all_bars, before = window.run(BARS), window.run(PICTURE)
    for length in (1, 10):
        window.run("window.minkref.setPersistence(arguments[0])", length)
        window.run(DRAWN)
        long = {
            k for k, bar in enumerate(found.bars) if bar.essential or bar.persistence[0] > length
        }
        assert window.run(BARS) <= len(long) < all_bars
        alive = {one.bar for one in found.at(2)}
        assert set(window.run("return window.minkref.bars(2)")) == alive & long
        told = window.run(TEXT, "situation")
        assert told.startswith(f"{len(alive & long)} of {len(alive)} feature")
    assert window.run(PICTURE) != before
    SHOTS.mkdir(parents=True, exist_ok=True)
    window.save_screenshot(SHOTS / "features.png")
    assert window.messages() == []


def test_a_change_shows_the_features_just_below(window: Browser, tmp_path: Path) -> None:
    """Arms as far apart as the bay is wide: at the merge the bay has its bottom corners still."""
    opened(window, tmp_path, U)
    alphas = window.run("return window.minkref.alphas")
    found = Features(read_operand(U).set)
    exact = sorted({node.alpha for node in found.tree if 0 < node.alpha[0] < math.inf})
    assert len(alphas) == len(exact)
    assert all(low <= alpha <= high for alpha, (low, high) in zip(alphas, exact, strict=True))
    window.run("window.minkref.goToChange(0)")
    window.run(DRAWN)
    alive = len(found.at(2))
    assert exact[0] == (2.0, 2.0)
    assert window.run(TEXT, "situation").startswith(f"{alive} of {alive} feature")


def test_a_bar_that_is_clicked_is_told_and_kept(window: Browser, tmp_path: Path) -> None:
    opened(window, tmp_path, U)
    window.run("document.querySelector('#barcode .bar').dispatchEvent(new MouseEvent('click'))")
    window.run(DRAWN)
    chosen = window.run("return window.minkref.chosen")
    bar = Features(read_operand(U).set).bars[chosen]
    alpha = window.run("return window.minkref.alpha")
    assert bar.birth[0] < alpha <= bar.death[1]
    told = window.run(TEXT, "chosen")
    assert f"feature {chosen}" in told
    assert "pocket minimum (" in told
    before = window.run(PICTURE)
    window.run(
        "const bars = document.querySelectorAll('#barcode .bar');"
        "bars[1].dispatchEvent(new PointerEvent('pointermove', {clientX: 1, clientY: 1}))"
    )
    window.run(DRAWN)
    assert window.run(PICTURE) != before


def test_an_empty_operand_has_a_page(window: Browser, tmp_path: Path) -> None:
    opened(window, tmp_path, "POLYGON EMPTY")
    assert window.run(AT, 1) == []
    assert window.messages() == []
