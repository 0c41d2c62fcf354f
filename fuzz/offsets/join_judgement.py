"""Whether polygons are a set or lines grown with joins and caps: they have what every right answer
has, deeper than the tolerance, and nothing beyond what one may have."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import lru_cache

import minkref
from minkref import _core
from minkref.fuzz.geometry.plane import Shape
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.distance import Distances, OutsideDistances
from minkref.fuzz.offsets.hole_points import far_points
from minkref.fuzz.offsets.join_pieces import JoinPieces
from minkref.fuzz.offsets.manner import SHARP
from minkref.fuzz.offsets.sandwich import Breach, Sandwich
from minkref.fuzz.offsets.sharp_front import front_of, is_free
from minkref.fuzz.plane.exact_shapes import shape_of

DEEP = Fraction(3, 2)  # tolerances: a square around the point lies inside, not only a disc
ROUNDED = Fraction(1, 1 << 30)  # of the radius: more than normals lose


def join_breaches(case: AskedOffset, half: Fraction, answer: _core.PolygonSet) -> list[Breach]:
    """A point too much and a missing point (`missing`), if any. To erode, what the answer leaves
    out is meant."""
    result = shape_of(answer)
    little = abs(case.radius) * ROUNDED
    if case.manner.join == SHARP:
        return _sharp_breaches(case, half, little, result)
    too_much = _beyond(_union(case, case.radius + half, False), half + little, result)
    due, deep = _union(case, case.radius, True), DEEP * half + little
    lack = _lacking(due, deep, result)
    if lack is not None and half:
        # A hole that only the last of the radius closes may stay.
        lately = minkref.subtract(due, [_union(case, case.radius - half, True)])
        lack = _lacking(due, deep, shape_of(minkref.unite([answer, lately])))
    return [one for one in (too_much, lack) if one is not None]


def _sharp_breaches(
    case: AskedOffset, half: Fraction, little: Fraction, result: Shape
) -> list[Breach]:
    """Both for the moved rings, before parts meet; then points that the disc sweeps."""
    if not is_free(case, half):
        low, high = abs(case.radius) - half, abs(case.radius) + half
        found = Sandwich(case.near, low, high, result, case.inward).breaches(())
        return [one for one in found if one.missing]
    least, most = (abs(case.radius), DEEP * half + little), (abs(case.radius) + half, half + little)
    if case.inward:
        least, most = most, least
    (low, inside), (high, outside), front = least, most, front_of(case)
    both = _beyond(front.at(high), outside, result), _lacking(front.at(low), inside, result)
    return [replace(one, missing=one.missing != case.inward) for one in both if one is not None]


def expected_text(case: AskedOffset) -> str:
    """What every right answer has, in polygons or curves; to erode with corners that depend on
    more, what none goes beyond."""
    if case.manner.join != SHARP:
        return _union(case, case.radius, True).to_json()
    free = is_free(case, Fraction(0))
    return front_of(case).at(abs(case.radius)).to_json() if free else case.form


@lru_cache(4)
def _union(case: AskedOffset, reach: Fraction, due: bool) -> _core.PolygonSet:
    return JoinPieces(reach, case.manner, due).of(case)


def _beyond(allowed: _core.PolygonSet, most: Fraction, result: Shape) -> Breach | None:
    near = Distances(shape_of(allowed))
    holes = far_points(_core.offset(allowed, str(most**2)), near, most)
    return Sandwich(near, most, most, result).too_far(holes)


def _lacking(due: _core.PolygonSet, deep: Fraction, result: Shape) -> Breach | None:
    near = OutsideDistances(shape_of(due))
    left = far_points(_core.inset(due, str(deep**2)), near, deep, outer=True)
    found = Sandwich(near, deep, deep, result, turned=True).too_far(left)
    return None if found is None else Breach(found.point, True, found.square, whole=found.whole)
