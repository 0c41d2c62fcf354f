"""Writes the table of `docs/paper.md` from the statements: `python -m minkref.reports.paper.docs`.
A test holds the page to it."""

from __future__ import annotations

from minkref.output.documents import write_atomically
from minkref.reports.audit.catalogue import CHAPTERS
from minkref.reports.audit.page import ROOT
from minkref.reports.paper.statements import STATEMENTS, Statement

PAGE = ROOT / "docs" / "paper.md"
BEGIN = "<!-- the table: python -m minkref.reports.paper.docs -->\n"
END = "<!-- the end of the table -->\n"
COLUMNS = ("section", "what it is", "file", "form", "arithmetic", "command", "judge")


def table() -> str:
    head = [f"| {' | '.join(COLUMNS)} |", "|" + "---|" * len(COLUMNS)]
    return "\n".join([*head, *map(_row, STATEMENTS), ""])


def _row(statement: Statement) -> str:
    files = ", ".join(f"[{path.split('/')[-1]}](../{path})" for path in statement.files)
    entries = ", ".join(f"[{name}](audit/{_page(name)}#{name})" for name in statement.entries)
    judge = f"{statement.judge}; audit: {entries}" if entries else statement.judge
    cells = (statement.place, statement.what, files, statement.form, statement.arithmetics,
             f"`{statement.command}`", judge)  # fmt: skip
    return f"| {' | '.join(cells)} |"


def _page(name: str) -> str:
    return next(f"{c.name}.md" for c in CHAPTERS if any(e.name == name for e in c.entries))


def written(text: str) -> str:
    """The page with its table renewed. Raises ValueError without the marks."""
    before, rest = text.split(BEGIN)
    _, after = rest.split(END)
    return f"{before}{BEGIN}\n{table()}\n{END}{after}"


if __name__ == "__main__":
    write_atomically(PAGE, written(PAGE.read_text(encoding="utf-8")))
