"""The outline of unions."""

from __future__ import annotations

from pathlib import Path

from minkref.degeneracies.outline import Outline, families_of
from minkref.degeneracies.unions import touching
from minkref.degeneracies.unions.case_document import DegenerateUnion
from minkref.degeneracies.unions.case_faults import case_faults

UNIONS = Outline(
    word="unions",
    dimension=2,
    families=families_of(touching),
    case=DegenerateUnion,
    faults=case_faults,
    holds=lambda value: value.get("schema") == DegenerateUnion.schema,
    count=3,
    corpus=Path(__file__).parent / "corpus",
    sizeless="unions",
)
