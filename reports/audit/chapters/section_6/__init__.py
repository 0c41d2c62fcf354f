"""Section 6: convex polyhedra under non-uniform scaling."""

from __future__ import annotations

from minkref.reports.audit.chapters.section_6 import chains, entangled, incompatibility, theorem_1
from minkref.reports.audit.entry import Chapter

PARTS = (incompatibility.PART, theorem_1.PART, entangled.PART, chains.PART)
CHAPTER = Chapter(
    "section-6",
    "Section 6: convex polyhedra under non-uniform scaling",
    [entry for part in PARTS for entry in part.entries],
)
