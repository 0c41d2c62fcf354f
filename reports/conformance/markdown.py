"""The verdicts as Markdown, for the summary page of a continuous integration."""

from __future__ import annotations

from typing import Any

from minkref.fuzz.run.runner import Run
from minkref.fuzz.shrink.groups import Group
from minkref.reports.conformance.counts import Counts, total
from minkref.reports.conformance.markdown_text import plain
from minkref.reports.conformance.run_words import conclusion, describe
from minkref.reports.conformance.words import ending


def markdown(run: Run, groups: list[Group], value: dict[str, Any]) -> str:
    """A table of targets and families, reasons for skips, then each kind of finding."""
    lines = ["# minkref verify", "", plain(f"{ending(value['exit_code'])} {conclusion(run)}.")]
    lines += ["", f"minkref {value['version']}, seed {value['seed']}.", ""]
    heads = [f"{group} ({run.cases[group]:,})" for group in run.groups]
    lines.append(_row(["target", *heads]))
    lines.append("|" + " --- |" * (len(heads) + 1))
    skips = []
    versions = {row["name"]: row["version"] for row in value["targets"]}
    for target in run.targets:
        cells = [total([(run.matrix.get((target, g)), run.cases[g])]) for g in run.groups]
        name = f"{target} {versions.get(target) or ''}".rstrip()
        lines.append(_row([name, *(_text(cell) for cell in cells)]))
        whole = total((run.matrix.get((target, g)), run.cases[g]) for g in run.groups)
        skips += [f"- {target}: {count:,} skipped: {why}" for why, count in whole.why_skipped]
    lines += ["", "`8/9`: 8 of 9 judged cases are right; skipped cases are not among them.", ""]
    lines += [plain(line) for line in skips]
    for group in groups:
        first, *rest = describe(group)
        lines += ["", f"## {plain(first)}", "", *(f"    {line}" for line in rest)]
    absent = [f"- {row['name']} is absent: {row['reason']}" for row in value["absent"]]
    lines += ["", *(plain(line) for line in absent)]
    lines += [plain(f"- {note}") for note in value["notes"]]
    return "\n".join(lines).rstrip() + "\n"


def _text(counts: Counts) -> str:
    parts = [counts.fraction]
    if counts.within:
        parts.append(f"{counts.within:,} within")
    parts += [f"{count:,} {verdict}" for verdict, count, _ in counts.amiss]
    if counts.skipped:
        parts.append(f"{counts.skipped:,} skipped")
    if counts.not_asked:
        parts.append(f"{counts.not_asked:,} not asked")
    return "\n".join(parts)


def _row(cells: list[str]) -> str:
    return "| " + " | ".join(_cell(cell) for cell in cells) + " |"


def _cell(text: str) -> str:
    return "<br>".join(plain(line) for line in text.split("\n"))
