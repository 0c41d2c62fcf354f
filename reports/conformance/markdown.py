"""The verdicts as Markdown, for the summary page of a continuous integration."""

from __future__ import annotations

from typing import Any

from minkref.commands.verify_output import cell_text, conclusion, describe
from minkref.fuzz.run.runner import Run
from minkref.fuzz.shrink.groups import Group


def markdown(run: Run, groups: list[Group], value: dict[str, Any]) -> str:
    """A table of targets by families, then each kind of finding."""
    lines = ["# minkref verify", "", conclusion(run), ""]
    heads = [f"{group} ({run.cases[group]:,})" for group in run.groups]
    lines.append(_row(["target", *heads]))
    lines.append("|" + " --- |" * (len(heads) + 1))
    for target in run.targets:
        cells = [cell_text(run.matrix.get((target, group))) for group in run.groups]
        lines.append(_row([target, *cells]))
    for group in groups:
        first, *rest = describe(group)
        lines += ["", f"## {first}", "", *(f"    {line}" for line in rest)]
    lines += ["", *(f"- {note}" for note in value["notes"])]
    return "\n".join(lines).rstrip() + "\n"


def _row(cells: list[str]) -> str:
    return "| " + " | ".join(_cell(cell) for cell in cells) + " |"


def _cell(text: str) -> str:
    return text.replace("<", "&lt;").replace("|", "\\|").replace("\n", "<br>")
