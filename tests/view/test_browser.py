"""The page with headless Chromium: its rings against `minkref sum`, its controls and marks."""

from __future__ import annotations

import math
import random
from pathlib import Path
from typing import Any

import pytest
from minkref.plane.operand import read_operand
from minkref.reports.evidence.framework.browser import Browser, absent
from minkref.reports.evidence.pages.view import RINGS, difference, true_polygons
from page_decoder import data_of, page_of, scales
from selenium.common.exceptions import JavascriptException
from thoroughness import THOROUGH, draws

pytestmark = pytest.mark.skipif(absent() is not None, reason=f"no browser: {absent()}")

SHOTS = Path(__file__).resolve().parents[2] / "build" / "view"
DRAWN = "return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
VALUE = "return document.getElementById(arguments[0]).value"
TEXT = "return document.getElementById(arguments[0]).textContent"


def opened(window: Browser, page: Path) -> dict[str, Any]:
    """Opens the page and returns its data."""
    window.prefer("light")
    window.open(page)
    window.run(DRAWN)
    return data_of(page.read_text(encoding="utf-8"))


def press(window: Browser, key: str, shift: bool = False) -> None:
    event = "new KeyboardEvent('keydown', {key: arguments[0], shiftKey: arguments[1]})"
    window.run(f"dispatchEvent({event})", key, shift)
    window.run(DRAWN)


LARGE = pytest.param(("disc1", "cells1815"), marks=pytest.mark.thorough)


@pytest.mark.parametrize("names", [("g1", "g2"), ("g3", "disc1"), LARGE])
def test_rings_at_fifty_scales_are_those_of_the_sum(
    window: Browser, tmp_path: Path, names: tuple[str, str]
) -> None:
    opened(window, page_of(tmp_path, *names))
    P, Q = (read_operand(name).set for name in names)
    wanted = scales(draws(8, 50), 2012)
    random.Random(1).shuffle(wanted)  # back and forth
    for scale, got in zip(wanted, window.run(RINGS, wanted), strict=True):
        assert difference(got, true_polygons(P, Q, scale)) < 1e-9, scale
    SHOTS.mkdir(parents=True, exist_ok=True)
    window.save_screenshot(SHOTS / f"{names[0]}-{names[1]}.png")
    window.prefer("dark")
    window.run(DRAWN)
    window.save_screenshot(SHOTS / f"{names[0]}-{names[1]}-dark.png")
    assert window.messages() == []


def test_there_is_a_mark_for_each_boundary_event(window: Browser, tmp_path: Path) -> None:
    data = opened(window, page_of(tmp_path, "g1", "g2"))
    marks = window.run("return document.getElementById('marks').getAttribute('d')")
    assert marks.count("M") == len(data["scales"]) > 100
    assert window.run("return window.minkref.events") == data["scales"]
    bars = window.run("return document.querySelectorAll('#barcode .bar').length")
    assert bars == sum(life is not None for life in data["holes"][1:])
    listed = window.run("return document.querySelectorAll('#events tbody tr').length")
    assert listed == len(data["topology"])


def test_sliding_moves_the_scale_and_the_picture(window: Browser, tmp_path: Path) -> None:
    opened(window, page_of(tmp_path, "g1", "g2"))
    picture = "return document.getElementById('sum').toDataURL()"
    before = window.run(picture)
    window.run(
        "const slider = document.getElementById('slider'); slider.value = 0.75;"
        "slider.dispatchEvent(new Event('input'))"
    )
    window.run(DRAWN)
    assert window.run("return window.minkref.scale") == pytest.approx(math.sqrt(10))
    assert float(window.run(VALUE, "scale")) == pytest.approx(math.sqrt(10))
    assert window.run(picture) != before
    press(window, "ArrowLeft")
    assert window.run("return window.minkref.scale") == pytest.approx(10 ** (0.5 - 0.01))
    press(window, "End")
    assert window.run("return window.minkref.scale") == 10


