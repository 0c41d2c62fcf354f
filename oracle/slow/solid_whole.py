"""The whole of a small sum in space, plane by plane.

A point of a facet's plane is exposed if the point just below is in the sum and the one just above
is not. What is exposed ends only where the section of some sum of two pieces ends. So the sides of
all sections are cut where they meet, and of each part both sides are asked.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from math import lcm

from .exact import Point, Vector, cross, primitive
from .exposed import Exposed, Segment, exposed, is_mirrored, lifted, seen, sides, viewing_axis
from .solid import Place, Whole, inner, outer, shortest, vector_area, wholes
from .solid_pieces import Piece, Plane, below
from .solid_sum import SolidSum

Line = tuple[Vector, Fraction]


def whole_sum(truth: SolidSum) -> Exposed:
    """The sum in canonical form. Exact. For a few dozen pairs of pieces: planes times pairs squared
    at worst."""
    facets = [facet_planes(truth, pair) for pair in range(len(truth.pairs))]
    planes = sorted({plane for found in facets for plane in found})
    return exposed((plane, list(_rim(truth, facets, plane))) for plane in planes)


def facet_planes(truth: SolidSum, pair: int) -> list[Plane]:
    """Those of its half-spaces that the sum of two pieces has an area in common with."""
    found = []
    for n, bound, unit in truth.bounds(pair):
        ways = [way for piece in truth.pairs[pair] for way in ways_along(piece, n)]
        if any(outer(a, b) != (0, 0, 0) for a in ways for b in ways):
            found.append((n, Fraction(bound, unit)))
    return found


def ways_along(piece: Piece, n: Whole) -> list[Whole]:
    """From one of its corners that are highest along n to the others."""
    most = piece.support(n)
    first, *rest = (corner for corner in piece.corners if inner(n, corner) == most)
    return [(x - first[0], y - first[1], z - first[2]) for x, y, z in rest]


def section(truth: SolidSum, pair: int, facets: list[Plane], plane: Plane) -> list[Place]:
    """What the sum of two pieces has of the plane, as a ring; none where that has no area, or all
    of the sum is below the plane."""
    (a, b, c), offset = plane
    box = truth.boxes[pair]
    ring = square(plane, min(box[:3]) - 1, max(box[3:]) + 1)
    for n, bound in facets:
        if n == (a, b, c):
            if bound < offset:
                return []
        elif n == (-a, -b, -c):
            if bound < -offset:
                return []
        else:
            ring = below(ring, (n, bound))
            if len(ring) < 3:
                return []
    return ring if vector_area(ring) != (0, 0, 0) else []


def square(plane: Plane, low: Fraction, high: Fraction) -> list[Place]:
    """A part of the plane that is seen as a square."""
    corners = [(low, low), (high, low), (high, high), (low, high)]
    return [lifted(corner, plane) for corner in corners]


def _rim(truth: SolidSum, facets: list[list[Plane]], plane: Plane) -> Iterator[Segment]:
    """Where the exposed part of the plane ends, with that part on the left as it is seen."""
    axis = viewing_axis(plane[0])
    rings = []
    for pair in range(len(truth.pairs)):
        ring = section(truth, pair, facets[pair], plane)
        if ring:
            flat = [seen(point, axis) for point in ring]
            rings.append([point for k, point in enumerate(flat) if point != flat[k - 1]])
    lines: dict[Line, set[Segment]] = defaultdict(set)
    for flat in rings:
        for a, b in sides(flat):
            lines[line_of(a, b)].add((min(a, b), max(a, b)))
    for line, segments in lines.items():
        stops = {end for segment in segments for end in segment}
        for other, theirs in lines.items():
            point = meeting(line, other)
            if point and any(a <= point <= b for a, b in theirs):
                stops.add(point)
        for a, b in pairwise(sorted(stops)):
            if any(low <= a and b <= high for low, high in segments):
                yield from _part(truth, plane, a, b)


def _part(truth: SolidSum, plane: Plane, a: Point, b: Point) -> Iterator[Segment]:
    start, end = lifted(a, plane), lifted(b, plane)
    x, y, z = ((p + q) / 2 for p, q in zip(start, end, strict=True))
    if truth.holds((x, y, z), interiors=True):
        return
    _, (p, q) = wholes([start, end])
    left = outer(plane[0], shortest((q[0] - p[0], q[1] - p[1], q[2] - p[2])))
    on_left = is_exposed(truth, plane[0], (x, y, z), left)
    on_right = is_exposed(truth, plane[0], (x, y, z), (-left[0], -left[1], -left[2]))
    if on_left != on_right:
        yield (a, b) if on_left != is_mirrored(plane[0]) else (b, a)


def is_exposed(truth: SolidSum, normal: Whole, x: Place, way: Whole) -> bool:
    """Of the point of the plane a little from x towards `way`."""
    a, b, c = normal
    return truth.holds(x, [way, (-a, -b, -c)]) and not truth.holds(x, [way, normal])


def line_of(a: Point, b: Point) -> Line:
    """Its direction, to the right or upwards, and the cross product of that with its points."""
    low, high = min(a, b), max(a, b)
    unit = lcm(*(value.denominator for value in (*low, *high)))
    d = primitive(int((high[0] - low[0]) * unit), int((high[1] - low[1]) * unit))
    return d, d[0] * low[1] - d[1] * low[0]


def meeting(one: Line, other: Line) -> Point | None:
    """The point in which two lines meet; None if they are parallel."""
    (d, c), (e, f) = one, other
    turn = cross(d, e)
    if turn == 0:
        return None
    return (e[0] * c - d[0] * f) / turn, (e[1] * c - d[1] * f) / turn
