"""The bounds of a result within a tolerance: the exact sandwich around the sum."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.plane import Number, box, extent
from minkref.fuzz.plane.exact_shapes import set_of, shape_of


def square(half: Number) -> _core.PolygonSet:
    """The square about the origin, of half side `half`."""
    return set_of([[box(-half, -half, 2 * half, 2 * half)]])


def grown(region: _core.PolygonSet, half: Fraction) -> _core.PolygonSet:
    """The sum of a set and the square of half side `half`, canonical."""
    if region.is_empty or not half:
        return region
    return _core.minkowski_sum(region, square(half), "1", "paper", "rational").region


def shrunk(region: _core.PolygonSet, half: Fraction) -> _core.PolygonSet:
    """The closure of all points whose square with half side `half` lies in the set."""
    if region.is_empty or not half:
        return region
    left, low, width, height = extent([point for outer, *_ in shape_of(region) for point in outer])
    pad = 2 * half + 1
    around = set_of([[box(left - pad, low - pad, width + 2 * pad, height + 2 * pad)]])
    outside = _core.minus(around, region)
    return _core.minus(region, grown(outside, half))
