"""Chambers: the faces into which bridges cut the outside of a polygon set. Each chamber has one
local maximum of the distance, or none farther away than its bridges."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cmp_to_key, partial
from itertools import pairwise

from .boundary import Boundary, Place, Point
from .bridges import Bridge
from .surd import sign_of, surd

Side = tuple[Point, Point]


class Chambers:
    """The plane outside the set, cut along all bridges. No two bridges cross."""

    def __init__(self, boundary: Boundary, bridges: Sequence[Bridge]) -> None:
        stops: dict[Side, list[Point]] = {}
        edges = [(edge.a, edge.b) for edge in boundary.edges]
        points = sorted({p for bridge in bridges for p in (bridge.a, bridge.b)})
        points = sorted({*points, *boundary.vertices})
        for side in edges:
            stops[side] = [side[0], *_inside(side, points), side[1]]
        self._following: dict[Point, list[Point]] = {}
        own: set[Side] = set()  # with the set on the left
        for along in stops.values():
            for p, q in pairwise(along):
                own.add((p, q))
                self._join(p, q)
        self._across = {side for b in bridges for side in ((b.a, b.b), (b.b, b.a))}
        for bridge in bridges:
            self._join(bridge.a, bridge.b)
        for p, others in self._following.items():
            others.sort(key=cmp_to_key(partial(_turn_order, p)))
        self.faces: list[list[Point]] = []
        self._face_of: dict[Side, int] = {}
        for p, others in self._following.items():
            for q in others:
                if (p, q) not in own and (p, q) not in self._face_of:
                    self._walk(p, q)

    def _join(self, p: Point, q: Point) -> None:
        for a, b in ((p, q), (q, p)):
            others = self._following.setdefault(a, [])
            if b not in others:
                others.append(b)

    def _walk(self, p: Point, q: Point) -> None:
        """Walk around the face to the left of a side."""
        number, face = len(self.faces), []
        while (p, q) not in self._face_of:
            self._face_of[p, q] = number
            face.append(p)
            others = self._following[q]
            p, q = q, others[others.index(p) - 1]
        self.faces.append(face)

    def left_of(self, p: Point, q: Point) -> int:
        return self._face_of[p, q]

    def walls(self, face: int) -> list[Side]:
        """List the chamber's sides without the bridges."""
        ring = self.faces[face]
        sides = zip(ring, [*ring[1:], ring[0]], strict=True)
        return [side for side in sides if side not in self._across]

    def is_outer(self, face: int) -> bool:
        """Tell whether this chamber is unbounded."""
        ring = self.faces[face]
        pairs = zip(ring, [*ring[1:], ring[0]], strict=True)
        return sum(p[0] * q[1] - p[1] * q[0] for p, q in pairs) < 0

    def holds(self, face: int, place: Place) -> bool:
        """Tell whether a bounded chamber holds a place that lies on none of its sides. Exact."""
        x, y = place
        ring, inside = self.faces[face], False
        for (ax, ay), (bx, by) in zip(ring, [*ring[1:], ring[0]], strict=True):
            below = [(y - surd(c)).sign() < 0 for c in (ay, by)]
            if below[0] == below[1]:
                continue
            dx, dy = bx - ax, by - ay
            turn = (x - surd(ax)).times(dy) - (y - surd(ay)).times(dx)
            if turn.sign() * sign_of(dy) < 0:
                inside = not inside
        return inside


def _inside(side: Side, points: Sequence[Point]) -> list[Point]:
    """Sort the points strictly inside a side along the side."""
    (ax, ay), (bx, by) = side
    dx, dy = bx - ax, by - ay
    square = dx * dx + dy * dy
    found: list[tuple[Fraction, Point]] = []
    for p in points:
        vx, vy = p[0] - ax, p[1] - ay
        if vx * dy == vy * dx and 0 < vx * dx + vy * dy < square:
            found.append((vx * dx + vy * dy, p))
    return [p for _, p in sorted(found)]


def _turn_order(p: Point, q: Point, r: Point) -> int:
    """Order q and r counter-clockwise around p, starting from the right: negative if q comes
    first."""
    u, v = ((x[0] - p[0], x[1] - p[1]) for x in (q, r))
    lower = [w[1] < 0 or (w[1] == 0 and w[0] < 0) for w in (u, v)]
    if lower[0] != lower[1]:
        return -1 if lower[1] else 1
    return sign_of(u[1] * v[0] - u[0] * v[1])
