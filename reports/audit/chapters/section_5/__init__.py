"""Section 5: uniform scaling in space."""

from __future__ import annotations

from minkref.reports.audit.chapters.section_5 import (
    all_events,
    contacts,
    edge_events,
    parallel_faces,
)
from minkref.reports.audit.entry import Chapter

PARTS = (contacts.PART, edge_events.PART, parallel_faces.PART, all_events.PART)
CHAPTER = Chapter(
    "section-5",
    "Section 5: uniform scaling in space",
    [entry for part in PARTS for entry in part.entries],
)
