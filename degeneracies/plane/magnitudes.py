"""Coordinates that are large, small, or both, and an event that depends on their last digit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from random import Random

from minkref.degeneracies.draft import Draft, Facts, Family
from minkref.degeneracies.plane.contacts import FAMILIES as CONTACTS
from minkref.degeneracies.plane.holes import FAMILIES as HOLES
from minkref.degeneracies.shapes import framed
from minkref.fuzz.families.drawing import box, moved, scaled

BASES = tuple(
    family
    for family in (*HOLES, *CONTACTS)
    if family.name
    in ("hole-to-segment", "hole-to-polyline", "fits-hole", "fits-notch", "fits-slot")
)
LARGEST_DOUBLE = Fraction(2) ** 1024 - Fraction(2) ** 971
LEAST_DOUBLE = Fraction(1, 2**1074)


def _base(dice: Random, size: int) -> Draft:
    return dice.choice(BASES).draw(dice, size)


def _mixed(dice: Random, size: int) -> Draft:
    """P tiny, and the scale large, or the other way round."""
    draft = _base(dice, size)
    factor = Fraction(10) ** (dice.choice((-1, 1)) * dice.randint(9, 30))
    return replace(draft, P=scaled(draft.P, factor), scale=draft.scale / factor)


def _far(dice: Random, size: int) -> Draft:
    draft = _base(dice, size)
    far = [dice.choice((-1, 1)) * (10 ** dice.randint(12, 20) + dice.randint(0, 9)) for _ in "xyxy"]
    return replace(draft, P=moved(draft.P, far[0], far[1]), Q=moved(draft.Q, far[2], far[3]))


def _doubles(dice: Random, size: int) -> Draft:
    """In units of the least double, or near the largest one."""
    a, b = dice.randint(1, 9), dice.randint(1, 9)
    P, Q = box(0, 0, a, b), framed([box(0, 0, a, b + dice.randint(1, 9))])
    unit = LEAST_DOUBLE
    if dice.random() < 0.5:
        most = max(abs(Fraction(c)) for ring in Q for point in ring for c in point)
        unit = Fraction(2) ** (int(LARGEST_DOUBLE / most).bit_length() - 1)
    return Draft(scaled([[P]], unit), scaled([Q], unit), Fraction(1))


def _grid(dice: Random, size: int) -> Draft:
    """Integers up to those of 64, 53 or 32 bits; sums go beyond."""
    most = 2 ** dice.choice((63, 62, 53, 31, 30)) - 1
    a, b = dice.randint(most // 8, most // 4), dice.randint(most // 8, most // 4)
    hole = box(-a, -b, a, 2 * b)
    P = box(0, 0, a, b)
    outer = box(-most, -most, 2 * most, 2 * most)
    return Draft([[P]], [[outer, [hole[0], *hole[:0:-1]]]], Fraction(1))


def _largest(facts: Facts) -> Fraction:
    return max(abs(c) for point in (*facts.vertices.P, *facts.vertices.Q) for c in point)


def _is(condition: Callable[[Facts], bool]) -> Callable[[Facts], bool]:
    """And the scale is one at which something happens."""
    return lambda facts: bool(facts.arrangement) and condition(facts)


def _ratio(facts: Facts) -> Fraction:
    p, q = (max(abs(c) for v in vs for c in v) for vs in (facts.vertices.P, facts.vertices.Q))
    return max(p / q, q / p)


def _are_doubles(facts: Facts) -> bool:
    values = {abs(c) for point in (*facts.vertices.P, *facts.vertices.Q) for c in point}
    low, high = min(values - {0}), max(values)
    return high > Fraction(2) ** 1020 or low < Fraction(1, 2**1060)


FAMILIES = (
    Family(
        "mixed-magnitudes",
        "operands of very different size that meet at a scale as different",
        ("event", "magnitudes", "tight-passage"),
        _mixed,
        _is(lambda facts: _ratio(facts) > 10**6),
    ),
    Family(
        "large-translation",
        "operands far from the origin",
        ("event", "large-translation", "tight-passage"),
        _far,
        _is(lambda facts: _largest(facts) > 10**11),
    ),
    Family(
        "limits-of-float64",
        "coordinates near the largest double, or in units of the least",
        ("event", "limits", "magnitudes", "tight-passage"),
        _doubles,
        _is(_are_doubles),
    ),
    Family(
        "limits-of-integers",
        "coordinates at the limits of integers of 32, 53 and 64 bits",
        ("event", "limits", "tight-passage"),
        _grid,
        _is(lambda facts: _largest(facts) >= 2**30 - 1),
    ),
)
