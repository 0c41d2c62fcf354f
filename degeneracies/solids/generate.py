"""Members of families of polyhedra of any shape, by drawing until a candidate belongs."""

from __future__ import annotations

from random import Random

from minkref import _core
from minkref.degeneracies.plane.draft import NothingDrawn
from minkref.degeneracies.plane.generate import FEWEST, MOST, PATIENCE, nothing_drawn
from minkref.degeneracies.solids.draft import SolidDraft, SolidFacts, SolidFamily
from minkref.degeneracies.solids.ties import Tie


def drawn_solids(
    family: SolidFamily, seed: int, index: int, size: int | None = None
) -> tuple[SolidDraft, SolidFacts, list[Tie]]:
    """Draws member number `index`, with about `size` vertices if the family can be large, and the
    ties that prove membership. The arguments alone decide the result, on any machine. Refuses a
    size that no draw reaches."""
    dice = Random(f"minkref degeneracy {family.name} {seed} {index}")
    for _ in range(PATIENCE):
        wanted = dice.randint(FEWEST, MOST) if size is None else size
        try:
            draft = family.draw(dice, wanted)
            facts = SolidFacts.of(draft)
        except (NothingDrawn, _core.BadInput):
            continue
        shown = family.proof(facts)
        if shown:
            return draft, facts, shown
    raise nothing_drawn(family.name, seed, index, size)
