"""Ways out at one scale: the free places as trapezoids, tight passages between them, and a polyline
through connected trapezoids (docs/certificates-paths.md)."""

from __future__ import annotations

import json
from collections import deque
from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, pairwise

from minkref import _core
from minkref.certify.motion.convex_cells import Place, Polygon, middle

MOST_CORNERS = 600  # on the sum's boundary


class FreeCells:
    """Convex sets of a part's free places at a scale, and the pairs of sets with a common place:
    closed sets if contact is allowed, open sets if contact is forbidden. The first set covers
    everything far to the left. Exact. O(n^2) for n corners of the sum."""

    def __init__(
        self,
        part: _core.PolygonSet,
        obstacles: _core.PolygonSet,
        scale: Fraction,
        contact: str,
        at: Place,
    ) -> None:
        self.touching = contact == "allowed"
        found = _core.minkowski_sum(
            part.scaled("-1"), obstacles, str(scale), "definition", tight_passages=self.touching
        )
        rings = _rings(found.region)
        corners = [at, *(p for ring in rings for p in ring)]
        if len(corners) > MOST_CORNERS:
            raise OverflowError
        self.low = min(c for p in corners for c in p) - 1
        self.high = max(c for p in corners for c in p) + 1
        self.cells: list[Polygon] = []
        self.joints: dict[int, dict[int, Place]] = {}
        self._add_trapezoids(rings, sorted({x for x, _ in corners} | {self.low, self.high}))
        if self.touching:
            self._add_passages([_places(points) for points, _ in found.passage_rows()])

    def way(self, at: Place) -> list[Place] | None:
        """Returns a way from a free place to a place left of everything that collides, or None."""
        start = [k for k in range(len(self.cells)) if self._holds(k, at)]
        before: dict[int, int | None] = dict.fromkeys(start)
        queue = deque(start)
        while queue and 0 not in before:
            i = queue.popleft()
            for j in self.joints.get(i, {}):
                if j not in before:
                    before[j] = i
                    queue.append(j)
        if 0 not in before:
            return None
        way, k = [middle(self.cells[0])], 0
        while (earlier := before[k]) is not None:
            way += [self.joints[earlier][k], middle(self.cells[earlier])]
            k = earlier
        return [at, *way[::-1]]

    def _add_trapezoids(self, rings: list[Polygon], xs: list[Fraction]) -> None:
        """Adds trapezoids between verticals through all corners; joins two that share a part of a
        vertical."""
        edges = [
            (min(a, b), max(a, b))
            for ring in rings
            for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)
            if a[0] != b[0]
        ]
        before: list[tuple[int, Fraction, Fraction]] = []  # cells, with their parts of a vertical
        for left, right in pairwise(xs):
            rows = [(self.low, self.low), (self.high, self.high)]
            rows += [
                (_height(*edge, left), _height(*edge, right))
                for edge in edges
                if edge[0][0] <= left and right <= edge[1][0]
            ]
            rows.sort(key=lambda row: row[0] + row[1])
            here: list[tuple[int, Fraction, Fraction]] = []
            after: list[tuple[int, Fraction, Fraction]] = []
            for (a, b), (c, d) in zip(rows[::2], rows[1::2], strict=True):
                corners = [(left, a), (right, b), (right, d), (left, c)]
                self.cells.append(list(dict.fromkeys(corners)))
                here.append((len(self.cells) - 1, a, c))
                after.append((len(self.cells) - 1, b, d))
            self._join_along(left, [*before, *here])
            before = after

    def _join_along(self, x: Fraction, parts: list[tuple[int, Fraction, Fraction]]) -> None:
        for (i, a, b), (j, c, d) in combinations(parts, 2):
            low, high = max(a, c), min(b, d)
            if low < high or (low == high and self.touching):
                self._join(i, j, (x, (low + high) / 2))

    def _add_passages(self, passages: list[Polygon]) -> None:
        first = len(self.cells)
        for points in passages:
            self.cells += [[p] for p in points] if len(points) == 1 else map(list, pairwise(points))
        for i in range(first, len(self.cells)):
            for j in range(i):
                p = next((p for p in self._ends(i, j)), None)
                if p is not None:
                    self._join(i, j, p)

    def _ends(self, i: int, j: int) -> Iterator[Place]:
        """Yields either cell's corners on the other cell."""
        yield from (p for p in self.cells[i] if self._holds(j, p))
        yield from (p for p in self.cells[j] if self._holds(i, p))

    def _holds(self, k: int, x: Place) -> bool:
        """Whether a place lies on the closure of a cell."""
        cell = self.cells[k]
        if len(cell) < 3:
            a, b = cell[0], cell[-1]
            u, v = (a[0] - x[0], a[1] - x[1]), (b[0] - x[0], b[1] - x[1])
            return u[0] * v[1] == u[1] * v[0] and u[0] * v[0] + u[1] * v[1] <= 0
        turned = zip(cell, [*cell[1:], cell[0]], strict=True)
        return all(
            (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]) >= 0 for a, b in turned
        )

    def _join(self, i: int, j: int, at: Place) -> None:
        self.joints.setdefault(i, {})[j] = at
        self.joints.setdefault(j, {})[i] = at


def _height(a: Place, b: Place, x: Fraction) -> Fraction:
    """The height at x of the line through two places."""
    return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0])


def _places(points: list[tuple[str, str]]) -> Polygon:
    return [(Fraction(x), Fraction(y)) for x, y in points]


def _rings(region: _core.PolygonSet) -> list[Polygon]:
    polygons = json.loads(region.canonical_json())["polygons"]
    return [_places(ring) for one in polygons for ring in (one["outer"], *one["holes"])]
