"""All settings, and input that must be refused. To add one, write a folder and a line here."""

from __future__ import annotations

from typing import Any

from minkref.degeneracies.disc.outline import DISC
from minkref.degeneracies.files import Made
from minkref.degeneracies.invalid.catalogue import INVALID, INVALID_MESH
from minkref.degeneracies.motion.outline import MOTION
from minkref.degeneracies.outline import CORPUS, Group, Outline
from minkref.degeneracies.plane.outline import PLANE
from minkref.degeneracies.solids.outline import SOLIDS
from minkref.degeneracies.space.outline import SPACE
from minkref.degeneracies.unions.outline import UNIONS

OUTLINES: tuple[Outline, ...] = (PLANE, SPACE, SOLIDS, DISC, MOTION, UNIONS)
GROUPS: tuple[Group, ...] = (*OUTLINES, INVALID, INVALID_MESH)
GROUP_OF: dict[str, Group] = {name: group for group in GROUPS for name in group.families}

FAMILIES, SPACE_FAMILIES, SOLID_FAMILIES, DISC_FAMILIES, PATH_FAMILIES, UNION_FAMILIES = (
    outline.families for outline in OUTLINES
)
# Families with cases in the large corpus, in the format case-v1.
ALL_FAMILIES: dict[str, Any] = {
    name: family
    for outline in OUTLINES
    if outline.corpus == CORPUS
    for name, family in outline.families.items()
}


def outline_of(value: Any) -> Outline:
    """The setting of a case file; the plane if the file says nothing of another."""
    told = value if isinstance(value, dict) else {}
    return next((one for one in reversed(OUTLINES) if one.holds(told)), OUTLINES[0])


def made_member(family: Any, seed: int, index: int, size: int | None = None) -> Made:
    """Makes ID.json, and ID.cert.json if the member has a certificate, or an invalid file."""
    return GROUP_OF[family.name].made(family, seed, index, size)
