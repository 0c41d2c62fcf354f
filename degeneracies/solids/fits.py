"""Exact fits at one scale: slots, cavities, gaps, cups; and parts of a sum that touch."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import product
from random import Random

from minkref.degeneracies.solids.draft import Probe, SolidDraft, SolidFacts, SolidFamily
from minkref.degeneracies.solids.placing import placed, plus, swapped
from minkref.degeneracies.solids.proofs import (
    contacts_at,
    coplanar,
    facing_with_area,
    fills,
    of_both,
)
from minkref.degeneracies.solids.ties import Tie
from minkref.degeneracies.space.vectors import vector
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, middle
from minkref.fuzz.space.generators import machined

THIRD = Fraction(1, 3)


def slot(dice: Random) -> SolidDraft:
    """A plate as thick as the slot of a U is wide, low enough for the slot."""
    wide, floor, rise, deep = (dice.randint(1, 3) for _ in range(4))
    left, right = dice.randint(1, 2), dice.randint(1, 2)
    end, top = left + wide, floor + rise + 1
    outline = [(0, 0), (end + right, 0), (end + right, top), (end, top)]
    outline += [(end, floor), (left, floor), (left, top), (0, top)]
    U = machined.prism_over(outline, [], 0, deep)
    plate = machined.plate(wide, rise, dice.randint(1, 3))
    q = vector(left + Fraction(wide, 2), floor + Fraction(rise + 1, 2) + 1, Fraction(deep, 2))
    return SolidDraft(plate, U, probes=(Probe(centre(plate), q),))


def _slot_closes(dice: Random, size: int) -> SolidDraft:
    return placed(dice, swapped(dice, slot(dice)))


def cavity(dice: Random, longer: int) -> SolidDraft:
    """A box that fits a cavity exactly, except along so many axes, where the box is shorter."""
    sizes = [dice.randint(1, 2) for _ in range(3)]
    axes = dice.sample(range(3), longer)
    inner = [size + dice.randint(1, 2) * (k in axes) for k, size in enumerate(sizes)]
    low, high = [dice.randint(1, 2) for _ in range(3)], [dice.randint(1, 2) for _ in range(3)]
    outer = machined.plate(*(a + b + c for a, b, c in zip(low, inner, high, strict=True)))
    hole = machined.plate(inner[0], inner[1], inner[2]).translated(vector(*low))
    filling = machined.plate(sizes[0], sizes[1], sizes[2])
    hollow = outer.with_faces_of(hole.turned_inside_out())
    return SolidDraft(filling, hollow, probes=(Probe(centre(filling), centre(hole)),))


def _cavity(longer: int) -> Callable[[Random, int], SolidDraft]:
    return lambda dice, size: placed(dice, swapped(dice, cavity(dice, longer)))


def _apart(dice: Random, axes: int) -> SolidDraft:
    """Two boxes with a gap between them along some axes, and a box as large as the gap along those;
    around the middle of the gap a probe in each octant."""
    gap = [dice.randint(1, 2) if k < axes else 0 for k in range(3)]
    first = [dice.randint(1, 3) for _ in range(3)]
    start = [first[k] + gap[k] if k < axes else dice.randint(-1, 0) for k in range(3)]
    other = machined.plate(*(dice.randint(2, 3) for _ in range(3)))
    both = machined.plate(first[0], first[1], first[2]).with_faces_of(
        other.translated(vector(start[0], start[1], start[2]))
    )
    bridge = machined.plate(*(g or dice.randint(1, 3) for g in gap))
    x, y, z = (first[k] + Fraction(gap[k], 2) if k < axes else Fraction(1, 2) for k in range(3))
    p, q = centre(bridge), (x, y, z)
    around = [_octant(signs, axes) for signs in product((1, -1), repeat=axes)]
    probes = (Probe(p, q), *(Probe(p, plus(q, step)) for step in around))
    return placed(dice, swapped(dice, SolidDraft(bridge, both, probes=probes)))


def _octant(signs: tuple[int, ...], axes: int) -> Point:
    x, y, z = (signs[k] * THIRD if k < axes else Fraction(0) for k in range(3))
    return x, y, z


def _touching(facts: SolidFacts, axes: int) -> list[Tie]:
    """Whether two parts of the sum touch at the first probe, and at no other probe around it."""
    around = contacts_at(facts, facts.probes[1:])
    wanted = ["overlap", *["empty"] * (2**axes - 2), "overlap"]
    return fills(facts, axes, False) if around == wanted else []


def _cup_and_plate(dice: Random, size: int) -> SolidDraft:
    """A plate wider than a cup, turned upside down to cut all the cup's walls."""
    wide, deep, high = dice.randint(1, 2), dice.randint(1, 2), dice.randint(2, 3)
    cup = machined.cup(wide, deep, high, (1, 1, 1, 1), 1)
    plate = machined.plate(wide + 2, deep + 2, 1)
    q = vector(1 + Fraction(wide, 2), 1 + Fraction(deep, 2), 1 + Fraction(high, 2))
    draft = SolidDraft(plate, cup, probes=(Probe(centre(plate), q),))
    return placed(dice, swapped(dice, draft), shears=False)


def _wound_zero_times(facts: SolidFacts) -> list[Tie]:
    probe = facts.probes[0]
    if facts.contacts(probe)[0] != "overlap" or facts.euler(probe) != 0:
        return []
    return coplanar(facts, 2, of_both)


def centre(solid: Polyhedron) -> Point:
    return middle(solid.box)


FAMILIES = (
    SolidFamily(
        "solids-slot-closes",
        "a slot as wide as a plate is thick, at one scale: a gap, a tight sheet, solid",
        _slot_closes,
        lambda facts: fills(facts, 1, True),
    ),
    SolidFamily(
        "solids-components-meet",
        "two components that a box bridges exactly at one scale",
        lambda dice, size: _apart(dice, 1),
        lambda facts: facing_with_area(facts) and fills(facts, 1, True),
    ),
    SolidFamily(
        "solids-cavity-to-point",
        "a cavity that is a single point at one scale",
        _cavity(0),
        lambda facts: fills(facts, 3, True),
    ),
    SolidFamily(
        "solids-cavity-to-line",
        "a cavity that is a segment at one scale: a bar in a channel",
        _cavity(1),
        lambda facts: fills(facts, 2, True),
    ),
    SolidFamily(
        "solids-cavity-to-sheet",
        "a cavity that is a rectangle at one scale: a plate in a slot",
        _cavity(2),
        lambda facts: fills(facts, 1, True),
    ),
    SolidFamily(
        "solids-touch-along-edge",
        "parts of the sum that touch along an edge at one scale",
        lambda dice, size: _apart(dice, 2),
        lambda facts: _touching(facts, 2),
    ),
    SolidFamily(
        "solids-touch-at-vertex",
        "parts of the sum that touch in a point at one scale",
        lambda dice, size: _apart(dice, 3),
        lambda facts: _touching(facts, 3),
    ),
    SolidFamily(
        "solids-cup-and-plate",
        "a cup and a plate: a point inside around which the convolution winds zero times",
        _cup_and_plate,
        _wound_zero_times,
    ),
)
