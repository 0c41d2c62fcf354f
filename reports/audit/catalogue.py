"""All audit entries, in the paper's order."""

from __future__ import annotations

from minkref.reports.audit.chapters import (
    appendix,
    section_3,
    section_4,
    section_5,
    section_6,
    section_7,
    section_8,
)
from minkref.reports.audit.entry import Chapter, Entry

CHAPTERS: tuple[Chapter, ...] = (
    section_3.CHAPTER,
    section_4.CHAPTER,
    section_5.CHAPTER,
    section_6.CHAPTER,
    section_7.CHAPTER,
    section_8.CHAPTER,
    appendix.CHAPTER,
)
ENTRIES: dict[str, Entry] = {entry.name: entry for chapter in CHAPTERS for entry in chapter.entries}
