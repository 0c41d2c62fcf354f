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
PLACES = (
    *(f"Fig. {number}" for number in range(1, 13)), "Table 1", "Table 2", "4.1, Observation 1",
    "6, Theorem 1", "1", "3", "4", "4.1", "4.2", "4.2.1", "4.2.2", "4.2.3", "4.2.4", "5", "5.1",
    "5.2", "6", "7", "7.1", "7.2.1", "7.2.2", "8.1", "8.2", "Appendix",
)  # fmt: skip
#: An angle, as high as wide: not convex.
SOLID = """OFF
12 8 0
0 0 0
2 0 0
2 1 0
1 1 0
1 2 0
0 2 0
0 0 1
2 0 1
2 1 1
1 1 1
1 2 1
0 2 1
6 5 4 3 2 1 0
6 6 7 8 9 10 11
4 0 1 7 6
4 1 2 8 7
4 2 3 9 8
4 3 4 10 9
4 4 5 11 10
4 5 0 6 11
"""
#: The files that the page lets stand for any of their kind.
FILES = {
    "scalings.txt": "1\n2,1/2,1\n",
    "part.wkt": "POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))\n",
    "room.wkt": "POLYGON ((0 0, 9 0, 9 2, 8 2, 8 1, 1 1, 1 5, 8 5, 8 4, 9 4, 9 6, 0 6, 0 0))\n",
    "solid.off": SOLID,
}


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
    assert {e.name for c in CHAPTERS for e in c.entries} - named == set()


@pytest.mark.parametrize("command", COMMANDS)
def test_the_command_of_a_row_runs(
    minkref: Callable[..., Any], command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for name, text in FILES.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    name, *words = shlex.split(command)[1:]
    if name in TAKE_LONG:
        assert words[-1] in (SUBJECTS if name == "report" else PARTS)
        assert minkref(name, "--help").code == 0
    else:
        assert minkref(name, *words).code == 0
