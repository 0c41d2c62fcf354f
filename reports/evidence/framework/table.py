"""The summary: a table for the terminal; as Markdown a row for each part, and below a section for
each step, which later summaries reuse if no new result exists."""

from __future__ import annotations

import datetime
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from minkref.reports.evidence.framework.part import Size, Status
from minkref.reports.evidence.framework.steps import Step
from rich.console import Console
from rich.table import Table

Document = dict[str, Any]
COLOURS = {"met": "green", "missed": "yellow", "failed": "red"}
SHORT = 8  # digits of a commit
TOLD = re.compile(
    r"^### (\w+/\w+)\n\n(\w+); (\w+) size; ([\d.]+) minutes; ([^;]+); commit ([^;]+); "
    r"(?:seed (\d+); )?([^;]+) models\n(.*?)(?=^##|\Z)",
    re.M | re.S,
)


@dataclass(frozen=True)
class Entry:
    """A step's entry in the summary."""

    step: str
    status: str
    size: str
    minutes: float
    date: str
    commit: str
    seed: str
    models: str
    body: str

    def text(self) -> str:
        seed = f"seed {self.seed}; " if self.seed else ""
        return (
            f"### {self.step}\n\n{self.status}; {self.size} size; {self.minutes:.1f} minutes; "
            f"{self.date}; commit {self.commit}; {seed}{self.models} models\n{self.body}"
        )


def entries_of(text: str) -> dict[str, Entry]:
    """A summary's entries, by step."""
    found = {}
    for step, status, size, minutes, date, commit, seed, models, body in TOLD.findall(text):
        body = f"{body.rstrip()}\n"
        found[step] = Entry(
            step, status, size, float(minutes), date, commit, seed, models, body
        )  # fmt: skip
    return found


def entry_of(document: Document) -> Entry:
    lines = [""]
    if document["error"]:
        lines += [f"Broke down: `{document['error']}`", ""]
    if document["checks"]:
        lines += ["| law or target | wanted | reached | |", "|---|---|---|---|"]
    for check in document["checks"]:
        kind = "law" if check["law"] else "target"
        verdict = "met" if check["met"] else ("broken" if check["law"] else "missed")
        cells = [f"{check['what']} ({kind})", check["wanted"], check["reached"], verdict]
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    lines += ["", *(f"- {note}" for note in document["notes"])] if document["notes"] else []
    commit = document["commit"]
    return Entry(
        document["step"], document["status"], document["size"], round(document["seconds"] / 60, 1),
        document["date"], (commit[:SHORT] + "+" * commit.endswith("+")) or "unknown",
        str(document["seed"] or ""), "the paper's" if document["paper_models"] else "look-alike",
        "\n".join(lines).rstrip() + "\n",
    )  # fmt: skip


def one_of(values: Iterable[str], otherwise: str) -> str:
    """The value, if all are the same; else `otherwise`."""
    found = set(values)
    return found.pop() if len(found) == 1 else otherwise


def row(name: str, steps: int, entries: list[Entry]) -> str:
    """The row of a part or a step: the worst status, smallest size, oldest date, all minutes."""
    if not entries:
        return f"| {name} | not run | | | | | |"
    order = [str(status) for status in Status]
    status = max((entry.status for entry in entries), key=order.index)
    if len(entries) < steps:
        status += f", {len(entries)} of {steps} steps"
    cells = [
        f"[{name}](#{name.replace('/', '')})",
        status,
        min((entry.size for entry in entries), key=[str(size) for size in Size].index),
        one_of((entry.commit for entry in entries), "several"),
        min(entry.date for entry in entries)[:10],
        f"{sum(entry.minutes for entry in entries):.1f}",
        one_of((entry.models for entry in entries), "both"),
    ]
    return f"| {' | '.join(cells)} |"


def markdown(
    steps: list[Step], entries: dict[str, Entry], claim: Callable[[str], str], quick: bool
) -> str:
    """The summary as Markdown. `steps` lists all steps, with or without results. Full-only steps
    get their own rows below the parts' rows."""
    today = datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d")
    rows: dict[str, list[str]] = {}
    for step in sorted(steps, key=lambda step: step.only_full):
        rows.setdefault(step.row, []).append(step.name)
    parts = list(dict.fromkeys(step.part for step in steps))
    head = ["status | size | commit | date | minutes | models |", "---|---|---|---|---:|---|"]
    lines = [
        f"# Evidence, {today}" + (" (quick: smaller counts)" if quick else ""),
        "",
        f"Written by `make evidence{' QUICK=1' * quick}`. A *law* must hold; a *target* may be "
        "missed, which is recorded.",
        "",
        f"| part | {head[0]}",
        f"|---|{head[1]}",
    ]
    there = {name: [entries[s] for s in own if s in entries] for name, own in rows.items()}
    lines += [row(name, len(own), there[name]) for name, own in rows.items() if name in parts]
    if any(name not in parts for name in rows):
        lines += ["", "Steps of hours, which run with `FULL=1` only:", ""]
        lines += [f"| step | {head[0]}", f"|---|{head[1]}"]
        lines += [row(name, 1, there[name]) for name in rows if name not in parts]
    for part in parts:
        own = [entries[s.name] for s in steps if s.part == part and s.name in entries]
        if own:
            lines += ["", f"## {part}", "", claim(part)]
            lines += [f"\n{entry.text().rstrip()}" for entry in own]
    return "\n".join(lines) + "\n"


def short(document: Document) -> str:
    """The missed checks, or else the first checks' results."""
    if document.get("error"):
        return str(document["error"])
    bad = [check for check in document["checks"] if not check["met"]]
    if bad:
        return "; ".join(f"{c['what']}: {c['reached']} (wanted {c['wanted']})" for c in bad[:3])
    return "; ".join(f"{c['what']}: {c['reached']}" for c in document["checks"][:4])


def show(console: Console, documents: list[Document], absent: list[str]) -> None:
    table = Table(title="Evidence", title_justify="left")
    for column in ("step", "status", "minutes", "what was reached"):
        table.add_column(column, justify="right" if column == "minutes" else "left")
    for document in documents:
        told = f"[{COLOURS[document['status']]}]{document['status']}[/] ({document['size']})"
        minutes = f"{document['seconds'] / 60:.1f}"
        table.add_row(document["step"], told, minutes, short(document), end_section=True)
    for step in absent:
        table.add_row(step, "not run", "", "")
    console.print(table)
