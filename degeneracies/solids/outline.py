"""The outline of pairs of polyhedra of any shape."""

from __future__ import annotations

from typing import Any

from minkref.degeneracies.outline import Outline, families_of
from minkref.degeneracies.solids import always, corners, fits, numbers, same
from minkref.degeneracies.solids.case_document import DegenerateSolids
from minkref.degeneracies.solids.case_faults import case_faults
from minkref.degeneracies.solids.flags import FLAGS_OF_SOLIDS


def _holds(value: dict[str, Any]) -> bool:
    told = value.get("degeneracy")
    return value.get("dimension") == 3 and isinstance(told, dict) and "ties" in told


SOLIDS = Outline(
    word="solids",
    dimension=3,
    families=families_of(always, same, fits, corners, numbers),
    case=DegenerateSolids,
    faults=case_faults,
    holds=_holds,
    flags=frozenset(FLAGS_OF_SOLIDS),
    count=2,
)
