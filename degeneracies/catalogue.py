"""The families by name, grouped by subject: the plane, convex bodies in space, polyhedra of any
shape, a polygon set with a disc, paths and traps."""

from __future__ import annotations

from minkref.degeneracies.disc import across, around, doors, nearly
from minkref.degeneracies.disc.draft import DiscFamily
from minkref.degeneracies.motion import along, traps
from minkref.degeneracies.motion.draft import PathFamily
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
from minkref.degeneracies.plane.draft import Family
from minkref.degeneracies.solids import always as always_of_solids
from minkref.degeneracies.solids import corners, fits, numbers, same
from minkref.degeneracies.solids.draft import SolidFamily
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

SOLID_FAMILIES: dict[str, SolidFamily] = {
    family.name: family
    for module in (always_of_solids, same, fits, corners, numbers)
    for family in module.FAMILIES
}

DISC_FAMILIES: dict[str, DiscFamily] = {
    family.name: family for module in (around, across, doors, nearly) for family in module.FAMILIES
}

PATH_FAMILIES: dict[str, PathFamily] = {
    family.name: family for module in (along, traps) for family in module.FAMILIES
}

# Families with cases in the format case-v1.
ALL_FAMILIES: dict[str, Family | SpaceFamily | SolidFamily] = {
    **FAMILIES,
    **SPACE_FAMILIES,
    **SOLID_FAMILIES,
}
