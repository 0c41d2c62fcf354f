"""Radii for a set: at events of the set, beside them, and far from all."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

from minkref import _core
from minkref.fuzz.plane.families.dice import Dice

AT, BESIDE, ANY, TINY, HUGE = POSITIONS = (
    "at an event", "beside an event", "any radius", "tiny", "huge",
)  # fmt: skip
WEIGHTS = (3, 4, 3, 1, 1)
PARTS = tuple(Fraction(1, n) for n in (12, 25, 60, 400, 10**4, 10**6, 10**9, 10**13))


def drawn_inward(dice: Dice, P: _core.PolygonSet, size: Fraction) -> tuple[Fraction, str]:
    """Draws a radius below 0, likewise; most lie above minus the inradius, the last event."""
    outside = _core.Outside(P).set
    largest = max(_event_radii(outside), default=size / 4)
    radius, position = drawn_radius(dice, outside, largest * Fraction(9, 8))
    return -radius, position


def drawn_radius(dice: Dice, P: _core.PolygonSet, size: Fraction) -> tuple[Fraction, str]:
    """Draws a radius; also names its position. `size`: the box's. At an event that has no rational
    radius, the double next to it stands for it. Without events any radius."""
    position = dice.choices(POSITIONS, WEIGHTS)[0]
    if position in (AT, BESIDE):
        events = _event_radii(P)
        if events:
            radius = dice.choice(events)
            if position == BESIDE:
                radius *= 1 + dice.choice(PARTS) * dice.choice((-1, 1))
            return radius, position
        position = ANY
    if position == TINY:
        return size / dice.randint(200, 5000), position
    if position == HUGE:
        return size * dice.randint(4, 60), position
    return size * Fraction(dice.randint(1, 60), dice.choice((60, 97, 128))), position


def _event_radii(P: _core.PolygonSet) -> list[Fraction]:
    """Rational radii of events, and doubles near the others."""
    if not P.is_region:
        return []
    events = _core.diagram_events(P)
    found = []
    for _, square, _, (low, _), _, _ in events.rows(0, len(events)):
        root = None if square is None else _root(Fraction(square))
        found.append(Fraction(low) if root is None else root)
    return [radius for radius in dict.fromkeys(found) if radius > 0]


def _root(square: Fraction) -> Fraction | None:
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return root if root * root == square else None
