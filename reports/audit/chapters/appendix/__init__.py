"""Appendix: a scaling disc."""

from __future__ import annotations

from minkref.reports.audit.chapters.appendix import arcs, arcs_and_segments, segments
from minkref.reports.audit.entry import Chapter

PARTS = (segments.PART, arcs.PART, arcs_and_segments.PART)
CHAPTER = Chapter(
    "appendix", "Appendix: a scaling disc", [entry for part in PARTS for entry in part.entries]
)
