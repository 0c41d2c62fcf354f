"""The page docs/findings.md with its pictures: `python -m minkref.reports.findings.page`."""

from __future__ import annotations

import textwrap
from collections import Counter
from pathlib import Path

from minkref.reports.findings.entry import FOLDER, Entry, entries
from minkref.reports.findings.picture import case_picture

ROOT = FOLDER.resolve().parents[1]
PAGE = ROOT / "docs" / "findings.md"
PICTURES = ROOT / "docs" / "findings"
WIDTH = 120
HEAD = (Path(__file__).parent / "head.md").read_text(encoding="utf-8")


def page() -> str:
    """The whole page, as Markdown."""
    every = entries()
    libraries = Counter(each.library for each in every)
    told = ", ".join(f"{name} {count}" for name, count in libraries.items())
    count = f"{len(every)} findings in {len(libraries)} libraries: {told}."
    parts = [HEAD, _wrapped(count), "", _table(every)]
    parts += [_section(each) for each in every]
    return "\n".join(parts)


def pictures() -> dict[str, str]:
    """Each picture's file name and text."""
    found = {f"{each.id}.svg": case_picture(each) for each in entries()}
    return {name: text for name, text in found.items() if text is not None}


def _table(every: tuple[Entry, ...]) -> str:
    rows = ["| Finding | Library | Call | Fault |", "|---|---|---|---|"]
    for each in every:
        rows.append(
            f"| [{each.title}](#{_anchor(each)}) | {each.library} {each.versions} | `{each.call}` "
            f"| {each.fault} |"
        )
    return "\n".join(rows) + "\n"


def _anchor(entry: Entry) -> str:
    kept = (c for c in _heading(entry).lower() if c.isalnum() or c in " -")
    return "".join(kept).replace(" ", "-")


def _heading(entry: Entry) -> str:
    return f"{entry.library}: {entry.title}"


def _section(entry: Entry) -> str:
    parts = [f"## {_heading(entry)}", f"{entry.answers} {entry.right}"]
    if entry.witness is not None:
        point = ", ".join(_short(number) for number in entry.witness["point"])
        side = "in" if entry.witness["in_truth"] else "outside"
        if entry.verb == "path":
            side = "the part's place"
        parts[-1] += f" Witness: ({point}), {side}."
    program = f"[program](../degeneracies/findings/programs/{entry.program})"
    issue = f"; upstream: <{entry.issue}>" if entry.issue else ""
    parts.append(f"{entry.verb}, {entry.fault}; {program}; target `{entry.adapter}`{issue}.")
    if case_picture(entry) is not None:
        parts.append(f"![{entry.title}](findings/{entry.id}.svg)")
    return "\n\n".join([parts[0], *map(_wrapped, parts[1:])]) + "\n"


def _wrapped(text: str) -> str:
    return textwrap.fill(text, WIDTH, break_long_words=False, break_on_hyphens=False)


def _short(number: str) -> str:
    """The number, cut if long."""
    return number if len(number) <= 24 else f"{number[:8]}…"


def write(page_file: Path = PAGE, folder: Path = PICTURES) -> None:
    page_file.write_text(page(), encoding="utf-8")
    folder.mkdir(exist_ok=True)
    for name, text in pictures().items():
        (folder / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    write()
