"""Findings as annotations of GitHub Actions: a line each, which the page of a run shows beside the
file of the target. The format: https://docs.github.com, "Workflow commands for GitHub Actions"."""

from __future__ import annotations

import os
from pathlib import Path
from urllib.parse import unquote

from minkref.fuzz.shrink.groups import Group
from minkref.fuzz.verdicts.verdict import BROKEN, Verdict
from minkref.reports.conformance.annotation_kinds import AUTO, NONE
from minkref.reports.conformance.run_words import describe
from minkref.reports.conformance.sarif import place

_DATA = (("%", "%25"), ("\r", "%0D"), ("\n", "%0A"))  # the percent sign first
_PROPERTY = (*_DATA, (":", "%3A"), (",", "%2C"))


def annotation_lines(kind: str, groups: list[Group]) -> str:
    """Write a line for each kind of finding: an error for wrong or broken answers, else a notice.
    Empty for `none`, and for `auto` outside GitHub Actions."""
    on_github = os.environ.get("GITHUB_ACTIONS") == "true"
    if kind == NONE or (kind == AUTO and not on_github):
        return ""
    return "".join(_line(group) for group in groups)


def _line(group: Group) -> str:
    title, *lines = describe(group)
    outcome = group.example.outcome
    level = "error" if outcome.verdict in (Verdict.WRONG, *BROKEN) else "notice"
    text = _escaped("\n".join(line.strip() for line in lines) or title, _DATA)
    file = unquote(place(outcome.target))
    where = f"file={_escaped(file, _PROPERTY)}," if Path(file).is_file() else ""
    return f"::{level} {where}title={_escaped(title, _PROPERTY)}::{text}\n"


def _escaped(text: str, table: tuple[tuple[str, str], ...]) -> str:
    for letter, code in table:
        text = text.replace(letter, code)
    return text
