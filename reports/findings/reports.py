"""Writes a report for each finding, ready to send, and a list that says `still` or `mended`."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from minkref.reports.findings.entry import entries
from minkref.reports.findings.letter import letter
from minkref.reports.findings.picture import case_picture
from minkref.reports.findings.running import ran

FRONT = "findings.md"


def write_findings(
    folder: Path, quick: bool, now: Callable[[str], None], done: Callable[[], None]
) -> Path:
    """Runs each program with an installed library; `quick` skips programs to compile."""
    rows = ["| Finding | State |", "|---|---|"]
    for entry in entries():
        now(entry.id)
        result = ran(entry, compiling=not quick)
        name = f"finding-{entry.id}"
        (folder / f"{name}.md").write_text(letter(entry, result), encoding="utf-8")
        drawn = case_picture(entry)
        if drawn is not None:
            (folder / f"{name}.svg").write_text(drawn, encoding="utf-8")
        rows.append(f"| [{entry.library}: {entry.title}]({name}.md) | {result.state} |")
        done()
    front = folder / FRONT
    front.write_text("\n".join(["# Findings", "", *rows, ""]), encoding="utf-8")
    return front
