"""The pages in headless Chromium: no messages, nothing too wide, both colour schemes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from minkref.reports.conformance.page import write_report
from minkref.reports.evidence.framework.browser import absent, browser
from thoroughness import some

pytestmark = pytest.mark.skipif(absent() is not None, reason=f"no browser: {absent()}")

SHOTS = Path(__file__).resolve().parents[2] / "build" / "conformance"
WAYS = [(1280, "light"), (1280, "dark"), (400, "light"), (400, "dark")]
WIDTHS = "return [document.documentElement.scrollWidth, document.documentElement.clientWidth]"
GROUND = "return getComputedStyle(document.body).backgroundColor"
SMALLEST = """return Math.min(...[...document.querySelectorAll('figure svg')]
    .map((svg) => svg.getBoundingClientRect().width))"""


def test_pages_fit_and_say_nothing_on_the_console(made: Any, tmp_path: Path) -> None:
    write_report(tmp_path, made.run, made.groups, made.value, again="minkref verify")
    SHOTS.mkdir(parents=True, exist_ok=True)
    grounds = set()
    with browser() as window:
        for width, colours in some(WAYS, few=2):
            window.prefer(colours)
            window.set_window_size(width, 1400)
            for page in sorted(tmp_path.glob("*.html")):
                window.open(page)
                window.run("document.querySelectorAll('details').forEach((d) => d.open = true)")
                needed, there = window.run(WIDTHS)
                assert needed <= there, (page.name, width)
                assert there <= width
                if "finding" in page.name:
                    assert window.run(SMALLEST) > 100, page.name
                grounds.add((colours, window.run(GROUND)))
                assert window.messages() == []
            window.open(tmp_path / "index.html")
            window.save_screenshot(SHOTS / f"index-{width}-{colours}.png")
    assert len(grounds) == 2
