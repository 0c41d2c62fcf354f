"""The outline of pairs of convex bodies in space."""

from __future__ import annotations

from minkref.degeneracies.outline import Outline, families_of
from minkref.degeneracies.space import always, at_a_scaling, magnitudes, shapes, updates
from minkref.degeneracies.space.case_document import DegenerateInSpace
from minkref.degeneracies.space.case_faults import case_faults
from minkref.degeneracies.space.flags import FLAGS_IN_SPACE

SPACE = Outline(
    word="space",
    dimension=3,
    families=families_of(always, at_a_scaling, shapes, magnitudes, updates),
    case=DegenerateInSpace,
    faults=case_faults,
    holds=lambda value: value.get("dimension") == 3,
    flags=frozenset(FLAGS_IN_SPACE),
    count=3,
)
