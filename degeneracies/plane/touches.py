"""Scales that the numbers of vertices, holes and components just below and just above do not
show."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from random import Random

from minkref import _core
from minkref.degeneracies.plane.draft import Draft, Facts, Family
from minkref.degeneracies.plane.shapes import changed, framed, number
from minkref.fuzz.geometry.plane import Polygon, Ring, Shape, box, extent, moved, written_rings
from minkref.fuzz.plane.families.drawing import convex

FRAME = 100  # half the opening of a frame around everything
ONE = Fraction(1)
Part = Callable[[Random, int], Ring]  # above the line y = 0 for 1, below it for -1


def _two_tiers(dice: Random, of_p: Part, of_q: Part, half: int) -> Draft:
    """A part of P and a part of Q stand on a line, a second part of each hangs from the line, and
    so do their sums, whose places along the line pass each other at the scale 1. The other two sums
    lie as far away as the parts of P lie apart, at least twice `half`."""
    left, right = -half - dice.randint(0, 3), half + dice.randint(0, 3)
    first = -dice.randint(half, 3 * half)
    P = [*moved([[of_p(dice, 1)]], right, 0), *moved([[of_p(dice, -1)]], left, 0)]
    Q = [*moved([[of_q(dice, 1)]], first, 0), *moved([[of_q(dice, -1)]], first + right - left, 0)]
    if dice.random() < 0.4:  # the event happens to a hole
        Q.append(framed([box(-FRAME, -FRAME, 2 * FRAME, 2 * FRAME)], dice.randint(20, 40)))
    return changed(dice, Draft(P, Q, ONE))


def _block(dice: Random, way: int) -> Ring:
    """A block with a side on the line, to the right of the block's place."""
    width, height = number(dice, 2, 5), way * number(dice, 2, 6)
    near = number(dice, -3, 1)
    far = near + number(dice, 1, 5)
    ring: Ring = [(0, 0), (width, 0), (far, height)]
    return ring if dice.random() < 0.3 else [*ring, (near, height)]


def _wedge(dice: Random, way: int) -> Ring:
    """With its tip on the line."""
    height = dice.randint(4, 9)
    return [(0, 0), (1, way * height), (-1, way * height)]


def _tooth(dice: Random, way: int) -> Ring:
    return _teeth(dice, way, 1)


def _teeth(dice: Random, way: int, count: int, apart: int = 4) -> Ring:
    """A bar with teeth, their tips on the line."""
    height, width = dice.randint(6, 9), dice.randint(1, 4)
    ring: Ring = []
    for k in range(count):
        if k:
            ring.append((apart * k - Fraction(apart, 2), way * dice.randint(2, 5)))
        ring.append((apart * k, 0))
    return [*ring, (apart * (count - 1) + width, way * height), (-width, way * height)]


def _turns_round(dice: Random, size: int) -> Draft:
    return _two_tiers(dice, _block, _block, 8)


def _touches(facts: Facts) -> bool:
    """The moving figure is the same below and above, and the sum at the scale another."""
    return {row["change"] for row in facts.boundary} == {"touch"}


def _is_turned_round(facts: Facts) -> bool:
    below, above = (found.region.vertices for found in facts.beside)
    return _touches(facts) and below == above > facts.at.region.vertices


def _pass(dice: Random, size: int) -> Draft:
    return _two_tiers(dice, _wedge, _tooth, 6)


def _is_passing(facts: Facts) -> bool:
    """At the scale alone two vertices of the sum are one point, and no hole or component knows."""
    met, apart = _met_twice(facts.at), [_met_twice(found) for found in facts.beside]
    return _touches(facts) and met > max(apart) and not facts.topology


def _met_twice(found: _core.Sum) -> int:
    """Counts vertices of the sum that coincide with another vertex."""
    rings = written_rings(found.region.canonical_json())
    places = Counter(tuple(point) for ring in rings for point in ring)
    return places.total() - len(places)


def _pocket(dice: Random, size: int) -> Draft:
    count = dice.randint(2, max(2, min(5, size // 6)))
    return _two_tiers(dice, _wedge, lambda dice, way: _teeth(dice, way, count), 3 * count + 2)


def _is_pocket(facts: Facts) -> bool:
    """Whether the sum has more holes at the scale alone."""
    below, at, above = facts.counts
    more = below == above and at[1] > below[1]
    return _touches(facts) and more and _changes(facts) == {("hole", "touch")}


def _changes(facts: Facts) -> set[tuple[str, str]]:
    return {(row["feature"], row["change"]) for row in facts.topology}


def _exchange(dice: Random, size: int) -> Draft:
    """A part that grows in a hole until it fills the hole, and a hole that grows around a part
    until it frees the part."""
    filled, freed = (convex(dice, dice.randint(3, 5), 6) for _ in range(2))
    P: Shape = [[filled], _around(freed, dice)]
    Q: Shape = [_around(filled, dice), [freed]]
    apart = 10 * FRAME
    P, Q = ([shape[0], *moved(shape[1:], apart, 0)] for shape in (P, Q))
    return changed(dice, Draft(P, Q, ONE))


def _around(ring: Ring, dice: Random) -> Polygon:
    """A frame with a hole that fits the ring, turned by half."""
    x, y, width, height = extent(ring)
    return framed([[(2 * x + width - u, 2 * y + height - v) for u, v in ring]], dice.randint(1, 4))


def _is_exchange(facts: Facts) -> bool:
    below, _, above = facts.counts
    return below == above and _changes(facts) >= {("hole", "death"), ("hole", "birth")}


FAMILIES = (
    Family(
        "side-turns-round",
        "a side of the sum that shrinks to a point and grows again the other way round",
        _turns_round,
        _is_turned_round,
    ),
    Family(
        "corners-pass",
        "two corners of the sum that pass each other along a line, and touch at one scale only",
        _pass,
        _is_passing,
    ),
    Family(
        "pocket-at-one-scale",
        "a hole that is there at one scale, and neither just below nor just above it",
        _pocket,
        _is_pocket,
    ),
    Family(
        "one-hole-for-another",
        "a hole that closes at the scale at which another one opens",
        _exchange,
        _is_exchange,
    ),
)
