"""The site of the documentation: built without warnings, looked at in Chromium, wide and narrow."""

from __future__ import annotations

import subprocess
import time
from pathlib import Path

from minkref.reports.evidence.framework.browser import PACKAGES, Browser, absent, browser
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT

RESTS_ON = ("docs/", "bindings/", "minkref/", "reference/")
MINUTES = Minutes(None, 5.5, 15)

SITE = ROOT / "build" / "site"
WIDTHS = (1280, 390)
WIDE = "return document.documentElement.scrollWidth - window.innerWidth"
ELSEWHERE = """return performance.getEntriesByType("resource").map((entry) => entry.name)
    .filter((name) => !/^(file|data|blob):/.test(name))"""
BACKGROUND = "return getComputedStyle(document.body).backgroundColor"
TYPE = """const field = document.querySelector("input[name=query]");
    field.focus(); field.value = arguments[0];
    field.dispatchEvent(new Event("input", {bubbles: true}));
    field.dispatchEvent(new KeyboardEvent("keyup", {bubbles: true}))"""
FOUND = "return document.querySelectorAll('.md-search-result__item').length"
EVERY = Counts(0, 4, 1)  # one page of so many
SECONDS = 60  # until the search has read its index


def run(findings: Findings, size: Size) -> None:
    began = time.perf_counter()
    done = subprocess.run(
        [ROOT / "tools/scripts/docs.sh"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    findings.figures["seconds to build"] = round(time.perf_counter() - began)
    said = (done.stdout + done.stderr).strip()
    findings.law("the strict build ends well", done.returncode == 0, 0, said[-500:])
    if done.returncode != 0:
        return
    pages = sorted(page for page in SITE.rglob("*.html") if page.name != "404.html")
    viewed = [page for page in pages if page.parent.name == "gallery" and page.stem != "index"]
    pages = [page for page in pages if page not in viewed]
    findings.figures |= {"pages": len(pages), "pages of `minkref view`": len(viewed)}
    reason = absent()
    if reason is not None:
        findings.note(f"install {' and '.join(PACKAGES)}, then run this part with --again")
        findings.target("pages in Chromium", False, "looked at", reason)
        return
    with browser() as window:
        _look(findings, window, pages[:: size.of(EVERY)])
        _search(findings, window)


def _look(findings: Findings, window: Browser, pages: list[Path]) -> None:
    wide, elsewhere, messages = [], [], []
    for width in WIDTHS:
        window.viewport(width, 900)
        for page in pages:
            window.open(page)
            name = f"{page.relative_to(SITE)} at {width}"
            wide += [name] if window.run(WIDE) > 0 else []
            elsewhere += [f"{name}: {found}" for found in window.run(ELSEWHERE)]
            messages += [f"{name}: {message}" for message in window.messages()]
    for what, found in (
        ("pages wider than the window", wide),
        ("resources from elsewhere", elsewhere),
        ("errors of pages", messages),
    ):
        findings.law(what, not found, 0, f"{len(found)} {', '.join(found[:5])}".strip())


def _search(findings: Findings, window: Browser) -> None:
    """Also the colours of both modes, on the first page."""
    window.viewport(WIDTHS[0], 900)
    colours = []
    for mode in ("light", "dark"):
        window.prefer(mode)
        window.open(SITE / "index.html")
        colours.append(window.run(BACKGROUND))
    findings.equal("dark mode has another background", 2, len(set(colours)))
    end = time.monotonic() + SECONDS
    found = 0
    while not found and time.monotonic() < end:
        window.run(TYPE, "witness")
        time.sleep(1)
        found = window.run(FOUND)
    findings.law("the search finds pages about witnesses", found > 0, "some", found)
