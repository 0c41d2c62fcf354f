"""How far a part at one scale stays from a boundary on its best way: bounds from a grid."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

from .moving import squared_distance_inside, squared_distance_on_path
from .rooms import Rooms
from .segments import Point, Ring

Flat = tuple[float, float, float, float]


class PartRooms(Rooms):
    """Rooms for a part at a scale instead of a point: by all pairs of edges, in doubles."""

    def __init__(
        self, rings: Sequence[Ring], inside: bool, cells: int, part: Sequence[Ring], scale: Fraction
    ) -> None:
        super().__init__(rings, inside, cells)
        self._part, self._scale = part, scale
        self._corners = [[(float(scale * x), float(scale * y)) for x, y in ring] for ring in part]

    def distance(self, x: float, y: float) -> float:
        """Return the distance of the part with its origin at a point, 0 on the wrong side."""
        best = min(Rooms.distance(self, x + a, y + b) for ring in self._corners for a, b in ring)
        if best == 0:
            return 0.0
        placed = [
            (x + a, y + b, x + c, y + d)
            for ring in self._corners
            for (a, b), (c, d) in zip(ring, [*ring[1:], ring[0]], strict=True)
        ]
        for wall in self._edges:
            px, py = wall[:2]
            above = 0
            for edge in placed:
                if _cross(edge, wall):
                    return 0.0
                ax, ay, bx, by = edge
                best = min(best, _to_segment(px, py, edge))
                above += (ay <= py) != (by <= py) and ax + (py - ay) / (by - ay) * (bx - ax) > px
            if above % 2 == 1:
                return 0.0
        return best

    def squared_at(self, place: Point) -> Fraction:
        """Return the squared distance of the part at a place. Exact."""
        if self._inside:
            return squared_distance_inside(self._part, self.rings, place, self._scale)
        return squared_distance_on_path(self._part, self.rings, [place], self._scale)

    def most(self) -> float:
        """Return the greatest distance at a grid point; at the best place it is less than a step
        more."""
        across, up = self._count
        return max(self._at((i, j)) for i in range(across) for j in range(up))


def _to_segment(x: float, y: float, edge: Flat) -> float:
    ax, ay, bx, by = edge
    dx, dy, px, py = bx - ax, by - ay, x - ax, y - ay
    length = dx * dx + dy * dy
    t = 0.0 if length == 0 else min(1.0, max(0.0, (px * dx + py * dy) / length))
    return math.hypot(px - t * dx, py - t * dy)


def _cross(first: Flat, second: Flat) -> bool:
    return _parts(first, second) and _parts(second, first)


def _parts(line: Flat, edge: Flat) -> bool:
    """Tell whether an edge's ends lie on both sides of a line."""
    ax, ay, bx, by = line
    cx, cy, dx, dy = edge
    c = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    d = (bx - ax) * (dy - ay) - (by - ay) * (dx - ax)
    return (c > 0) != (d > 0)
