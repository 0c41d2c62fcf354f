"""The families by name, in the order of their subjects."""

from __future__ import annotations

from minkref.degeneracies.draft import Family
from minkref.degeneracies.plane import (
    contacts,
    convolutions,
    critical_scales,
    holes,
    incidences,
    lines,
    magnitudes,
)

FAMILIES: dict[str, Family] = {
    family.name: family
    for module in (
        lines,
        incidences,
        critical_scales,
        holes,
        contacts,
        convolutions,
        magnitudes,
    )
    for family in module.FAMILIES
}
