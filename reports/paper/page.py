"""The report on the paper's tables and figures: a page, and its data as JSON and CSV."""

from __future__ import annotations

import csv
import io
import json
from collections import Counter
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from minkref.output.documents import write_together
from minkref.reports.pages import environment
from minkref.reports.paper.entries import entries
from minkref.reports.paper.entry import RULE, Entry, Table

PAGE = "paper.html"


def write_paper(
    folder: Path, quick: bool, seed: int, tell: Callable[[str], None], done: Callable[[], None]
) -> Path:
    """Times what is timed; writes `paper.html`, `paper.json` with the paper's words and what was
    found, and NAME.csv and NAME.json for each table."""
    found = entries(quick, seed, tell, done)
    page = (
        environment("paper")
        .get_template("paper.html.j2")
        .render(
            entries=found,
            rule=RULE,
            counts=Counter(str(one.verdict) for one in found),
            command="minkref report paper" + " --quick" * quick,
        )
    )
    folder.mkdir(parents=True, exist_ok=True)
    files: dict[Path, str | bytes] = {}
    for one in found:
        for table in one.tables:
            files[folder / f"{table.name}.csv"] = _csv(table)
            files[folder / f"{table.name}.json"] = _json(table)
    files[folder / "paper.json"] = json.dumps([_told(one) for one in found], indent=1) + "\n"
    files[folder / PAGE] = page
    write_together(files)
    return folder / PAGE


def _told(entry: Entry) -> dict[str, Any]:
    return {
        "place": entry.place,
        "title": entry.title,
        "verdict": str(entry.verdict),
        "claims": [asdict(claim) for claim in entry.claims],
        "unlike": list(entry.unlike),
        "why": entry.why,
        "command": entry.command,
    }


def _csv(table: Table) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(table.columns)
    writer.writerows(table.rows)
    return text.getvalue()


def _json(table: Table) -> str:
    """The table as JSON; rows are lists, since columns may share a name."""
    return json.dumps({"columns": list(table.columns), "rows": list(table.rows)}, indent=1) + "\n"
