"""Writes the audit as Markdown to docs/audit/: `python -m minkref.reports.audit.docs`. Only the
report shows results of slow checks, and of checks that depend on the models at hand."""

from __future__ import annotations

from pathlib import Path

from minkref.output.documents import write_atomically
from minkref.reports.audit.catalogue import CHAPTERS, ENTRIES
from minkref.reports.audit.entry import Chapter, Entry, counted, formulas
from minkref.reports.audit.page import ROOT

FOLDER = ROOT / "docs" / "audit"
HEAD = """# The paper on trial

What *Dynamic Minkowski Sums Under Scaling* (E. Behar and J.-M. Lien, preprint of 11 August 2012)
says, what holds, and a check behind every entry. Each check is an identity that computer algebra
proves, an exact counterexample, exact trials on drawn cases, or arithmetic with the printed
numbers; none has a tolerance. Trials on drawn cases are no proof: where a statement is proved, the
entry says how. `minkref report audit` runs all checks and writes a page with the counterexamples
drawn; they are also tests.

These pages are written by `python -m minkref.reports.audit.docs` from `reports/audit/chapters/`,
and a test holds them to it. What is printed in the paper is told in our words and formulas;
what stands between “ and ” are its own words, which a test looks up.
"""

COUNTED = """Formulas and sentences are counted, not entries: where several entries are about one,
the gravest counts. "False as read literally" is what does not hold with words and symbols as the
paper defines them, and holds in another reading, which the entry names; "false" is what holds in
no reading that we know. These formulas have several entries:"""


def pages() -> dict[str, str]:
    """File names and texts."""
    return {"README.md": _index(), **{f"{c.name}.md": _chapter(c) for c in CHAPTERS}}


def _index() -> str:
    counts = counted(ENTRIES.values())
    told = ", ".join(f"{count} {status}" for status, count in counts.items())
    rows = [
        f"| [{entry.title}]({chapter.name}.md#{entry.name}) | {entry.place} | {entry.status} |"
        for chapter in CHAPTERS
        for entry in chapter.entries
    ]
    table = ["| entry | place in the paper | status |", "|---|---|---|", *rows]
    about = f"{sum(counts.values())} formulas and sentences: {told}."
    shared = [
        f"- {formula}: {', '.join(f'[{e.title}]({_file(e)}#{e.name})' for e in group)}"
        for formula, group in formulas(ENTRIES.values()).items()
        if len(group) > 1
    ]
    return "\n".join([
        HEAD, about, "", COUNTED, "", *shared, "", f"{len(ENTRIES)} entries:", "", *table, ""
    ])  # fmt: skip


def _file(entry: Entry) -> str:
    return next(f"{chapter.name}.md" for chapter in CHAPTERS if entry in chapter.entries)


def _chapter(chapter: Chapter) -> str:
    return f"# {chapter.title}\n\n" + "\n".join(map(_entry, chapter.entries))


def _entry(entry: Entry) -> str:
    lines = [
        f'## <a id="{entry.name}"></a>{entry.title}',
        "",
        f"{entry.place}. Status: **{entry.status}**.",
        "",
        f"**The paper.** {entry.printed}",
        "",
        f"**Right.** {entry.right}",
        "",
        *([f"**Holds if read so.** {entry.reading}", ""] if entry.reading else []),
        f"**Check.** {entry.how}",
        "",
    ]
    if not (entry.slow or entry.of_models):
        lines += [*(f"- {fact}" for fact in entry.run().facts), ""]
    if entry.code:
        links = (f"[{path}](../../{path})" for path in entry.code)
        lines += [f"Code: {', '.join(links)}", ""]
    return "\n".join(lines)


def write(folder: Path = FOLDER) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in pages().items():
        write_atomically(folder / name, text)


if __name__ == "__main__":
    write()
