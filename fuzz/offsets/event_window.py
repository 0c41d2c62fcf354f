"""Whether a set grown by a disc changes its topology between two radii."""

from __future__ import annotations

import math
from fractions import Fraction

from minkref import _core

MOST_VERTICES = 400  # of a set whose events are found


def changes_within(P: _core.PolygonSet, low: Fraction, high: Fraction) -> bool:
    """Whether components or holes may change at a radius from low to high: holes are born or end,
    components join; also at the ends, as far as doubles tell. True of larger sets: not known."""
    if P.vertices > MOST_VERTICES or not P.is_region:
        return P.vertices > MOST_VERTICES
    index = _core.disc_index(P)
    bounds = [pair for birth, end, _, _ in index.holes() for pair in (birth, end)]
    bounds += [pair for pair, _, _ in index.joins()]
    return _any_within([pair for pair in bounds if pair is not None], low, high)


def event_within(P: _core.PolygonSet, low: Fraction, high: Fraction) -> bool:
    """The same for any event: no curve comes or goes at other radii."""
    if P.vertices > MOST_VERTICES or not P.is_region:
        return P.vertices > MOST_VERTICES
    return _any_within(_core.disc_index(P).radii(), low, high)


def _any_within(bounds: list[tuple[float, float]], low: Fraction, high: Fraction) -> bool:
    return any(
        Fraction(pair[0]) <= high and low <= Fraction(pair[1])
        for pair in bounds
        if math.isfinite(pair[1])
    )
