"""The pages link to existing places, and name existing commands and options."""

from __future__ import annotations

from pathlib import Path

from minkref.reports.documentation.blocks import blocks, pages
from minkref.reports.documentation.commands import unknown_words
from minkref.reports.documentation.links import broken_links

ROOT = Path(__file__).resolve().parents[2]


def test_links_and_anchors_resolve() -> None:
    read = pages(ROOT)
    assert {Path("README.md"), Path("docs/README.md"), Path("reference/README.md")} <= set(read)
    assert broken_links(ROOT, read) == []


def test_the_first_page_of_docs_leads_to_each_of_them() -> None:
    index = (ROOT / "docs/README.md").read_text(encoding="utf-8")
    names = {path.name for path in (ROOT / "docs").glob("*.md")} - {"README.md"}
    assert {name for name in names if f"]({name})" not in index} == set()


def test_commands_and_options_exist() -> None:
    shown = [block for page in pages(ROOT) for block in blocks(ROOT, page)]
    assert [word for block in shown for word in unknown_words(block)] == []


def test_broken_links_are_told_with_their_lines(tmp_path: Path) -> None:
    (tmp_path / "other.md").write_text("# One `two`, three\n\n# Again\n\n# Again\n")
    (tmp_path / "page.md").write_text(
        "# Page\n\n[fine](other.md#one-two-three) [fine](other.md#again-1) [fine](#page)\n\n"
        "[gone](gone.md)\n\n![gone](gone.svg)\n\n[no heading](other.md#four)\n\n"
        "[outside](../other.md) [elsewhere](https://example.org/x)\n"
    )
    assert broken_links(tmp_path, [Path("page.md")]) == [
        "page.md:5: gone.md does not exist",
        "page.md:7: gone.svg does not exist",
        "page.md:9: other.md#four names no heading",
        "page.md:11: ../other.md leads out of the repository",
    ]


def test_unknown_commands_and_options_are_told(tmp_path: Path) -> None:
    (tmp_path / "page.md").write_text(
        "```console\n$ minkref sum P Q --scale 2\n$ minkref add P Q\n"
        "$ minkref sum P Q --scald 2\n```\n"
    )
    (block,) = blocks(tmp_path, Path("page.md"))
    assert list(unknown_words(block)) == [
        "page.md:1: there is no command add",
        "page.md:1: minkref sum has no option --scald",
    ]
