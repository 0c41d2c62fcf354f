"""The conformance report: one self-contained HTML page, and the stand-alone programs beside it."""

from __future__ import annotations

from importlib import resources
from pathlib import Path
from typing import Any

from jinja2 import Environment, StrictUndefined
from minkref.commands.verify_output import cell_text, conclusion
from minkref.documents import write_atomically
from minkref.errors import cut
from minkref.fuzz.run.runner import Run
from minkref.fuzz.shrink.groups import Group
from minkref.reports.conformance.finding_page import finding_page
from minkref.reports.conformance.showcase import showcases
from minkref.terminal import shown


def write_report(folder: Path, run: Run, groups: list[Group], value: dict[str, Any]) -> Path:
    """Writes `index.html`, and `NAME.cpp` for each kind of finding against CGAL. `value` is the
    JSON document of the run. Returns the path of the page."""
    findings = [finding_page(group) for group in groups]
    for finding in findings:
        if finding.program is not None:
            write_atomically(folder / finding.program.file, finding.program.text)
    rows = [
        {
            "target": target,
            "cells": [_cell(run, target, group) for group in run.groups],
            "version": next((t["version"] for t in value["targets"] if t["name"] == target), None),
        }
        for target in run.targets
    ]
    template = resources.files("minkref.reports.conformance") / "templates" / "page.html.j2"
    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    html = environment.from_string(template.read_text(encoding="utf-8")).render(
        value=value,
        rows=rows,
        groups=[(group, run.cases[group]) for group in run.groups],
        findings=findings,
        showcases=showcases(),
        conclusion=conclusion(run),
    )
    page = folder / "index.html"
    write_atomically(page, html)
    return page


def _cell(run: Run, target: str, group: str) -> dict[str, Any]:
    cell = run.matrix.get((target, group))
    verdicts = set(cell.verdicts) if cell else set()
    worst = "good" if verdicts & {"pass", "pass-within"} else "skipped"
    for verdict in (
        "undecided",
        "known",
        "errored",
        "timed-out",
        "out-of-memory",
        "crashed",
        "wrong",
    ):
        if verdict in verdicts:
            worst = verdict
    return {
        "lines": cell_text(cell).split("\n"),
        "worst": worst,
        "seconds": cell.seconds if cell else 0.0,
        "skips": shown(cut("; ".join(cell.skips))) if cell else "",
    }
