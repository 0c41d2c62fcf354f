"""The page of a path in headless Chromium: the diagram against valid scales of single places, the
sliders, the cross-hair, the bounds."""

from __future__ import annotations

import random
from fractions import Fraction
from pathlib import Path
from typing import Any

import minkref
import pytest
from minkref.fuzz.motion.path_cases import path_case, texts
from minkref.motion.path_text import read_path
from minkref.plane.operand import read_operand
from minkref.reports.evidence.framework.browser import Browser, absent
from page_decoder import data_of, page_of
from thoroughness import some

pytestmark = pytest.mark.skipif(absent() is not None, reason=f"no browser: {absent()}")

SHOTS = Path(__file__).resolve().parents[2] / "build" / "view"
DRAWN = "return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
TEXT = "return document.getElementById(arguments[0]).textContent"
PICTURE = "return document.getElementById(arguments[0]).toDataURL()"
SLIDE = (
    "const slider = document.getElementById(arguments[0]); slider.value = arguments[1];"
    "slider.dispatchEvent(new Event('input'))"
)
COLLIDE = "return arguments[0].map((at) => window.minkref.collides(...at))"

BOLT = "POLYGON ((-4 -30, 4 -30, 4 0, 9 0, 9 6, -9 6, -9 0, -4 0, -4 -30))"
BRACKET = (
    "MULTIPOLYGON (((-24 -8, -4.2 -8, -4.2 0, -24 0, -24 -8)), "
    "((4.3 -8, 24 -8, 24 10, 9.6 10, 9.6 0, 4.3 0, 4.3 -8)))"
)
WAY = "LINESTRING (-3 45, -3 34, 0 31.6, 0 0)"
PART = "POLYGON((2 0,3 0,3 1,2 1,2 0))"
WALLS = "MULTIPOLYGON(((1 0,4 0,4 1,1 1,1 0)),((6 0,9 0,9 1,6 1,6 0)))"


def opened(window: Browser, folder: Path, *words: str) -> dict[str, Any]:
    """Opens the page of a part, obstacles, `--path` and a path, and options; its data."""
    page = page_of(folder, *words)
    window.prefer("light")
    window.open(page)
    window.run(DRAWN)
    return data_of(page.read_text(encoding="utf-8"))


def press(window: Browser, key: str) -> None:
    window.run("dispatchEvent(new KeyboardEvent('keydown', {key: arguments[0]}))", key)
    window.run(DRAWN)


def agrees(window: Browser, data: dict[str, Any], shapes: tuple[Any, Any], way: Any) -> None:
    """Compares random places and scales on the page with each place's own valid scales, which do
    not come from the path's polygons."""
    part, obstacles = shapes
    dice = random.Random("2012")
    low, high = (about for _, about in data["window"])
    asked = []
    for _ in range(60):
        segment = dice.randrange(max(len(way) - 1, 1))
        is_point = len(way) == 1 or way[segment] == way[segment + 1]
        asked.append([segment, 0.0 if is_point else dice.random(), dice.uniform(low, high)])
    for (segment, t, scale), got in zip(asked, window.run(COLLIDE, asked), strict=True):
        start, end = way[segment], way[min(segment + 1, len(way) - 1)]
        at = [
            Fraction(a) + Fraction(t) * (Fraction(b) - Fraction(a))
            for a, b in zip(start, end, strict=True)
        ]
        free = minkref.valid_scales(part, obstacles, [at], data["contact"])
        # Doubles may err within a hair of a bound.
        if all(abs(bound.scale - Fraction(scale)) > 1e-9 * scale for bound in free.bounds):
            assert got == (Fraction(scale) not in free), (segment, t, scale)


