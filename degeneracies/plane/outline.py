"""The outline of pairs in the plane."""

from __future__ import annotations

from minkref.degeneracies.outline import Outline, families_of
from minkref.degeneracies.plane import (
    contacts,
    convolutions,
    critical_scales,
    holes,
    incidences,
    magnitudes,
    parallel_edges,
    touches,
)
from minkref.degeneracies.plane.case_document import Degenerate
from minkref.degeneracies.plane.case_faults import case_faults
from minkref.degeneracies.plane.flags import FLAGS

PLANE = Outline(
    word="all",
    dimension=2,
    families=families_of(
        parallel_edges,
        incidences,
        critical_scales,
        holes,
        contacts,
        convolutions,
        magnitudes,
        touches,
    ),
    case=Degenerate,
    faults=case_faults,
    holds=lambda value: value.get("dimension") != 3,
    flags=frozenset(FLAGS),
    count=11,
)
