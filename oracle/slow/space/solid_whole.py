"""Computes a small sum in space completely, plane by plane.

A point on a facet's plane is exposed if the sum contains the point just below but not the point
just above. The exposed part ends only at an edge of a section through a sum of two pieces. So the
sections' sides are cut where they meet, and each part is tested on both sides.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, pairwise
from math import lcm

from ..exact import Point, Vector, cross, primitive
from .exposed import Exposed, Segment, exposed, is_mirrored, lifted, seen, viewing_axis
from .solid import Place, Whole, inner, outer, shortest, vector_area, wholes
from .solid_pieces import Piece, Plane, below
from .solid_sum import SolidSum

Line = tuple[Vector, int]
WholeSegment = tuple[Vector, Vector]


def whole_sum(truth: SolidSum) -> Exposed:
    """Compute the sum in canonical form. Exact. For a few dozen pairs of pieces: planes times the
    square of pairs at worst."""
    facets = [facet_planes(truth, pair) for pair in range(len(truth.pairs))]
    planes = sorted({plane for found in facets for plane in found})
    return exposed((plane, list(_rim(truth, facets, plane))) for plane in planes)


def facet_planes(truth: SolidSum, pair: int) -> list[Plane]:
    """Return the half-spaces whose planes touch the sum of two pieces with positive area."""
    found = []
    for n, bound, unit in truth.bounds(pair):
        ways = [way for piece in truth.pairs[pair] for way in ways_along(piece, n)]
        if any(outer(a, b) != (0, 0, 0) for a in ways for b in ways):
            found.append((n, Fraction(bound, unit)))
    return found


def ways_along(piece: Piece, n: Whole) -> list[Whole]:
    """Return the ways from one corner farthest along n to the others."""
    most = piece.support(n)
    first, *rest = (corner for corner in piece.corners if inner(n, corner) == most)
    return [(x - first[0], y - first[1], z - first[2]) for x, y, z in rest]


def section(truth: SolidSum, pair: int, facets: list[Plane], plane: Plane) -> list[Place]:
    """Return the plane's section through the sum of two pieces, as a ring; none if the section has
    no area, or if the whole sum lies below the plane."""
    (a, b, c), offset = plane
    if height_along(truth, pair, (a, b, c)) < offset:
        return []
    if height_along(truth, pair, (-a, -b, -c)) < -offset:
        return []
    low, high = truth.boxes[pair]
    ring = square(plane, min(low) - 1, max(high) + 1)
    for n, bound in facets:
        if n not in ((a, b, c), (-a, -b, -c)):
            ring = below(ring, (n, bound))
            if len(ring) < 3:
                return []
    return ring if vector_area(ring) != (0, 0, 0) else []


def height_along(truth: SolidSum, pair: int, n: Whole) -> Fraction:
    """Return the greatest n . x on the sum of two pieces."""
    a, b = truth.pairs[pair]
    return Fraction(a.support(n) * b.unit + b.support(n) * a.unit, a.unit * b.unit)


def square(plane: Plane, low: Fraction, high: Fraction) -> list[Place]:
    """Return a part of the plane that appears as a square."""
    corners = [(low, low), (high, low), (high, high), (low, high)]
    return [lifted(corner, plane) for corner in corners]


def _rim(truth: SolidSum, facets: list[list[Plane]], plane: Plane) -> Iterator[Segment]:
    """Find the exposed part's edges, with the exposed part to the left as seen."""
    axis = viewing_axis(plane[0])
    rings = []
    for pair in range(len(truth.pairs)):
        flat = [seen(point, axis) for point in section(truth, pair, facets[pair], plane)]
        if flat:
            rings.append([point for k, point in enumerate(flat) if point != flat[k - 1]])
    unit = lcm(1, *(value.denominator for ring in rings for point in ring for value in point))
    lines: dict[Line, set[WholeSegment]] = defaultdict(set)
    for ring in rings:
        whole = [(int(x * unit), int(y * unit)) for x, y in ring]
        for start, end in zip(whole, whole[1:] + whole[:1], strict=True):
            lines[line_of(start, end)].add((min(start, end), max(start, end)))
    stops: dict[Line, set[Point]] = defaultdict(set)
    for (one, ours), (other, theirs) in combinations(lines.items(), 2):
        point = meeting(one, other)
        if point and has(ours, point) and has(theirs, point):
            x, y, t = point
            for line in (one, other):
                stops[line].add(over((x, y), t * unit))
    for line, segments in lines.items():
        spans = [(over(low, unit), over(high, unit)) for low, high in segments]
        for a, b in pairwise(sorted({*stops[line], *(end for span in spans for end in span)})):
            if any(low <= a and b <= high for low, high in spans):
                yield from _part(truth, plane, a, b)


def over(point: Vector, unit: int) -> Point:
    return Fraction(point[0], unit), Fraction(point[1], unit)


def has(segments: set[WholeSegment], point: tuple[int, int, int]) -> bool:
    """Tell whether a segment contains the point on its line; the third number is the coordinates'
    positive denominator."""
    x, y, t = point
    return any((a[0] * t, a[1] * t) <= (x, y) <= (b[0] * t, b[1] * t) for a, b in segments)


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
    """Tell whether the plane's point a little from x along `way` is exposed."""
    a, b, c = normal
    return truth.holds(x, [way, (-a, -b, -c)]) and not truth.holds(x, [way, normal])


def line_of(a: Vector, b: Vector) -> Line:
    """Return the line's direction, to the right or upwards, and its cross product with the line's
    points."""
    low, high = min(a, b), max(a, b)
    d = primitive(high[0] - low[0], high[1] - low[1])
    return d, cross(d, low)


def meeting(one: Line, other: Line) -> tuple[int, int, int] | None:
    """Return the intersection of two lines, with a positive third number as denominator; None if
    parallel."""
    (d, c), (e, f) = one, other
    turn = cross(d, e)
    if turn == 0:
        return None
    x, y = e[0] * c - d[0] * f, e[1] * c - d[1] * f
    return (x, y, turn) if turn > 0 else (-x, -y, -turn)
