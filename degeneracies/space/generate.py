"""Members of families in space, by drawing until a candidate belongs."""

from __future__ import annotations

from random import Random

from minkref import _core
from minkref.degeneracies.plane.draft import NothingDrawn
from minkref.degeneracies.plane.generate import FEWEST, MOST, PATIENCE, nothing_drawn
from minkref.degeneracies.space.draft import Coincidence, SpaceFacts, SpaceFamily


def member_in_space(
    family: SpaceFamily, seed: int, index: int, size: int | None = None
) -> tuple[SpaceFacts, list[Coincidence]]:
    """Draws member number `index`, with about `size` vertices if the family can be large, and the
    coincidences that prove membership. The arguments alone decide the result, on any machine.
    Refuses a size that no draw reaches."""
    dice = Random(f"minkref degeneracy {family.name} {seed} {index}")
    for _ in range(PATIENCE):
        wanted = dice.randint(FEWEST, MOST) if size is None else size
        try:
            facts = SpaceFacts.of(family.draw(dice, wanted))
        except (NothingDrawn, _core.BadInput):
            continue
        shown = family.proof(facts)
        if shown:
            return facts, shown
    raise nothing_drawn(family.name, seed, index, size)
