"""Markdown prose wraps at one width, and words that the project has given up do not come back."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WIDTH = 120
#: Written by programs, from sentences that are tested where they stand.
GENERATED = ("docs/audit/", "reports/evidence/SUMMARY.md", "reports/evidence/planted_faults.md")
#: One line for each entry; the pages of the corpus are paragraphs in one line each.
UNWRAPPED = ("degeneracies/pages/",)
GIVEN_UP = re.compile(
    r"\b(?:mend|mends|mended) it\b|[\"' ]mend: (?!str)|can be had again|in it\. Open to"
    r"|what there is to name",
    re.IGNORECASE,
)
SOURCES = (".md", ".py", ".cpp", ".hpp", ".j2")


def tracked() -> Iterator[str]:
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=False
    ).stdout.split("\n")
    found = listed if any(listed) else [str(p.relative_to(ROOT)) for p in ROOT.glob("docs/*.md")]
    yield from (name for name in found if name and (ROOT / name).is_file())


def too_wide(text: str) -> Iterator[int]:
    """Numbers of prose lines above the width, without code, tables, pictures and single long words
    (addresses)."""
    fenced = False
    for number, line in enumerate(text.splitlines(), 1):
        if re.match(r"\s*(?:```|~~~)", line):
            fenced = not fenced
        words = line.split()
        table_or_code = line.startswith(("|", "    ", "#", "![", "<"))
        if fenced or table_or_code or len(line) <= WIDTH or max(map(len, words)) > WIDTH - 10:
            continue
        yield number


def test_prose_wraps_at_one_width() -> None:
    wide = [
        f"{name}:{number}"
        for name in tracked()
        if name.endswith(".md") and not name.startswith((*GENERATED, *UNWRAPPED))
        for number in too_wide((ROOT / name).read_text(encoding="utf-8"))
    ]
    assert not wide, f"wider than {WIDTH}: {', '.join(wide)}"


def test_words_given_up_do_not_come_back() -> None:
    found = [
        f"{name}: {said[0]}"
        for name in tracked()
        if name.endswith(SOURCES) and not name.startswith(GENERATED) and name != own_name()
        for said in GIVEN_UP.finditer((ROOT / name).read_text(encoding="utf-8"))
    ]
    assert not found, found


def own_name() -> str:
    return str(Path(__file__).resolve().relative_to(ROOT))


def test_the_tests_see_what_they_look_for() -> None:
    assert list(too_wide("word " * 30)) == [1]
    assert not list(too_wide("```\n" + "word " * 30 + "\n```\n| " + "word " * 30))
    assert GIVEN_UP.search("To mend it: try")
