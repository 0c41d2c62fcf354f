"""Members of families of sums with a disc, by drawing until a candidate belongs."""

from __future__ import annotations

from random import Random

from minkref import _core
from minkref.degeneracies.disc.draft import DiscFacts, DiscFamily
from minkref.degeneracies.plane.draft import NothingDrawn
from minkref.degeneracies.plane.generate import FEWEST, MOST, PATIENCE, nothing_drawn


def drawn_with_disc(
    family: DiscFamily, seed: int, index: int, size: int | None = None
) -> DiscFacts:
    """Draws member number `index`, with about `size` vertices if the family can be large. The
    arguments alone decide the result, on any machine. Refuses a size that no draw reaches."""
    dice = Random(f"minkref degeneracy {family.name} {seed} {index}")
    for _ in range(PATIENCE):
        wanted = dice.randint(FEWEST, MOST) if size is None else size
        try:
            facts = DiscFacts.of(family.draw(dice, wanted))
            if family.belongs(facts):
                return facts
        except (NothingDrawn, _core.BadInput):
            continue
    raise nothing_drawn(family.name, seed, index, size)
