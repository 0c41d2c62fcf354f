"""The page of `minkref view --route paper-update` in headless Chromium: steps, colours, lists."""

from __future__ import annotations

from pathlib import Path

import pytest
from minkref.reports.evidence.framework.browser import Browser, absent
from page_decoder import data_of, page_of
from thoroughness import draws

pytestmark = pytest.mark.skipif(absent() is not None, reason=f"no browser: {absent()}")

SHOTS = Path(__file__).resolve().parents[2] / "build" / "view"
DRAWN = "return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
TEXT = "return document.getElementById(arguments[0]).textContent"
COLOUR = "return getComputedStyle(document.documentElement).getPropertyValue(`--${arguments[0]}`)"
PIXELS = """const canvas = document.createElement("canvas"), sum = document.getElementById("sum");
[canvas.width, canvas.height] = [sum.width, sum.height];
const ink = canvas.getContext("2d", { willReadFrequently: true });
ink.drawImage(sum, 0, 0);
const hex = arguments[0].trim(), wanted = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
const seen = ink.getImageData(0, 0, canvas.width, canvas.height).data;
let count = 0;
for (let i = 0; i < seen.length; i += 4) count += wanted.every((value, k) => seen[i + k] === value);
return count"""
WINDOW = ("--route", "paper-update", "--from", "1/2", "--to", "2", "--steps", str(draws(5, 9)))


def opened(window: Browser, page: Path) -> None:
    window.prefer("light")
    window.open(page)
    window.run(DRAWN)


def pixels(window: Browser, name: str) -> int:
    count: int = window.run(PIXELS, window.run(COLOUR, name))
    return count


def test_lost_and_added_parts_are_drawn_in_their_colours(window: Browser, tmp_path: Path) -> None:
    page = page_of(tmp_path, "g1", "g2", *WINDOW, "--arithmetic", "double")
    opened(window, page)
    run = data_of(page.read_text(encoding="utf-8"))["paper"]
    drawn = {"lost": 0, "added": 0}
    for k, step in enumerate(run["steps"]):
        window.run("window.minkref.moveTo(arguments[0])", step["about"] * 1.001)  # the next step
        window.run(DRAWN)
        assert window.run("return window.minkref.step") == k
        assert step["words"] in window.run(TEXT, "paper-here")
        for name in drawn:
            count = pixels(window, name)
            drawn[name] += count
            assert count == 0 or step[name]
    assert min(drawn.values()) > 100
    SHOTS.mkdir(parents=True, exist_ok=True)
    window.save_screenshot(SHOTS / "paper-update.png")
    assert window.messages() == []


def test_lists_lead_to_their_scales(window: Browser, tmp_path: Path) -> None:
    page = page_of(tmp_path, "g1", "g2", *WINDOW, "--arithmetic", "double")
    opened(window, page)
    run = data_of(page.read_text(encoding="utf-8"))["paper"]
    for name in ("missed", "invented"):
        rows = f"document.querySelectorAll('#paper-{name} tbody tr')"
        assert window.run(f"return {rows}.length") == len(run[name]) > 0
        event = run[name][-1]
        told = window.run(f"return {rows}[{len(run[name]) - 1}].textContent")
        assert event["a"] in told and event["b"] in told
    wrong = "document.querySelectorAll('#paper-wrong tbody tr')"
    assert window.run(f"return {wrong}.length") == 1  # wrong at every step
    assert window.run("return document.querySelectorAll('#strip .wrong').length") == 1
    window.run(f"{wrong}[0].click()")
    window.run(DRAWN)
    assert window.run("return window.minkref.scale") == 0.5
    window.run("dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight'}))")
    window.run(DRAWN)
    assert window.run("return window.minkref.step") == 1
    window.run("document.getElementById('next').click()")  # a boundary event is no step
    window.run(DRAWN)
    assert window.run("return window.minkref.step") == -1
    assert "At an event" in window.run(TEXT, "paper-here")


def test_other_routes_show_nothing_of_it(window: Browser, tmp_path: Path) -> None:
    opened(window, page_of(tmp_path, "g1", "g2"))
    shown = "return [...document.querySelectorAll('.of-paper')].filter((e) => !e.hidden).length"
    assert window.run(shown) == 0
    window.run("window.minkref.moveTo(1.23456)")
    assert window.run("return window.minkref.scale") == 1.23456
    assert window.run("return window.minkref.step") == -1
    assert window.messages() == []