def test_going_from_event_to_event_shows_each_scale_exactly(
    window: Browser, tmp_path: Path
) -> None:
    ends = () if THOROUGH else ("--from", "1", "--to", "3/2")
    data = opened(window, page_of(tmp_path, "g1", "g2", *ends))
    assert len(data["scales"]) > 12
    press(window, "Home")
    for scale in data["scales"]:
        press(window, "PageUp")
        assert window.run(VALUE, "scale") == scale
    press(window, "PageUp")
    assert window.run(VALUE, "scale") == data["scales"][-1]
    for scale in data["scales"][-2:-12:-1]:
        window.run("document.getElementById('previous').click()")
        window.run(DRAWN)
        assert window.run(VALUE, "scale") == scale


def test_a_scale_is_typed_as_a_number_or_a_fraction(window: Browser, tmp_path: Path) -> None:
    data = opened(window, page_of(tmp_path, "g1", "g2"))
    enter = (
        "const field = document.getElementById('scale'); field.focus(); field.value = arguments[0];"
        "field.dispatchEvent(new Event('change')); return field.classList.contains('bad')"
    )
    for text, scale in (("7/5", 1.4), ("0.25", 0.25), (" 3 ", 3.0), ("1e0", 1.0)):
        assert window.run(enter, text) is False
        window.run(DRAWN)
        assert window.run("return window.minkref.scale") == scale
    for text in ("11", "0", "-1", "x", "1/0", "", "1/2/3"):
        assert window.run(enter, text) is True, text
        assert window.run("return window.minkref.scale") == 1.0
    assert window.run(enter, data["scales"][30]) is False
    window.run(DRAWN)
    assert "Boundary event 31 of" in window.run(TEXT, "situation")


def test_a_topology_event_and_a_bar_tell_what_they_are(window: Browser, tmp_path: Path) -> None:
    data = opened(window, page_of(tmp_path, "g1", "g2"))
    born = next(i for i, row in enumerate(data["topology"]) if row[1:3] == ["h", "birth"])
    window.run("document.querySelectorAll('#events tbody tr')[arguments[0]].click()", born)
    window.run(DRAWN)
    event, *_, after, _, _ = data["topology"][born]
    assert window.run(VALUE, "scale") == data["scales"][event]
    told = window.run(TEXT, "chosen")
    assert f"hole {after[0]}" in told
    assert data["scales"][event] in told
    window.run("document.querySelector('#barcode .bar').dispatchEvent(new MouseEvent('click'))")
    window.run(DRAWN)
    assert "hole" in window.run(TEXT, "chosen")
    assert window.messages() == []


def test_edges_of_the_convolution_are_shown_and_hidden(window: Browser, tmp_path: Path) -> None:
    opened(window, page_of(tmp_path, "g1", "g2"))
    picture = "return document.getElementById('sum').toDataURL()"
    seen = {window.run(picture)}
    for kind in "ST":
        window.run(f"document.getElementById('show-{kind}').click()")
        window.run(DRAWN)
        seen.add(window.run(picture))
    assert len(seen) == 3


def test_a_scale_outside_of_the_window_has_no_rings(window: Browser, tmp_path: Path) -> None:
    opened(window, page_of(tmp_path, "g1", "g2", "--from", "1/2", "--to", "2"))
    with pytest.raises(JavascriptException, match="outside of the window"):
        window.run("return window.minkref.rings(3)")


@pytest.mark.parametrize("shape", ["POLYGON EMPTY", "POINT(1 2)", "LINESTRING(0 0,3 1)"])
def test_empty_and_thin_operands_have_a_page(window: Browser, tmp_path: Path, shape: str) -> None:
    thin = tmp_path / "thin.wkt"
    thin.write_text(shape, encoding="utf-8")
    for names in ((str(thin), "g1"), ("g1", str(thin))):
        opened(window, page_of(tmp_path, *names))
        expected = 0 if "EMPTY" in shape else 1
        assert len(window.run("return window.minkref.rings(1)")) == expected
        press(window, "ArrowRight")
        press(window, "PageUp")
        assert window.messages() == []
