"""Whether anything changes in a set grown by a disc between two radii."""

from __future__ import annotations

import math
from fractions import Fraction

from minkref import _core

MOST_VERTICES = 400  # of a set whose events are found


def event_within(P: _core.PolygonSet, low: Fraction, high: Fraction) -> bool:
    """Whether an event has a radius from low to high, as far as doubles tell: at other radii no
    curve comes or goes. True of larger sets: not known."""
    if P.vertices > MOST_VERTICES or not P.is_region:
        return P.vertices > MOST_VERTICES
    return _any_within(_core.disc_index(P).radii(), low, high)


def _any_within(bounds: list[tuple[float, float]], low: Fraction, high: Fraction) -> bool:
    return any(
        Fraction(pair[0]) <= high and low <= Fraction(pair[1])
        for pair in bounds
        if math.isfinite(pair[1])
    )
