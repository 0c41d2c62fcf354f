"""The outline of paths and traps."""

from __future__ import annotations

from pathlib import Path

from minkref.degeneracies.motion import along, traps
from minkref.degeneracies.motion.case_document import DegeneratePath
from minkref.degeneracies.motion.case_faults import case_faults
from minkref.degeneracies.outline import Outline, families_of

MOTION = Outline(
    word="paths",
    dimension=2,
    families=families_of(along, traps),
    case=DegeneratePath,
    faults=case_faults,
    holds=lambda value: value.get("schema") == DegeneratePath.schema,
    count=3,
    corpus=Path(__file__).parent / "corpus",
    sizeless="paths",
)
