"""The summary: a table for the terminal, and the same as Markdown."""

from __future__ import annotations

import datetime
from typing import Any

from rich.console import Console
from rich.table import Table

Document = dict[str, Any]
COLOURS = {"met": "green", "missed": "yellow", "failed": "red"}


def short(document: Document) -> str:
    """What was reached: the checks that were missed, or how many were met."""
    if document.get("error"):
        return str(document["error"])
    bad = [check for check in document["checks"] if not check["met"]]
    if bad:
        return "; ".join(f"{c['what']}: {c['reached']} (wanted {c['wanted']})" for c in bad[:3])
    return "; ".join(f"{c['what']}: {c['reached']}" for c in document["checks"][:4])


def show(console: Console, documents: list[Document], absent: list[str]) -> None:
    table = Table(title="Evidence", title_justify="left")
    for column in ("part", "status", "minutes", "what was reached"):
        table.add_column(column, justify="right" if column == "minutes" else "left")
    for document in documents:
        status = document["status"] + (" (quick)" if document["quick"] else "")
        colour = COLOURS[document["status"]]
        minutes = f"{document['seconds'] / 60:.1f}"
        table.add_row(
            document["name"], f"[{colour}]{status}[/]", minutes, short(document), end_section=True
        )
    for name in absent:
        table.add_row(name, "not run", "", "")
    console.print(table)


def markdown(documents: list[Document], absent: dict[str, str], quick: bool) -> str:
    """`absent`: parts without a result, and why."""
    today = datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d")
    command = "make evidence QUICK=1" if quick else "make evidence"
    lines = [
        f"# Evidence, {today}" + (" (quick: smaller counts)" if quick else ""),
        "",
        f"Written by `{command}`. A *law* must hold; a *target* may be missed, which is recorded.",
        "",
        "| part | status | date | minutes | models |",
        "|---|---|---|---:|---|",
    ]
    for d in documents:
        models = "the paper's" if d["paper_models"] else "look-alikes"
        status = d["status"] + (" (quick)" if d["quick"] else "")
        lines.append(
            f"| [{d['name']}](#{d['name']}) | {status} | {d['date']} "
            f"| {d['seconds'] / 60:.1f} | {models} |"
        )
    lines += [f"| {name} | {why} | | | |" for name, why in absent.items()]
    for d in documents:
        lines += ["", f"## {d['name']}", "", d["subject"], ""]
        if d["error"]:
            lines += [f"Broke down: `{d['error']}`", ""]
        if d["checks"]:
            lines += ["| law or target | wanted | reached | |", "|---|---|---|---|"]
        for check in d["checks"]:
            kind = "law" if check["law"] else "target"
            verdict = "met" if check["met"] else ("broken" if check["law"] else "missed")
            cells = [f"{check['what']} ({kind})", check["wanted"], check["reached"], verdict]
            lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
        lines += [""] + [f"- {note}" for note in d["notes"]] if d["notes"] else []
    return "\n".join(lines) + "\n"
