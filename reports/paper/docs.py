"""Writes the table of `docs/paper.md` from the statements, and the verdicts from the kept run:
`python -m minkref.reports.paper.docs`. With the `paper.json` of a report as argument that run is
kept first. A test holds the page to both."""

from __future__ import annotations

import sys
from pathlib import Path

from minkref.output.documents import write_atomically
from minkref.reports.audit.catalogue import CHAPTERS
from minkref.reports.audit.page import ROOT
from minkref.reports.paper.kept_run import keep, verdicts
from minkref.reports.paper.statements import STATEMENTS, Statement

PAGE = ROOT / "docs" / "paper.md"
THEORY = ROOT / "oracle" / "proved" / "theory"
BEGIN = "<!-- the table: python -m minkref.reports.paper.docs -->\n"
END = "<!-- the end of the table -->\n"
RUN = "<!-- the verdicts: python -m minkref.reports.paper.docs REPORT/paper.json -->\n"
END_OF_RUN = "<!-- the end of the verdicts -->\n"
COLUMNS = ("section", "what it is", "file", "form", "arithmetic", "command", "judge")


def table() -> str:
    head = [f"| {' | '.join(COLUMNS)} |", "|" + "---|" * len(COLUMNS)]
    return "\n".join([*head, *map(_row, STATEMENTS), ""])


def _row(statement: Statement) -> str:
    files = ", ".join(f"[{path.split('/')[-1]}](../{path})" for path in statement.files)
    entries = ", ".join(f"[{name}](audit/{_page(name)}#{name})" for name in statement.entries)
    judge = f"{statement.judge}; audit: {entries}" if entries else statement.judge
    judge += "".join(f"; {_proved(name)}" for name in statement.theorems)
    cells = (statement.place, statement.what, files, statement.form, statement.arithmetics,
             f"`{statement.command}`", judge)  # fmt: skip
    return f"| {' | '.join(cells)} |"


def _proved(name: str) -> str:
    """Names its theorem. Raises KeyError if there is none, or two."""
    theorems = "".join(path.read_text(encoding="utf-8") for path in sorted(THEORY.glob("*.v")))
    words = {f"{name}_holds : {name}.": "proved", f"{name}_fails : ~ {name}.": "refuted"}
    found = {word for said, word in words.items() if f"Theorem {said}" in theorems}
    if len(found) != 1:
        raise KeyError(name)
    return f"{found.pop()}: [`{name}`](proved.md#the-papers-theory)"


def _page(name: str) -> str:
    return next(f"{c.name}.md" for c in CHAPTERS if any(e.name == name for e in c.entries))


def written(text: str) -> str:
    """The page with its table and verdicts renewed. Raises ValueError without the marks."""
    with_table = _between(text, BEGIN, END, table())
    return _between(with_table, RUN, END_OF_RUN, verdicts())


def _between(text: str, begin: str, end: str, made: str) -> str:
    before, rest = text.split(begin)
    _, after = rest.split(end)
    return f"{before}{begin}\n{made}\n{end}{after}"


if __name__ == "__main__":
    for report in sys.argv[1:]:
        keep(Path(report), Path(__file__).resolve().parent)
    write_atomically(PAGE, written(PAGE.read_text(encoding="utf-8")))
