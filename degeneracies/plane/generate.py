"""Members of families, by drawing until a candidate belongs."""

from __future__ import annotations

from random import Random

from minkref.degeneracies.plane.draft import Facts, Family, NothingDrawn
from minkref.errors import Refusal

PATIENCE = 400
FEWEST, MOST = 8, 24  # vertices of a pair, about


def member(family: Family, seed: int, index: int, size: int | None = None) -> Facts:
    """Draws member number `index`, with about `size` vertices if the family can be large. The
    arguments alone decide the result, on any machine. Refuses a size that no draw reaches."""
    dice = Random(f"minkref degeneracy {family.name} {seed} {index}")
    for _ in range(PATIENCE):
        wanted = dice.randint(FEWEST, MOST) if size is None else size
        try:
            facts = Facts.of_valid(family.draw(dice, wanted))
        except NothingDrawn:
            continue
        if facts is not None and facts.has_zeros and family.belongs(facts):
            return facts
    raise nothing_drawn(family.name, seed, index, size)


def nothing_drawn(family: str, seed: int, index: int, size: int | None) -> Exception:
    """Refuses the size; without a size, the fault is ours."""
    if size is None:
        return RuntimeError(f"{family}:{seed}:{index}: nothing drawn belongs to the family")
    return Refusal(
        f"no member of about {size} vertices was found in {PATIENCE} draws",
        f"{family} --seed {seed} --index {index} --size {size}",
        "choose another --size or --seed, or leave out --size",
        "nothing-drawn",
    )
