"""Prisms over polygons with holes; the sum of two prisms equals the prism over the plane sum."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import lcm

from minkref import _core
from minkref.fuzz.geometry.face_triangles import Corner, ring_triangles
from minkref.fuzz.geometry.plane import in_box, mapped, turn
from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import Point, Scale, factors
from minkref.fuzz.plane.exact_shapes import set_of, shape_of

Flat = tuple[Fraction, Fraction]
Ring = list[Flat]
Polygons = list[tuple[Ring, list[Ring]]]  # outer ring, holes


@dataclass(frozen=True)
class Prism:
    """All (x, y, z) with (x, y) in a polygon set and low <= z <= high."""

    region: _core.PolygonSet
    low: Fraction
    high: Fraction

    @cached_property
    def polygons(self) -> Polygons:
        return [(outer, holes) for outer, *holes in self.region.rings()]

    @property
    def volume(self) -> Fraction:
        return Fraction(self.region.area()) * (self.high - self.low)

    def contains(self, point: Point) -> bool:
        """In the closed prism."""
        if not self.low <= point[2] <= self.high:
            return False
        return any(
            _side(outer, point) >= 0 and all(_side(hole, point) <= 0 for hole in holes)
            for outer, holes in self.polygons
        )

    def polyhedron(self) -> Polyhedron:
        """The prism's surface. The region's rings must not touch. A polygon without holes has one
        face as its lid, a polygon with holes has triangles."""
        vertices: list[Point] = []
        faces: list[Face] = []
        for outer, holes in self.polygons:
            corners = [corner for ring in (outer, *holes) for corner in ring]
            base, count = len(vertices), len(corners)
            vertices += [(x, y, self.low) for x, y in corners]
            vertices += [(x, y, self.high) for x, y in corners]
            start = base
            for ring in (outer, *holes):
                for k in range(len(ring)):
                    a, b = start + k, start + (k + 1) % len(ring)
                    faces.append((a, b, b + count, a + count))
                start += len(ring)
            lids = _lid(outer, holes) if holes else [tuple(range(count))]
            for lid in lids:
                faces.append(tuple(base + count + k for k in lid))
                faces.append(tuple(base + k for k in reversed(lid)))
        return Polyhedron(tuple(vertices), tuple(faces))


def sum_of_prisms(P: Prism, Q: Prism, scale: Scale) -> Prism:
    """Returns sP + Q, with its region in canonical form."""
    a, b, c = factors(scale)
    scaled = set_of(mapped(shape_of(P.region), lambda p: (a * p[0], b * p[1])))
    region = _core.minkowski_sum(scaled, Q.region, "1").region
    return Prism(region, c * P.low + Q.low, c * P.high + Q.high)


def _side(ring: Ring, point: Point) -> int:
    """1 inside the simple ring, 0 on the ring, -1 outside."""
    x, y = point[0], point[1]
    inside = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1], strict=True):
        turn = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
        if turn == 0 and min(ax, bx) <= x <= max(ax, bx) and min(ay, by) <= y <= max(ay, by):
            return 0
        if (ay > y) != (by > y) and (turn > 0) == (by > ay):
            inside = not inside
    return 1 if inside else -1


def _lid(outer: Ring, holes: list[Ring]) -> list[Face]:
    """Returns triangles of the polygon, as positions in the list of all corners. Bridges that meet
    no ring on their way join holes to the rest."""
    unit = lcm(*(n.denominator for ring in (outer, *holes) for corner in ring for n in corner))
    corners: list[Corner] = [
        (int(x * unit), int(y * unit)) for ring in (outer, *holes) for x, y in ring
    ]
    edges: list[tuple[int, int]] = []
    loops: list[list[int]] = []
    start = 0
    for ring in (outer, *holes):
        loop = list(range(start, start + len(ring)))
        edges += list(zip(loop, loop[1:] + loop[:1], strict=True))
        loops.append(loop)
        start += len(ring)
    joined, waiting = loops[0], loops[1:]
    while waiting:
        joined, used, bridge = _join(corners, edges, joined, waiting)
        waiting.remove(used)
        edges.append(bridge)
    found = ring_triangles([corners[k] for k in joined])
    faces = [(joined[i], joined[j], joined[k]) for i, j, k in found]
    if any(turn(*(corners[k] for k in face)) <= 0 for face in faces):
        raise ValueError("the region cannot be cut into triangles: do rings touch?")
    return list(faces)


def _join(
    corners: list[Corner], edges: list[tuple[int, int]], joined: list[int], loops: list[list[int]]
) -> tuple[list[int], list[int], tuple[int, int]]:
    for loop in loops:
        for at, there in enumerate(loop):
            for place, here in enumerate(joined):
                if _is_free(corners, edges, here, there) and _opens(corners, joined, place, there):
                    around = [*loop[at:], *loop[: at + 1]]
                    ring = [*joined[: place + 1], *around, *joined[place:]]
                    return ring, loop, (here, there)
    raise ValueError("a hole cannot be joined to the outer ring: do rings touch?")


def _opens(corners: list[Corner], joined: list[int], place: int, there: int) -> bool:
    """The bridge leaves the ring at this place to its inner side."""
    before = corners[joined[place - 1]]
    here = corners[joined[place]]
    after = corners[joined[(place + 1) % len(joined)]]
    far = corners[there]
    left, right = turn(here, after, far) > 0, turn(before, here, far) > 0
    return (left and right) if turn(before, here, after) > 0 else (left or right)


def _is_free(corners: list[Corner], edges: list[tuple[int, int]], here: int, there: int) -> bool:
    a, b = corners[here], corners[there]
    for i, j in edges:
        c, d = corners[i], corners[j]
        turns = turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)
        if i in (here, there) or j in (here, there):
            other = d if i in (here, there) else c
            if turn(a, b, other) == 0 and in_box(a, b, other):
                return False
        elif ((turns[0] > 0) != (turns[1] > 0) and (turns[2] > 0) != (turns[3] > 0)) or any(
            side == 0 and in_box(*where)
            for side, where in zip(turns, ((a, b, c), (a, b, d), (c, d, a), (c, d, b)), strict=True)
        ):
            return False
    return True