@pytest.mark.parametrize("contact", ["allowed", "forbidden"])
def test_the_diagram_says_what_collides(window: Browser, tmp_path: Path, contact: str) -> None:
    words = (BOLT, BRACKET, "--path", WAY, "--contact", contact)
    data = opened(window, tmp_path, *words)
    shapes = (read_operand(BOLT).set, read_operand(BRACKET).set)
    agrees(window, data, shapes, read_path(WAY).points)
    SHOTS.mkdir(parents=True, exist_ok=True)
    window.save_screenshot(SHOTS / f"path-{contact}.png")
    window.prefer("dark")
    window.run(DRAWN)
    window.save_screenshot(SHOTS / f"path-{contact}-dark.png")
    assert window.messages() == []


def test_the_diagram_says_what_collides_on_random_paths(window: Browser, tmp_path: Path) -> None:
    for index in some(range(12), 4):
        case = path_case(2012, index)
        (tmp_path / "part.json").write_text(case.part.to_json(), encoding="utf-8")
        (tmp_path / "obstacles.json").write_text(case.obstacles.to_json(), encoding="utf-8")
        way = texts(case.path)
        (tmp_path / "way.csv").write_text("".join(f"{x},{y}\n" for x, y in way), encoding="utf-8")
        files = [str(tmp_path / name) for name in ("part.json", "obstacles.json", "way.csv")]
        contact = ("allowed", "forbidden")[index // 3 % 2]  # a third of the cases is degenerate
        data = opened(window, tmp_path, *files[:2], "--path", files[2], "--contact", contact)
        agrees(window, data, (case.part, case.obstacles), way)
        found = minkref.valid_scales(case.part, case.obstacles, case.path, contact)
        scales = [str(bound.scale) for bound in found.bounds] + ["1", "7/5", "1/3"]
        got = window.run("return arguments[0].map(window.minkref.isValid)", scales)
        assert got == [scale in found for scale in scales]
        assert window.messages() == []


def test_sliders_move_the_part(window: Browser, tmp_path: Path) -> None:
    opened(window, tmp_path, BOLT, BRACKET, "--path", WAY, "--to", "2")
    before = window.run(PICTURE, "picture")
    window.run(SLIDE, "slider", 0.25)
    window.run(SLIDE, "place-slider", 1)
    window.run(DRAWN)
    assert window.run("return window.minkref.scale") == 0.5
    place = window.run("return window.minkref.place")
    assert (place["segment"], place["t"], place["x"], place["y"]) == (2, 1, 0, 0)
    ring = window.run("return window.minkref.part")[0][0]
    assert ring[:4] == [-2, -15, 2, -15]
    assert window.run(PICTURE, "picture") != before
    assert "valid: the part passes" in window.run(TEXT, "situation")
    press(window, "Home")
    ring = window.run("return window.minkref.part")[0][0]
    assert ring[:4] == [-5, 30, -1, 30]
    press(window, "ArrowUp")
    assert window.run("return window.minkref.scale") == pytest.approx(0.51)
    window.run(SLIDE, "slider", 0.75)
    window.run(SLIDE, "place-slider", 0.9)
    window.run(DRAWN)
    assert "not valid, it collides here" in window.run(TEXT, "situation")


def test_the_cross_hair_is_dragged(window: Browser, tmp_path: Path) -> None:
    opened(window, tmp_path, BOLT, BRACKET, "--path", WAY, "--to", "2")
    window.run(
        "const svg = document.getElementById('diagram-axes'), box = svg.getBoundingClientRect();"
        "svg.setPointerCapture = () => {};"
        "const frame = document.querySelector('#diagram-axes .axis path').getBoundingClientRect();"
        "const at = (x, y) => ({clientX: frame.left + x * frame.width,"
        "  clientY: frame.bottom - y * frame.height, buttons: 1});"
        "svg.dispatchEvent(new PointerEvent('pointerdown', at(0.1, 0.1)));"
        "svg.dispatchEvent(new PointerEvent('pointermove', at(0.5, 0.75)));"
    )
    window.run(DRAWN)
    assert window.run("return window.minkref.scale") == pytest.approx(1.5, abs=0.02)
    assert window.run("return window.minkref.place.share") == pytest.approx(0.5, abs=0.01)
    hand = window.run(
        "const [hand, frame] = ['.hand', '.axis path'].map((name) =>"
        "  document.querySelector('#diagram-axes ' + name).getBoundingClientRect());"
        "return [(hand.x + hand.width / 2 - frame.x) / frame.width,"
        "  (frame.bottom - hand.y - hand.height / 2) / frame.height]"
    )
    assert hand == pytest.approx([0.5, 0.75], abs=0.02)
    assert float(window.run("return document.getElementById('slider').value")) == pytest.approx(
        0.75, abs=0.01
    )


def test_bounds_tell_their_contact_exactly(window: Browser, tmp_path: Path) -> None:
    data = opened(window, tmp_path, PART, WALLS, "--path", "POINT (0 0)")
    assert window.run(TEXT, "valid") == "(0, 1/3], 2 alone, [9/2, infinity)"
    bands = window.run("return document.querySelectorAll('#diagram-axes .valid-range').length")
    assert bands == 3
    scales = []
    for _ in data["bounds"]:
        scales.append(window.run("return document.getElementById('scale').value"))
        assert "valid: the part passes" in window.run(TEXT, "situation")
        press(window, "PageUp")
    assert scales == ["1/3", "2", "2", "9/2"]
    window.run("document.querySelectorAll('#events tbody tr')[2].click()")
    window.run(DRAWN)
    told = window.run(TEXT, "chosen")
    assert "At the scale 2 the contact blocks" in told
    assert "vertex 1 of the part and vertex 0 in ring 1 of the obstacles touch at (6, 0)" in told
    window.run(
        "document.querySelectorAll('#diagram-axes .bound')[0]"
        ".dispatchEvent(new PointerEvent('pointerdown', {bubbles: true}))"
    )
    window.run(DRAWN)
    assert window.run("return window.minkref.bound") == 0
    assert window.messages() == []


def test_a_scale_is_typed_exactly(window: Browser, tmp_path: Path) -> None:
    opened(window, tmp_path, PART, WALLS, "--path", "LINESTRING (0 0, 0 0.5)")
    enter = (
        "const field = document.getElementById('scale'); field.focus(); field.value = arguments[0];"
        "field.dispatchEvent(new Event('change')); return field.classList.contains('bad')"
    )
    tiny = "2.000000000000000000000001"
    for text, valid in (("1/3", True), ("2", True), (tiny, False), ("4.5", True), ("44/10", False)):
        assert window.run(enter, text) is False
        window.run(DRAWN)
        word = "valid: the part passes" if valid else "not valid"
        assert window.run(TEXT, "situation").startswith(word), text
    for text in ("-1", "x", "1/0", "", "100"):
        assert window.run(enter, text) is True, text


@pytest.mark.parametrize(
    ("part", "obstacles", "path"),
    [
        ("POLYGON EMPTY", WALLS, "POINT (0 0)"),
        (PART, "POLYGON EMPTY", "LINESTRING (0 0, 0 0, 1 0)"),
        ("POINT (1 1)", WALLS, "LINESTRING (0 0, 8 0)"),
        (PART, "LINESTRING (0 0, 9 3)", "LINESTRING (0 0, 0 0)"),
        (PART, WALLS, "LINESTRING (1e-9 0, 1e12 1)"),
        (PART, WALLS, "LINESTRING (1e308 1e308, -1e308 -1e308)"),
        ("POLYGON((2e-30 0,3e-30 0,3e-30 1e-30,2e-30 0))", WALLS, "LINESTRING (0 0, 3 0)"),
    ],
)
def test_unusual_paths_have_a_page(
    window: Browser, tmp_path: Path, part: str, obstacles: str, path: str
) -> None:
    opened(window, tmp_path, part, obstacles, "--path", path)
    for key in ("ArrowRight", "ArrowUp", "PageUp", "PageDown", "Home", "End"):
        press(window, key)
    assert window.run("return window.minkref.place.share") == 1
    assert window.messages() == []
