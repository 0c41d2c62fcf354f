"""Members of families of paths and traps, by drawing until a candidate belongs."""

from __future__ import annotations

from random import Random

from minkref import _core
from minkref.degeneracies.motion.draft import PathFacts, PathFamily
from minkref.degeneracies.plane.generate import PATIENCE, nothing_drawn


def drawn_path(family: PathFamily, seed: int, index: int) -> PathFacts:
    """Draws member number `index`. The arguments alone decide the result, on any machine."""
    dice = Random(f"minkref degeneracy {family.name} {seed} {index}")
    for _ in range(PATIENCE):
        try:
            facts = PathFacts.of(family.draw(dice))
        except _core.BadInput:
            continue
        if family.belongs(facts):
            return facts
    raise nothing_drawn(family.name, seed, index, None)
