"""The families of invalid input by name, one for each refusal that reading an operand, a case or a
scale may give.

Some refusals have no family, as nothing can be drawn or a file would be too large: `cannot-read`
and `unknown-format` (a missing file, an ending), `cannot-write` and `not-representable` (writing),
`file-too-large` (64 MiB) and `too-many-values` (32 MB at least); for meshes also
`too-many-vertices`, `too-many-digits`, `too-many-faces` and `too-many-face-corners`.
"""

from __future__ import annotations

from random import Random

from minkref.degeneracies.invalid import (
    cases_and_scales,
    encoding,
    geometries,
    limits,
    mesh_surfaces,
    mesh_texts,
    numbers,
    pairs_of_rings,
    rings,
    structure,
    words,
)
from minkref.degeneracies.invalid.member import Invalid, InvalidFamily

INVALID_FAMILIES: dict[str, InvalidFamily] = {
    family.name: family
    for module in (
        rings,
        pairs_of_rings,
        numbers,
        words,
        encoding,
        structure,
        geometries,
        cases_and_scales,
        limits,
    )
    for family in module.FAMILIES
}

INVALID_MESH_FAMILIES: dict[str, InvalidFamily] = {
    family.name: family for module in (mesh_surfaces, mesh_texts) for family in module.FAMILIES
}


def invalid_member(family: InvalidFamily, seed: int, index: int) -> Invalid:
    """Draws member number `index`. The arguments alone decide the result, on any machine."""
    return family.draw(Random(f"minkref invalid {family.name} {seed} {index}"))
