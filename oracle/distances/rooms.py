"""How large a disc gets from a place to another one: bounds from a grid, exact candidates."""

from __future__ import annotations

import heapq
import math
from collections.abc import Sequence
from fractions import Fraction

from .segments import Point, Ring, edges_of, is_inside, squared_to_segment


class Rooms:
    """A set with a grid outside or inside: distances from the boundary in doubles, 0 on the wrong
    side."""

    def __init__(self, rings: Sequence[Ring], inside: bool, cells: int) -> None:
        self.rings = rings
        self._edges = [
            (float(a[0]), float(a[1]), float(b[0]), float(b[1]))
            for ring in rings
            for a, b in edges_of(ring)
        ]
        self._inside = inside
        xs = [x for edge in self._edges for x in edge[::2]]
        ys = [y for edge in self._edges for y in edge[1::2]]
        width, height = max(xs) - min(xs), max(ys) - min(ys)
        margin = 0.0 if inside else max(width, height)
        self.step = (max(width, height) + 2 * margin) / cells
        self._low = min(xs) - margin, min(ys) - margin
        self._count = (
            math.ceil((width + 2 * margin) / self.step) + 1,
            math.ceil((height + 2 * margin) / self.step) + 1,
        )
        self._known: dict[tuple[int, int], float] = {}

    def distance(self, x: float, y: float) -> float:
        """Return a point's distance from the boundary, 0 on the wrong side."""
        best, crossings = math.inf, 0
        for ax, ay, bx, by in self._edges:
            dx, dy, px, py = bx - ax, by - ay, x - ax, y - ay
            length = dx * dx + dy * dy
            t = 0.0 if length == 0 else min(1.0, max(0.0, (px * dx + py * dy) / length))
            best = min(best, math.hypot(px - t * dx, py - t * dy))
            if (ay <= y) != (by <= y) and ax + (y - ay) / dy * dx > x:
                crossings += 1
        return best if (crossings % 2 == 1) == self._inside else 0.0

    def bottleneck(self, start: Point, end: Point | None) -> float:
        """Return the greatest radius at which a way from start to end, or out of the grid, lies in
        grid points as far as that from the boundary, in doubles. The true radius differs by less
        than `step`."""
        targets = None if end is None else {self._near(end)}
        first = self._near(start)
        queue = [(-self._at(first), first)]
        done = {first}
        lowest = math.inf
        while queue:
            value, node = heapq.heappop(queue)
            lowest = min(lowest, -value)
            is_out = any(k in (0, count - 1) for k, count in zip(node, self._count, strict=True))
            if node in targets if targets is not None else is_out:
                return lowest
            for dx in (-1, 0, 1):
                for dy in (-1, 0, 1):
                    other = node[0] + dx, node[1] + dy
                    if other in done or not self._has(other):
                        continue
                    done.add(other)
                    heapq.heappush(queue, (-self._at(other), other))
        return 0.0

    def candidates(self) -> set[Fraction]:
        """Return squared half distances between two vertices, and between a vertex and an edge."""
        corners = {p for ring in self.rings for p in ring}
        found = {((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2) / 4 for p in corners for q in corners}
        for ring in self.rings:
            for edge in edges_of(ring):
                found |= {squared_to_segment(p, edge) / 4 for p in corners}
        return found - {Fraction(0)}

    def squared_at(self, place: Point) -> Fraction:
        """Return the squared distance of a place from the boundary, 0 on the wrong side."""
        least = min(
            squared_to_segment(place, edge) for ring in self.rings for edge in edges_of(ring)
        )
        return least if is_inside(self.rings, place) == self._inside else Fraction(0)

    def _near(self, place: Point) -> tuple[int, int]:
        x, y = (
            round((float(c) - low) / self.step) for c, low in zip(place, self._low, strict=True)
        )
        return x, y

    def _has(self, node: tuple[int, int]) -> bool:
        return all(0 <= k < count for k, count in zip(node, self._count, strict=True))

    def _at(self, node: tuple[int, int]) -> float:
        if node not in self._known:
            x, y = (low + k * self.step for k, low in zip(node, self._low, strict=True))
            self._known[node] = self.distance(x, y)
        return self._known[node]
