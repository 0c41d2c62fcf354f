"""Sums with parts that touch themselves or one another, and operands that fit one another."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from minkref.degeneracies.plane.draft import Draft, Facts, Family
from minkref.degeneracies.plane.shapes import changed, framed, number, reflected, turned
from minkref.fuzz.geometry.plane import Ring, box, extent
from minkref.fuzz.plane.families.drawing import convex
from minkref.fuzz.plane.families.touching_pairs import touching_shape


def _happens(facts: Facts, feature: str, *changes: str) -> bool:
    return any(row["feature"] == feature and row["change"] in changes for row in facts.topology)


def _swallowed(dice: Random, size: int) -> Draft:
    """An island in a ring, and a box as wide as the narrowest water."""
    x, y = number(dice, 1, 4), number(dice, 1, 4)
    island = convex(dice, dice.randint(3, 5), 6)
    x0, y0, width, height = extent(island)
    water = box(
        x0 - x, y0 - y, width + 2 * x + number(dice, 0, 3), height + 2 * y + number(dice, 0, 3)
    )
    ring = framed([water])
    P = box(0, 0, x, y / 2) if dice.random() < 0.5 else box(0, 0, x / 2, y)
    return changed(dice, Draft([[P]], [ring, [island]], Fraction(1)))


def _is_swallowed(facts: Facts) -> bool:
    return _happens(facts, "component", "merge", "death")


def _bent(dice: Random, size: int) -> Draft:
    """A bent bar with a gap, and a box as wide as the gap."""
    gap, wall = number(dice, 1, 4), number(dice, 1, 3)
    wide, high = gap + number(dice, 1, 6), number(dice, 1, 6)
    left = number(dice, 0, 2) * (wide - gap) / 4
    ring: Ring = [
        (0, 0), (wide + 2 * wall, 0), (wide + 2 * wall, high + 2 * wall),
        (wall + left + gap, high + 2 * wall), (wall + left + gap, high + wall),
        (wide + wall, high + wall), (wide + wall, wall), (wall, wall), (wall, high + wall),
        (wall + left, high + wall), (wall + left, high + 2 * wall), (0, high + 2 * wall),
    ]  # fmt: skip
    if left == 0:  # the gap is at the left wall
        ring = [p for k, p in enumerate(ring) if k not in (8, 9)]
        ring[-2:] = [(wall, high + 2 * wall), (0, high + 2 * wall)]
    P = box(0, 0, gap, min(high, gap) / 3)
    return changed(dice, Draft([[P]], [[ring]], Fraction(1)))


def _is_bent(facts: Facts) -> bool:
    (_, before), _, (_, after) = facts.counts
    return after > before and _happens(facts, "hole", "birth", "split", "touch")


def _piece(dice: Random) -> Ring:
    a, b, c = (dice.randint(1, 4) for _ in range(3))
    kind = dice.randrange(3)
    if kind == 0:
        return [(0, 0), (a + b, 0), (a + b, c), (a, c), (a, b + c), (0, b + c)]
    if kind == 1:
        return [
            (0, 0),
            (a, 0),
            (a, b),
            (a + c, b),
            (a + c, 0),
            (2 * a + c, 0),
            (2 * a + c, b + c),
            (0, b + c),
        ]
    return convex(dice, dice.randint(3, 7), 9)


def _fits_hole(dice: Random, size: int) -> Draft:
    P = _piece(dice)
    return changed(dice, Draft([[P]], [framed([turned(reflected(P))])], Fraction(1)))


def _is_point(facts: Facts) -> bool:
    return any(len(points) == 1 for points in facts.passages)


def _fits_slot(dice: Random, size: int) -> Draft:
    """A room with a way out as wide as P."""
    width = number(dice, 1, 4)
    room, length, wall = width + number(dice, 1, 5), number(dice, 1, 6), number(dice, 1, 3)
    side = number(dice, 0, 3) * (room - width) / 3
    ring: Ring = [
        (-wall, -wall), (room + wall, -wall), (room + wall, room + length),
        (side + width, room + length), (side + width, room), (room, room), (room, 0), (0, 0),
        (0, room), (side, room), (side, room + length), (-wall, room + length),
    ]  # fmt: skip
    ring = [p for k, p in enumerate(ring) if p != ring[k - 1]]
    straight = [
        p
        for k, p in enumerate(ring)
        if (p[0] - ring[k - 1][0]) * (ring[(k + 1) % len(ring)][1] - p[1])
        != (p[1] - ring[k - 1][1]) * (ring[(k + 1) % len(ring)][0] - p[0])
    ]
    P = box(0, 0, width, number(dice, 1, 3) * min(width, room) / 4)
    return changed(dice, Draft([[P]], [[straight]], Fraction(1)))


def _is_slot(facts: Facts) -> bool:
    """A room closes, and the way out is left as a passage."""
    return (
        any(len(points) >= 2 for points in facts.passages)
        and facts.counts[2][1] > facts.counts[0][1]
    )


def _fits_notch(dice: Random, size: int) -> Draft:
    """A blind way as wide as P."""
    width, depth, wall = number(dice, 1, 4), number(dice, 2, 6), number(dice, 1, 3)
    ring: Ring = [
        (0, 0), (2 * wall + width, 0), (2 * wall + width, wall + depth),
        (wall + width, wall + depth), (wall + width, wall), (wall, wall), (wall, wall + depth),
        (0, wall + depth),
    ]  # fmt: skip
    high = dice.choice((depth, depth / 2, depth / 3))
    P = box(0, 0, width, high)
    if dice.random() < 0.4:
        P = [*P[:2], (width, high), (width / 2, high + 1), (0, high)]
    return changed(dice, Draft([[P]], [[ring]], Fraction(1)))


def _is_notch(facts: Facts) -> bool:
    return bool(facts.passages) and facts.counts[0][1] == facts.counts[2][1] == 0


def _touching(dice: Random, size: int) -> Draft:
    P = touching_shape(dice, max(8, size))
    Q = box(0, 0, *(Fraction(dice.randint(1, 4), 4) for _ in range(2)))
    if dice.random() < 0.5:
        Q = [(x / 4, y / 4) for x, y in ((Fraction(u), Fraction(v)) for u, v in convex(dice, 4, 4))]
    return changed(dice, Draft(P, [[Q]], Fraction(dice.randint(1, 6), dice.randint(1, 6))))


def _is_touching(facts: Facts) -> bool:
    """Whether two vertices of P coincide, on different rings or on the same ring."""
    return len(set(facts.vertices.P)) < len(facts.vertices.P)


FAMILIES = (
    Family(
        "component-swallowed",
        "a component of the sum that another one takes in",
        _swallowed,
        _is_swallowed,
    ),
    Family(
        "outer-touches-itself",
        "an outer boundary that touches itself and closes a hole",
        _bent,
        _is_bent,
    ),
    Family("fits-hole", "an operand that fits a hole of the other exactly", _fits_hole, _is_point),
    Family("fits-slot", "an operand that just passes a slot into a room", _fits_slot, _is_slot),
    Family("fits-notch", "an operand that fits a notch exactly", _fits_notch, _is_notch),
    Family("rings-touching", "rings of an operand that touch at points", _touching, _is_touching),
)
