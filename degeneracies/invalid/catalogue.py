"""The families of invalid input by name, one for each refusal that reading an operand, a case or a
scale may give.

Some refusals have no family, as nothing can be drawn or a file would be too large: `cannot-read`
and `unknown-format` (a missing file, an ending), `cannot-write` and `not-representable` (writing),
`file-too-large` (64 MiB) and `too-many-values` (32 MB at least); for meshes also
`too-many-vertices`, `too-many-digits`, `too-many-faces` and `too-many-face-corners`.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path
from random import Random

from minkref.degeneracies.files import Made
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
from minkref.degeneracies.outline import Group, families_of

INVALID_FAMILIES: dict[str, InvalidFamily] = families_of(
    rings, pairs_of_rings, numbers, words, encoding, structure, geometries, cases_and_scales, limits
)
INVALID_MESH_FAMILIES: dict[str, InvalidFamily] = families_of(mesh_surfaces, mesh_texts)


@dataclass(frozen=True, kw_only=True)
class Refused(Group):
    """Families of input that must be refused."""

    sizeless: str = "invalid input"

    def made(self, family: InvalidFamily, seed: int, index: int, size: int | None = None) -> Made:
        return made_invalid(family, seed, index)


INVALID = Refused(word="invalid", dimension=2, families=INVALID_FAMILIES)
INVALID_MESH = Refused(word="invalid-mesh", dimension=3, families=INVALID_MESH_FAMILIES)


def invalid_member(family: InvalidFamily, seed: int, index: int) -> Invalid:
    """Draws member number `index`. The arguments alone decide the result, on any machine."""
    return family.draw(Random(f"minkref invalid {family.name} {seed} {index}"))


def made_invalid(family: InvalidFamily, seed: int, index: int) -> Made:
    """ID.EXT, which must be refused; ID.refusal.json: what a message should say."""
    drawn = invalid_member(family, seed, index)
    ending = Path(drawn.file_name).suffix
    told = json.dumps([ending, drawn.part, drawn.scale]).encode() + drawn.content
    stem = f"{family.name}-{hashlib.sha256(told).hexdigest()[:12]}"
    name = f"{stem}{ending}"
    renamed = {drawn.file_name: name, drawn.argument: f"{name}{drawn.part}"}
    refusal = {
        "file": name,
        "operand": renamed[drawn.argument],
        "scale": drawn.scale,
        "code": drawn.code,
        "place": [renamed.get(text, text) for text in drawn.place],
        "source": f"minkref generate {family.name} --seed {seed} --index {index}",
    }
    beside = f"{stem}.refusal.json", (json.dumps(refusal) + "\n").encode()
    return Made(family.name, index, stem, (name, drawn.content), beside, certified=False)
