"""The outline of a polygon set with a disc."""

from __future__ import annotations

from pathlib import Path

from minkref.degeneracies.disc import across, around, doors, nearly
from minkref.degeneracies.disc.case_document import DegenerateWithDisc
from minkref.degeneracies.disc.case_faults import case_faults
from minkref.degeneracies.outline import Outline, families_of

DISC = Outline(
    word="disc",
    dimension=2,
    families=families_of(around, across, doors, nearly),
    case=DegenerateWithDisc,
    faults=case_faults,
    holds=lambda value: value.get("schema") == DegenerateWithDisc.schema,
    count=3,
    corpus=Path(__file__).parent / "corpus",
)
