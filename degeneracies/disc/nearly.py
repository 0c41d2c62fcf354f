"""Twins of the other families: one part of the set moves by 10^-k, and an event at one radius
splits into events at several neighbouring radii."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from random import Random

from minkref import _core
from minkref.degeneracies.disc import across, around, doors
from minkref.degeneracies.disc.draft import DiscDraft, DiscFacts, DiscFamily
from minkref.degeneracies.family import NothingDrawn
from minkref.fuzz.geometry.plane import Shape, moved

FEWEST_DIGITS, MOST_DIGITS = 2, 10
PREFIX = "disc-nearly-"
STEPS = ((1, 0), (0, 1), (1, 1), (-1, 2), (3, -1))


def _twin(family: DiscFamily) -> Callable[[Random, int], DiscDraft]:
    def draw(dice: Random, size: int) -> DiscDraft:
        draft = family.draw(dice, size)
        try:
            facts = DiscFacts.of(draft)
            if not family.belongs(facts):
                raise NothingDrawn
        except _core.BadInput as error:
            raise NothingDrawn from error
        by = Fraction(1, 10 ** dice.randint(FEWEST_DIGITS, MOST_DIGITS))
        x, y = dice.choice(STEPS)
        were_near = tuple(len(near.points) for near in facts.near)
        P = _moved_in_part(dice, draft.P, by * x, by * y)
        return replace(draft, P=P, were_near=were_near)

    return draw


def _moved_in_part(dice: Random, P: Shape, dx: Fraction, dy: Fraction) -> Shape:
    """Moves one of several polygons, or one vertex on the last ring of a single polygon."""
    if len(P) > 1:
        k = dice.randrange(len(P))
        return [*P[:k], *moved([P[k]], dx, dy), *P[k + 1 :]]
    *rings, last = P[0]
    k = dice.randrange(len(last))
    x, y = last[k]
    return [[*rings, [*last[:k], (x + dx, y + dy), *last[k + 1 :]]]]


def _belongs(facts: DiscFacts) -> bool:
    """Not all places are as far as the radius any more, from as many points; the reference tells
    the events near it."""
    is_as_it_was = facts.is_at_places and all(
        len(near.points) >= count for near, count in zip(facts.near, facts.were_near, strict=True)
    )
    if is_as_it_was:
        return False
    try:
        return facts.gap > 0
    except (_core.LimitExceeded, ValueError):
        return False


FAMILIES = tuple(
    DiscFamily(
        PREFIX + family.name.removeprefix("disc-"),
        f"nearly so: {family.title}",
        _twin(family),
        _belongs,
    )
    for family in (*around.FAMILIES, *across.FAMILIES, *doors.FAMILIES)
)
