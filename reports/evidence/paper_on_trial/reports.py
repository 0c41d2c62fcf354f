"""Both reports on the paper: written in time, all checks passing, and drawn by a browser."""

from __future__ import annotations

import json
import tempfile
import time
from pathlib import Path

from minkref.reports.audit.catalogue import ENTRIES
from minkref.reports.evidence.framework.browser import absent, browser
from minkref.reports.evidence.framework.command import minkref
from minkref.reports.evidence.framework.part import Findings, Minutes, Size
from minkref.reports.paper.speedups import REPETITIONS

MINUTES = Minutes(None, 2, 14)
ALONE = True

RUNS: tuple[tuple[tuple[str, ...], int], ...] = ((("--quick",), 120), ((), 900))  # seconds
LEAST_ENTRIES = 40
FIGURES = """
return {
  svg: Array.from(document.querySelectorAll("figure svg")).map(e => {
    const box = e.getBoundingClientRect();
    return [box.width, box.height, e.querySelectorAll("path, circle, use, line").length];
  }),
  formulas: Array.from(document.querySelectorAll("math")).map(e => e.getBoundingClientRect().width),
  wide: document.documentElement.scrollWidth > window.innerWidth,
};
"""


def run(findings: Findings, size: Size) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for words, most in RUNS[: 1 if size is Size.WHOLE else 2]:
            began = time.perf_counter()
            _, told = minkref("report", "audit", "paper", *words, "-o", folder)
            seconds = time.perf_counter() - began
            what = " ".join(("minkref report audit paper", *words))
            findings.target(f"seconds of `{what}`", seconds < most, f"under {most}", round(seconds))
            findings.none(f"checks of `{what}` that fail", len(told["failed"]))
        rows = json.loads((folder / "audit.json").read_text(encoding="utf-8"))
        passed = sum(row["outcome"] == "passed" for row in rows)
        left_out = sum(row["outcome"] == "left out" for row in rows)  # slow checks, if quick
        findings.equal(
            "entries of the audit whose check passes",
            len(ENTRIES) - (left_out if size is Size.WHOLE else 0),
            passed,
        )
        findings.figures["entries left out"] = left_out
        findings.target("entries of the audit", passed >= LEAST_ENTRIES,
                        f"at least {LEAST_ENTRIES}", passed)  # fmt: skip
        findings.law("repetitions of each speed-up", REPETITIONS >= 5, "at least 5", REPETITIONS)
        findings.figures["entries by status"] = {
            status: sum(row["status"] == status for row in rows)
            for status in dict.fromkeys(row["status"] for row in rows)
        }
        entries = json.loads((folder / "paper.json").read_text(encoding="utf-8"))
        findings.figures["verdicts"] = {
            f"{one['place']}: {one['title']}": one["verdict"] for one in entries
        }
        reason = absent()
        if reason is not None:
            findings.target("pages drawn by a browser", False, 2, reason)
            return
        for page in map(Path, told["pages"]):
            _drawn(findings, page)


def _drawn(findings: Findings, page: Path) -> None:
    """Each figure has a size and something in it, each formula a width; nothing is said on the
    console, and the page is no wider than the window."""
    with browser() as window:
        window.set_window_size(1200, 900)
        window.open(page)
        seen = window.run(FIGURES)
        said = window.messages()
    empty = [one for one in seen["svg"] if min(one) <= 0]
    findings.law(f"{page.name}: figures, empty ones", seen["svg"] and not empty, "some, 0",
                 f"{len(seen['svg'])}, {len(empty)}")  # fmt: skip
    flat = sum(width <= 0 for width in seen["formulas"])
    findings.none(f"{page.name}: formulas without a width", flat)
    findings.none(f"{page.name}: messages on the console", said)
    findings.law(f"{page.name}: wider than the window", not seen["wide"], False, seen["wide"])
    findings.figures[f"{page.name}: figures, formulas"] = [len(seen["svg"]), len(seen["formulas"])]
