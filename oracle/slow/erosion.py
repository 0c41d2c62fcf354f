"""The erosion sP - Q = {x : x + Q within sP}: the holes of the sum of what surrounds P and -Q.

A box about P, less the interior of P, blocks x iff its interior meets x + Q. The box leaves room
for Q all around sP, so a hole of the sum is a component of the erosion's interior, and a tight
passage belongs to what the erosion has beside these.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from .canonical import digest
from .exact import InputError, Point
from .minkowski import checked_frame, sum_of
from .operand import Operand, Polygon, Ring
from .plane import Edge
from .state import State, state
from .validity import box_of, containments
from .walks import corners


@dataclass(frozen=True)
class Erosion:
    """In canonical form: the region, and beside it the remnants, points and polylines."""

    polygons: list[Polygon]
    components: int
    holes: int
    digest: str
    remnants: list[list[Point]]


def erosion(P: Operand, Q: Operand, scale: Fraction = Fraction(1)) -> Erosion:
    """Erode sP by Q. Exact. InputError for a P without area, an empty Q, and all refusals of
    minkowski_sum. Costs as much as summing P's surroundings and -Q."""
    if not P.polygons or Q.is_empty:
        raise InputError("erosion takes a P with an area, and a Q that is not empty")
    at = state(checked_frame(outside(P, room(Q, scale)), turned(Q), scale), scale)
    polygons = sorted((polygon(at, part.outer, part.holes) for part in at.complement), key=order)
    return Erosion(
        polygons, len(polygons), len(at.interior) - 1, digest(polygons), sum_of(at).tight
    )


def turned(Q: Operand) -> Operand:
    """Turn Q by half a turn about the origin."""

    def ring(points: Ring) -> Ring:
        return [(-x, -y) for x, y in points]

    parts = [Polygon(ring(part.outer), [ring(hole) for hole in part.holes]) for part in Q.polygons]
    return Operand(parts, ring(Q.ends))


def room(Q: Operand, scale: Fraction) -> Fraction:
    """Return a margin larger than Q, before scaling."""
    left, low, right, high = box_of(Q.points())
    return (right - left + high - low + 1) / scale


def outside(P: Operand, margin: Fraction) -> Operand:
    """Cut P's interior out of its box, widened by the margin."""
    left, low, right, high = box_of(P.points())
    left, low, right, high = left - margin, low - margin, right + margin, high + margin
    rings = P.rings()
    held = containments(rings, [f"ring {number}" for number in range(len(rings))])
    is_hole = [number > 0 for part in P.polygons for number in range(1 + len(part.holes))]
    polygons = [Polygon([(left, low), (right, low), (right, high), (left, high)], [])]
    of_hole: dict[int, Polygon] = {}
    for number, ring in enumerate(rings):
        if is_hole[number]:
            of_hole[number] = Polygon(ring[::-1], [])
    for number, ring in enumerate(rings):
        if not is_hole[number]:
            around = [other for other in held[number] if is_hole[other]]
            inner = max(around, key=lambda other: len(held[other]), default=None)
            (polygons[0] if inner is None else of_hole[inner]).holes.append(ring[::-1])
    return Operand([*polygons, *of_hole.values()], [])


def polygon(at: State, outer: list[Edge], holes: list[list[Edge]]) -> Polygon:
    """Write a hole as a polygon, rings in canonical form."""
    inner = [ring_of(at, ring) for ring in holes]
    return Polygon(ring_of(at, outer), sorted(inner))


def ring_of(at: State, ring: list[Edge]) -> Ring:
    points = [(x.value, y.value) for x, y in (at.place(edge.start) for edge in corners(ring))]
    first = points.index(min(points))
    return points[first:] + points[:first]


def order(part: Polygon) -> Ring:
    return part.outer
