"""The families by name, in the order of their subjects: those of the plane, and those in space."""

from __future__ import annotations

from minkref.degeneracies.draft import Family
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
from minkref.degeneracies.space import always, at_a_scaling, shapes, updates
from minkref.degeneracies.space import magnitudes as magnitudes_in_space
from minkref.degeneracies.space.draft import SpaceFamily

FAMILIES: dict[str, Family] = {
    family.name: family
    for module in (
        parallel_edges,
        incidences,
        critical_scales,
        holes,
        contacts,
        convolutions,
        magnitudes,
        touches,
    )
    for family in module.FAMILIES
}

SPACE_FAMILIES: dict[str, SpaceFamily] = {
    family.name: family
    for module in (always, at_a_scaling, shapes, magnitudes_in_space, updates)
    for family in module.FAMILIES
}
