"""The table of docs/paper.md comes from the statements, omits none, and each of its commands
runs."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.reports.audit.catalogue import CHAPTERS, ENTRIES
from minkref.reports.audit.page import ROOT
from minkref.reports.paper import docs
from minkref.reports.paper.statements import STATEMENTS
from minkref.verbs.bench import PARTS
from minkref.verbs.report import SUBJECTS

COMMANDS = sorted({statement.command for statement in STATEMENTS})
TAKE_LONG = ("report", "bench")  # these run as evidence
OF_ITS_SECTIONS = ("section-3", "section-4", "section-6", "section-7", "appendix")
PLACES = (
    *(f"Fig. {number}" for number in range(1, 11)), "Table 1", "Table 2", "4.1, Observation 1",
    "6, Theorem 1", "1", "3", "4", "4.1", "4.2", "4.2.1", "4.2.2", "4.2.3", "4.2.4", "6", "7",
    "7.1", "7.2.2", "Appendix",
)  # fmt: skip


def test_the_page_has_the_table_that_the_statements_make() -> None:
    """`python -m minkref.reports.paper.docs` writes it again."""
    text = docs.PAGE.read_text(encoding="utf-8")
    assert docs.written(text) == text


def test_each_row_names_files_a_command_and_a_judge() -> None:
    for statement in STATEMENTS:
        assert statement.files and statement.command.startswith("minkref ") and statement.judge
        for path in statement.files:
            assert (ROOT / path).is_file(), path
        assert "|" not in "".join((statement.what, statement.command, statement.judge))


def test_no_place_and_no_entry_of_the_audit_is_missed() -> None:
    assert {statement.place for statement in STATEMENTS} == set(PLACES)
    named = {name for statement in STATEMENTS for name in statement.entries}
    assert named <= set(ENTRIES)
    wanted = {e.name for c in CHAPTERS if c.name in OF_ITS_SECTIONS for e in c.entries}
    assert wanted - named == set()


@pytest.mark.parametrize("command", COMMANDS)
def test_the_command_of_a_row_runs(
    minkref: Callable[..., Any], command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scalings.txt").write_text("1\n2,1/2,1\n", encoding="utf-8")
    name, *words = shlex.split(command)[1:]
    if name in TAKE_LONG:
        assert words[-1] in (SUBJECTS if name == "report" else PARTS)
        assert minkref(name, "--help").code == 0
    else:
        assert minkref(name, *words).code == 0
