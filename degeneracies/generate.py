"""Members of families: drawn until one belongs."""

from __future__ import annotations

from random import Random

from minkref.degeneracies.draft import Facts, Family, NothingDrawn

PATIENCE = 400
FEWEST, MOST = 8, 24  # vertices of a pair, about


def member(family: Family, seed: int, index: int) -> Facts:
    """The member of this number. It depends on nothing else, on any machine."""
    dice = Random(f"minkref degeneracy {family.name} {seed} {index}")
    for _ in range(PATIENCE):
        try:
            facts = Facts.of_valid(family.draw(dice, dice.randint(FEWEST, MOST)))
        except NothingDrawn:
            continue
        if facts is not None and facts.has_zeros and family.belongs(facts):
            return facts
    raise RuntimeError(f"{family.name}:{seed}:{index}: nothing drawn belongs to the family")
