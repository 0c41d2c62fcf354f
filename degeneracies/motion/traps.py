"""Traps that close at a scale as the part grows, or open."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from minkref.degeneracies.motion.draft import PathDraft, PathFacts, PathFamily, Spot
from minkref.degeneracies.motion.placing import heights, placed, some_part
from minkref.degeneracies.plane.shapes import number
from minkref.fuzz.geometry.plane import ORIGIN, Ring, extent, moved


def _room(dice: Random, low: Fraction, high: Fraction) -> tuple[Ring, Spot]:
    """Walls around (0, 0), wide enough for parts of a size of 6, with a door on the right; the
    middle of the room."""
    far, thick = 8, number(dice, 1, 3)
    out = far + thick
    ring: Ring = [
        (-out, -out), (out, -out), (out, low), (far, low), (far, -far), (-far, -far), (-far, far),
        (far, far), (far, high), (out, high), (out, out), (-out, out),
    ]  # fmt: skip
    return ring, ORIGIN


def _centred(ring: Ring) -> Ring:
    x, y, width, height = extent(ring)
    (shape,) = moved([[ring]], -x - Fraction(width) / 2, -y - Fraction(height) / 2)
    return shape[0]


def _closes(dice: Random) -> PathDraft:
    """A part in a room: it leaves by the door while lower than the door."""
    part = _centred(some_part(dice))
    low, high = heights(part)
    width, door = Fraction(dice.randint(1, 2)), Fraction(dice.randint(-5, 3))
    room, place = _room(dice, door, door + width)
    return placed(dice, PathDraft([[part]], [[room]], (place,), width / (high - low)))


def _opens(dice: Random) -> PathDraft:
    """A part shaped as a room with a door, around a post that holds the part until the door is as
    wide as the post."""
    post = _centred(some_part(dice))
    low, high = heights(post)
    width = Fraction(dice.randint(1, 2))
    door = -width * Fraction(dice.randint(1, 7), 8)  # right of the origin: it stays there
    room, place = _room(dice, door, door + width)
    return placed(dice, PathDraft([[room]], [[post]], (place,), (high - low) / width))


def _has_trap_from(facts: PathFacts) -> bool:
    """At the scale itself a part that may touch still gets out."""
    open_, closed = (facts.trapped(contact).ranges for contact in ("allowed", "forbidden"))
    first = [one for one in open_ if one.low == facts.scale and not one.low_in]
    return bool(first) and any(one.low == facts.scale and one.low_in for one in closed)


def _has_trap_to(facts: PathFacts) -> bool:
    open_, closed = (facts.trapped(contact).ranges for contact in ("allowed", "forbidden"))
    last = [one for one in open_ if one.high == facts.scale and not one.high_in]
    return bool(last) and any(one.high == facts.scale and one.high_in for one in closed)


FAMILIES = (
    PathFamily(
        "trap-closes", "a door as wide as the part at one scale: it is trapped above it", _closes,
        _has_trap_from, is_trap=True,
    ),
    PathFamily(
        "trap-opens", "a part with a door, as wide as a post in it at one scale: it is trapped "
        "below it", _opens, _has_trap_to, is_trap=True, until=2,
    ),
)  # fmt: skip
