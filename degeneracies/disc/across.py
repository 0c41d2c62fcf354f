"""Parts that face each other at the disc's diameter."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from minkref.degeneracies.disc.draft import DiscDraft, DiscFacts, DiscFamily, Spot
from minkref.degeneracies.disc.placing import TRIPLES, placed
from minkref.degeneracies.plane.shapes import framed, number
from minkref.fuzz.geometry.plane import Point, Ring, Shape, box

HALF = Fraction(1, 2)


def _corridor(dice: Random, width: Fraction) -> tuple[Shape, Spot]:
    """Two boxes, one above the other, with overlapping facing sides."""
    low, high = number(dice, 2, 8), number(dice, 2, 8)
    start = number(dice, -2, 1)
    left, right = max(Fraction(0), start), min(low, start + high)
    P = [[box(0, -2, low, 2)], [box(start, width, high, dice.randint(1, 3))]]
    return P, ((left + right) / 2, width / 2)


def _hall(dice: Random, width: Fraction) -> tuple[Shape, Spot]:
    """A hole with two long sides."""
    long = width + number(dice, 1, 6)
    return [framed([box(0, 0, long, width)])], (long / 2, width / 2)


def _steps(dice: Random, width: Fraction) -> tuple[Shape, Spot]:
    """Several boxes above one, all at the same height: the ridge falls into parts."""
    count = dice.randint(2, 4)
    P: Shape = []
    at = Fraction(0)
    for _ in range(count):
        long = number(dice, 2, 4)
        P.append([box(at, width, long, dice.randint(1, 3))])
        at += long + dice.choice((Fraction(1, 3), 2 * width))
    P.append([box(0, -2, at, 2)])
    return P, (Fraction(1, 2), width / 2)


def _flat_ridge(dice: Random, size: int) -> DiscDraft:
    width = number(dice, 1, 5)
    P, place = dice.choice((_corridor, _hall, _steps))(dice, width)
    return placed(dice, DiscDraft(P, (width / 2) ** 2, (place,)))


def _comb(tips: list[Point], deep: Fraction, half: Fraction) -> Ring:
    """Teeth with these tips, from left to right, on a bar above them (deep > 0) or below."""
    way = 1 if deep > 0 else -1
    (first, level), (last, _) = tips[0], tips[-1]
    base, far = level + deep, level + deep + way
    ring: Ring = [(first - 2 * half, far), (first - 2 * half, base)]
    for x, y in tips:
        ring += [(x - half, base), (x, y), (x + half, base)]
    ring += [(last + 2 * half, base), (last + 2 * half, far)]
    return ring if way > 0 else ring[::-1]


def _pinch(dice: Random, size: int) -> DiscDraft:
    """Two combs, tip against tip, by the sides of a Pythagorean triangle: all the discs about the
    tips touch at one radius."""
    a, b, c = dice.choice([triple for triple in TRIPLES if triple[1]])
    step, count = 3 * c, min(max(size // 6, 2), 8)
    aside = dice.choice((-a, a))
    deep, half = Fraction(3 * c), Fraction(c, dice.randint(3, 6))
    low: list[Point] = [(step * k, 0) for k in range(count)]
    high: list[Point] = [(step * k + aside, b) for k in range(count)]
    P = [[_comb(low, -deep, half)], [_comb(high, deep, half)]]
    places = tuple((Fraction(step * k) + Fraction(aside, 2), Fraction(b, 2)) for k in range(count))
    return placed(dice, DiscDraft(P, Fraction(c * c, 4), places))


def _has_ridge(facts: DiscFacts) -> bool:
    """Whether a segment is reached all at once, and holds the place."""
    return (
        facts.is_at_places
        and facts.near[0].opposite(facts.places[0])
        and any(row["kind"] == "ridge" for row in facts.events)
        and any(len(points) == 2 for points in facts.passages)
    )


def _has_pinches(facts: DiscFacts) -> bool:
    saddles = sum(row["kind"] == "saddle" for row in facts.events)
    return facts.is_at_places and saddles >= len(facts.places) >= 2


FAMILIES = (
    DiscFamily(
        "disc-flat-ridge",
        "edges that face each other at the diameter of the disc",
        _flat_ridge,
        _has_ridge,
    ),
    DiscFamily(
        "disc-pinches", "discs about many vertices touch at one radius", _pinch, _has_pinches
    ),
)
