"""The audit as a page that works from a file, and as JSON."""

from __future__ import annotations

import json
import os
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref.output.documents import write_together
from minkref.reports.audit.catalogue import CHAPTERS, ENTRIES
from minkref.reports.audit.entry import CheckFailed, Entry, Shown, counted
from minkref.reports.pages import environment
from minkref.reports.typeset import typeset_line

Tell = Callable[[str], None]
PAGE = "audit.html"
ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Outcome:
    """The outcome of a check. `failure`: the result that contradicts the entry; `shown` is None if
    the check was left out."""

    entry: Entry
    shown: Shown | None
    failure: str
    seconds: float

    @property
    def word(self) -> str:
        return "failed" if self.failure else "passed" if self.shown else "left out"


def outcome(entry: Entry, quick: bool) -> Outcome:
    if quick and entry.slow:
        return Outcome(entry, None, "", 0.0)
    began = time.perf_counter()
    try:
        shown, failure = entry.run(), ""
    except CheckFailed as failed:
        shown, failure = None, str(failed)
    return Outcome(entry, shown, failure, time.perf_counter() - began)


def write_audit(folder: Path, quick: bool, tell: Tell, done: Callable[[], None]) -> list[Outcome]:
    """Runs all checks; writes `audit.html` and `audit.json`."""
    outcomes = []
    for entry in ENTRIES.values():
        tell(entry.name)
        outcomes.append(outcome(entry, quick))
        done()
    words = Counter(one.word for one in outcomes)
    page = (
        environment("audit")
        .get_template("audit.html.j2")
        .render(
            chapters=CHAPTERS,
            outcomes={one.entry.name: one for one in outcomes},
            counts=counted(one.entry for one in outcomes),
            passed=words["passed"],
            failed=words["failed"],
            left_out=words["left out"],
            command="minkref report audit" + " --quick" * quick,
            line=typeset_line,
            code=lambda path: _link(folder, path),
        )
    )
    folder.mkdir(parents=True, exist_ok=True)
    rows = [row_of(one) for one in outcomes]
    write_together({folder / PAGE: page, folder / "audit.json": json.dumps(rows, indent=1) + "\n"})
    return outcomes


def _link(folder: Path, path: str) -> str:
    """The page's relative link to a project file; empty if the file does not exist."""
    file = ROOT / path
    return os.path.relpath(file, folder.resolve()) if file.exists() else ""


def row_of(one: Outcome) -> dict[str, Any]:
    entry = one.entry
    return {
        "name": entry.name,
        "title": entry.title,
        "place": entry.place,
        "status": str(entry.status),
        "printed": entry.printed,
        "right": entry.right,
        "reading": entry.reading,
        "formula": entry.formula,
        "check": entry.how,
        "outcome": one.word,
        "failure": one.failure,
        "facts": one.shown.facts if one.shown else [],
        "code": list(entry.code),
        "seconds": round(one.seconds, 3),
    }
