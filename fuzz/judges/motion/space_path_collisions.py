"""Decides whether a part collides on a path in space at one scale: by the static sum of the
obstacles and the turned part, with its tight passages, or by the slow engine. Neither knows another
scale."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise

from minkref import _core
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, cross, dot, minus
from minkref.fuzz.judges.motion.space_path_cases import SpacePathCase
from minkref.fuzz.space.exact_sum import EDGES, core_polyhedron, exposed_sum, polyhedron_of_planes
from minkref.fuzz.space.membership import Surface
from minkref.oracle.slow.space.exposed import Exposed, exposed_from_json, lifted, rings_of
from minkref.oracle.slow.space.solid import Solid, solid_from_json
from minkref.oracle.slow.space.solid_sum import SolidSum, uniform

ORIGIN: Point = (Fraction(0), Fraction(0), Fraction(0))
Ends = tuple[Point, Point]
#: Normal, offset, rings.
Face = tuple[Point, Fraction, list[list[Point]]]


class StaticSum:
    """The sum of the obstacles and -R at one scale. `contact`: allowed or forbidden; if allowed,
    tight passages tell the part that interiors leave out: not for operands with too many convex
    pieces (LimitExceeded)."""

    def __init__(self, case: SpacePathCase, scale: Fraction, contact: str) -> None:
        turned = case.part.reflected(ORIGIN)
        sum_ = exposed_sum(turned, case.obstacles, scale, EDGES)
        self._contact = contact
        self._surface = Surface(polyhedron_of_planes(sum_))
        self._sheets: Surface | None = None
        self._lines: list[Ends] = []
        self._points: list[Point] = []
        self._faces = _faces_of(sum_)
        self._thin = _ThinOperand(case, scale) if case.is_thin else None
        if contact == "allowed":
            self._read_passages(turned, case.obstacles, scale)

    def meets(self, path: Sequence[Point]) -> bool:
        """Whether a place on the path lies in the sum of interiors (contact allowed), or in the
        sum."""
        return any(self._meets_at(x) for x in self._places(path))

    def _meets_at(self, x: Point) -> bool:
        winding = self._surface.winding(x)
        if self._contact == "forbidden":
            return winding is None or winding > 0
        if winding is None or winding <= 0:
            return False
        return not self._is_passage(x) if self._thin is None else self._thin.overlaps(x)

    def _read_passages(self, turned: Polyhedron, obstacles: Polyhedron, scale: Fraction) -> None:
        operands = core_polyhedron(turned), core_polyhedron(obstacles)
        found = json.loads(_core.tight_passages_in_space(*operands, (str(scale),) * 3))
        sheets = exposed_from_json({"planes": found["sheets"]})
        self._sheets = Surface(polyhedron_of_planes(sheets))
        self._faces += _faces_of(sheets)
        self._lines = [(_point(a), _point(b)) for a, b in found["lines"]]
        self._points = [_point(p) for p in found["points"]]

    def _is_passage(self, x: Point) -> bool:
        if self._sheets is not None and self._sheets.winding(x) is None:
            return True
        return x in self._points or any(_is_between(a, b, x) for a, b in self._lines)

    def _places(self, path: Sequence[Point]) -> Iterator[Point]:
        """Yields the vertices, places where a feature of the sum begins or ends on the path, and a
        place between any two of them."""
        yield from path
        for a, b in pairwise(path):
            if a != b:
                yield from places_between(a, b, self._faces, self._lines, self._points)


class _ThinOperand:
    """A point or a segment against the inside of a solid, place by place."""

    def __init__(self, case: SpacePathCase, scale: Fraction) -> None:
        self._scale = scale
        self._is_part = case.part.is_thin
        thin, solid = case.part, case.obstacles
        if not self._is_part:
            thin, solid = solid, thin
        self._ends, self._surface = thin.vertices, Surface(solid)
        self._faces = [_face_of([solid.vertices[k] for k in face]) for face in solid.faces]

    def overlaps(self, x: Point) -> bool:
        """Whether the thin operand, without its ends, meets the inside, with the part at x."""
        s = self._scale
        if self._is_part:
            ends = [_plus(x, end, s) for end in self._ends]
        else:  # as the part sees it
            ends = [_times(1 / s, minus(end, x)) for end in self._ends]
        places = iter(ends)
        if len(ends) == 2:
            places = (p for p in places_between(ends[0], ends[1], self._faces) if p not in ends)
        return any((self._surface.winding(p) or 0) > 0 for p in places)


def places_between(
    a: Point,
    b: Point,
    faces: Sequence[Face],
    lines: Sequence[Ends] = (),
    points: Sequence[Point] = (),
) -> Iterator[Point]:
    """Places on a segment: its ends, the places where faces, lines or points begin or end on the
    segment, and a place between any two of these."""
    cuts = sorted({Fraction(0), Fraction(1), *_cuts(a, b, faces, lines, points)})
    middles = [(s + t) / 2 for s, t in pairwise(cuts)]
    for t in (*middles, *cuts):
        yield _plus(a, minus(b, a), t)


def _cuts(
    a: Point, b: Point, faces: Sequence[Face], lines: Sequence[Ends], points: Sequence[Point]
) -> Iterator[Fraction]:
    borders = list(lines)
    for n, offset, rings in faces:
        above, beyond = dot(n, a) - offset, dot(n, b) - offset
        if above * beyond < 0:
            yield above / (above - beyond)
        elif above == 0 and beyond == 0:
            for ring in rings:
                borders += list(zip(ring, [*ring[1:], ring[0]], strict=True))
    for p, q in borders:
        yield from _where_lines_meet(a, b, p, q)
    for p in points:
        if _is_between(a, b, p):
            yield _part(a, b, p)


def _faces_of(exposed: Exposed) -> list[Face]:
    faces: list[Face] = []
    for plane, polygons in exposed.planes.items():
        (x, y, z), offset = plane
        rings = [[lifted(corner, plane) for corner in ring] for ring in rings_of(polygons)]
        faces.append(((Fraction(x), Fraction(y), Fraction(z)), offset, rings))
    return faces


def _face_of(ring: list[Point]) -> Face:
    n = ORIGIN
    for p, q in pairwise(ring[1:]):
        n = _plus(n, cross(minus(p, ring[0]), minus(q, ring[0])))
    return n, dot(n, ring[0]), [ring]


def by_slow_engine(case: SpacePathCase, scale: Fraction, contact: str) -> bool:
    """Decides from half-spaces for the sums of all pairs of convex pieces: each half-space leaves
    an interval on a path segment. For two operands with a volume. Exact."""
    sum_ = SolidSum(_slow(case.part.reflected(ORIGIN)), _slow(case.obstacles), uniform(scale))
    path = case.path if len(case.path) > 1 else [*case.path, *case.path]
    return any(
        _some_place(a, b, sum_, pair, contact == "allowed")
        for a, b in pairwise(path)
        for pair in range(len(sum_.pairs))
    )


def _some_place(a: Point, b: Point, sum_: SolidSum, pair: int, strictly: bool) -> bool:
    low, high = Fraction(0), Fraction(1)
    for (x, y, z), bound, unit in sum_.bounds(pair):
        n = (Fraction(x), Fraction(y), Fraction(z))
        at = dot(n, a) - Fraction(bound, unit)
        slope = dot(n, minus(b, a))
        if slope == 0:
            if at > 0 or (strictly and at == 0):
                return False
        elif slope > 0:
            high = min(high, -at / slope)
        else:
            low = max(low, -at / slope)
    return low < high or (low == high and not strictly)


def _slow(body: Polyhedron) -> Solid:
    return solid_from_json(body.document())


def _point(row: Sequence[str]) -> Point:
    x, y, z = (Fraction(text) for text in row)
    return x, y, z


def _plus(a: Point, b: Point, factor: Fraction = Fraction(1)) -> Point:
    return a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]


def _times(factor: Fraction, a: Point) -> Point:
    return _plus(ORIGIN, a, factor)


def _part(a: Point, b: Point, p: Point) -> Fraction:
    """Returns the parameter, between a and b, of the line's nearest point to p."""
    way = minus(b, a)
    return dot(minus(p, a), way) / dot(way, way)


def _is_between(a: Point, b: Point, p: Point) -> bool:
    to_a, to_b = minus(a, p), minus(b, p)
    return cross(to_a, to_b) == ORIGIN and dot(to_a, to_b) <= 0


def _where_lines_meet(a: Point, b: Point, p: Point, q: Point) -> Iterator[Fraction]:
    """Yields parameters on the segment from a to b where it meets the line through p and q; for a
    common line, the parameters of p and q."""
    way, other, between = minus(b, a), minus(q, p), minus(p, a)
    n = cross(way, other)
    if n == ORIGIN:
        if cross(way, between) == ORIGIN:
            yield from (t for t in (_part(a, b, p), _part(a, b, q)) if 0 < t < 1)
    elif dot(n, between) == 0:
        t = dot(cross(between, other), n) / dot(n, n)
        if 0 < t < 1:
            yield t
