"""Sums with a disc, enclosed between sums with inner and outer polygons, by the polygons'
routes."""

from __future__ import annotations

import sys
from dataclasses import dataclass, field
from fractions import Fraction

from minkref import _core
from minkref.disc.disc import Disc
from minkref.disc.polygons import GAP, polygon_near

Bounds = tuple[float, float]


@dataclass
class Sandwich:
    """The faults, and whether the number of holes is the same for both polygons, and then for the
    disc too."""

    corners: int  # the inner polygon's
    areas: tuple[Fraction, Fraction]
    same_holes: bool
    faults: list[str] = field(default_factory=list)


FINER = (Fraction(1, 10**5), Fraction(3, 10**7))  # times the radius: 704 and 4,056 corners


def sandwich(
    P: _core.PolygonSet, squared_radius: Fraction, counts: tuple[int, int], area: Bounds,
    within: Fraction,
) -> Sandwich:  # fmt: skip
    """`counts`: the sum's components and holes; `within`: most distance between polygons and
    circle, as a part of the radius. A larger set has the larger sum: areas grow, components only
    join. Holes may end or be born: if both polygons have another hole count than the disc, one may
    have ended and one begun in between, so finer polygons are asked. Only disagreement by the
    finest counts as a fault."""
    sys.set_int_max_str_digits(0)  # exact areas have as many digits as they need
    for fineness in (within, *(each for each in FINER if each < within)):
        found = _with_polygons(P, squared_radius, counts, area, fineness)
        if not found.faults:
            break
    return found


def _with_polygons(
    P: _core.PolygonSet, squared_radius: Fraction, counts: tuple[int, int], area: Bounds,
    within: Fraction,
) -> Sandwich:  # fmt: skip
    disc = Disc("", squared_radius)
    tolerance = disc.bounds(80)[0] * within
    gap, unit = tolerance / GAP, tolerance / 2**40
    polygons = [polygon_near(disc, tolerance, outside, gap, unit) for outside in (False, True)]
    inner, outer = (_core.minkowski_sum(P, Q, "1") for Q in polygons)
    areas = Fraction(inner.region.area()), Fraction(outer.region.area())
    found = Sandwich(polygons[0].vertices, areas, inner.holes == outer.holes)
    components, holes = counts
    low, high = (Fraction(bound) for bound in area)
    if not (areas[0] <= high and low <= areas[1]):
        found.faults.append(f"area {float(low)}, not from {float(areas[0])} to {float(areas[1])}")
    if not outer.components <= components <= inner.components:
        found.faults.append(
            f"{components} components, not from {outer.components} to {inner.components}"
        )
    if found.same_holes and holes != inner.holes:
        found.faults.append(f"{holes} holes, not {inner.holes}")
    return found
