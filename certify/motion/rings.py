"""Rings of places that collide, around a free place: cycles of convex sets. A set holds the places
where a piece of the part and a piece of the obstacles collide; the scales are found too
(docs/certificates-paths.md)."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

from minkref.certify.motion.convex_cells import Place, Polygon, below, crossings, middle
from minkref.certify.motion.moving_parts import Pair
from minkref.certify.plane.piece_nodes import Vector, hull_of
from minkref.motion.scale_ranges import ScaleRange

#: Pieces of R and of O: the places B - sA.
Nodes = tuple[int, int]
MOST_SETS = 4000
MOST_ROOTS = 40  # roots tried for a short cycle


@dataclass(frozen=True)
class Ring:
    """Sets in a cycle, each of which meets the next one between two scales (exclusive with contact
    allowed), and with the cycle leads around the place."""

    cycle: list[Nodes]
    low: Fraction
    high: Fraction | None


class Rings:
    """Finds rings around a free place. `strict`: interiors meet. Exact. Calls `spend` between
    pieces of work; an exception from `spend` ends the work."""

    def __init__(self, pair: Pair, at: Place, strict: bool, spend: Callable[[], None]) -> None:
        self.pair, self.strict = pair, strict
        self.at, self._spend = at, spend

    def around(self, s: Fraction) -> Ring | None:
        """Returns a ring around the place, or None. O(n^2) for n pairs of pieces whose sums lie
        near each other."""
        part, walls = self.pair.R, self.pair.O
        if part.pieces * walls.pieces > MOST_SETS:
            return None
        nodes = [(A, B) for A in range(part.pieces) for B in range(walls.pieces)]
        sets = [self._set(*one, s) for one in nodes]
        near: dict[int, dict[int, int]] = {k: {} for k in range(len(nodes))}
        centres = [middle(one) for one in sets]
        boxes = [_box(one) for one in sets]
        ordered = sorted(range(len(nodes)), key=lambda k: boxes[k][0])
        for place, i in enumerate(ordered):
            self._spend()
            for j in ordered[place + 1 :]:
                if boxes[j][0] > boxes[i][2]:
                    break
                if boxes[j][1] > boxes[i][3] or boxes[i][1] > boxes[j][3]:
                    continue
                if not self._meet(nodes[i], nodes[j], s):
                    continue
                p = middle(self._common(nodes[i], nodes[j], s))
                times = crossings(centres[i], p, self.at) + crossings(p, centres[j], self.at)
                near[i][j], near[j][i] = times, -times
        cycle = _shortest_cycle(near)
        if cycle is None:
            return None
        around = [nodes[k] for k in cycle]
        low, high = Fraction(0), None
        for one, other in pairwise([*around, around[0]]):
            first, last = self._scales(one, other)
            low = max(low, first)
            high = last if high is None else high if last is None else min(high, last)
        return Ring(around, low, high)

    def members(self, ring: Ring, scales: ScaleRange) -> dict[str, Any]:
        """The members `ring` and `pairs`: the corners of the ring move from where two sets meet at
        the first scale of a range to where they meet at the last."""
        corners = []
        for one, other in pairwise([ring.cycle[-1], *ring.cycle]):
            (x, y), a = middle(self._common(one, other, scales.low)), scales.low
            if scales.high is None:
                u, v = self._direction(one, other)
            elif scales.high == a:
                u, v = Fraction(0), Fraction(0)
            else:
                X, Y = middle(self._common(one, other, scales.high))
                u, v = (X - x) / (scales.high - a), (Y - y) / (scales.high - a)
            corners.append([str(c) for c in (x - a * u, u, y - a * v, v)])
        return {"ring": corners, "pairs": [list(nodes) for nodes in ring.cycle]}

    def _set(self, A: int, B: int, s: Fraction) -> Polygon:
        """Returns the corners of B - sA."""
        n, d = s.as_integer_ratio()
        corners = hull_of(
            [
                (d * x - n * u, d * y - n * v)
                for x, y in self.pair.O.hulls[B]
                for u, v in self.pair.R.hulls[A]
            ]
        )
        unit = d * self.pair.unit
        return [(Fraction(x, unit), Fraction(y, unit)) for x, y in corners]

    def _normals(self, A: int, B: int) -> list[Vector]:
        return self.pair.directions(A, B)

    def _reach(self, nodes: Nodes, n: Vector, s: Fraction) -> Fraction:
        constant, slope = self._moving_reach(nodes, n)
        return constant + s * slope

    def _moving_reach(self, nodes: Nodes, n: Vector) -> tuple[int, int]:
        """The largest value of n on B - sA, in units: linear in s."""
        A, B = nodes
        return self.pair.O.most(B, n), self.pair.R.most(A, (-n[0], -n[1]))

    def _gaps(self, one: Nodes, other: Nodes) -> list[tuple[int, int]]:
        """Linear in s, and all positive iff the interiors of two sets meet, none negative iff the
        sets do."""
        found = []
        normals = [*self._normals(*one), *((-x, -y) for x, y in self._normals(*other))]
        for n in dict.fromkeys(normals):
            c, d = self._moving_reach(one, n)
            e, f = self._moving_reach(other, (-n[0], -n[1]))
            found.append((c + e, d + f))
        return found

    def _meet(self, one: Nodes, other: Nodes, s: Fraction) -> bool:
        values = (c + s * d for c, d in self._gaps(one, other))
        return all(value > 0 if self.strict else value >= 0 for value in values)

    def _scales(self, one: Nodes, other: Nodes) -> tuple[Fraction, Fraction | None]:
        """Returns the scales between which two sets meet, for sets that meet at some scale."""
        low, high = Fraction(0), None
        for c, d in self._gaps(one, other):
            if d > 0:
                low = max(low, Fraction(-c, d))
            elif d < 0:
                root = Fraction(c, -d)
                high = root if high is None else min(high, root)
        return low, high

    def _common(self, one: Nodes, other: Nodes, s: Fraction) -> Polygon:
        """The intersection of two sets at a scale."""
        unit = self.pair.unit
        polygon = self._set(*one, s)
        for n in self._normals(*other):
            polygon = below(polygon, n, self._reach(other, n, s) / unit)
        return polygon

    def _direction(self, one: Nodes, other: Nodes) -> Place:
        """Into which both sets go on for ever."""
        part, unit = self.pair.R, self.pair.unit
        polygon = [(Fraction(x), Fraction(y)) for x, y in part.hulls[one[0]]]
        for n in part.sides[other[0]]:
            polygon = below(polygon, n, Fraction(part.most(other[0], n)))
        x, y = middle(polygon)
        return -x / unit, -y / unit


def _box(polygon: Polygon) -> tuple[Fraction, Fraction, Fraction, Fraction]:
    xs, ys = [x for x, _ in polygon], [y for _, y in polygon]
    return min(xs), min(ys), max(xs), max(ys)


def _shortest_cycle(near: dict[int, dict[int, int]]) -> list[int] | None:
    """Finds a short cycle whose winding numbers do not add up to 0, in a graph with winding numbers
    on its edges (negative in the other direction)."""
    best: list[int] | None = None
    seen: set[int] = set()
    left = MOST_ROOTS
    for root in near:
        if root in seen and (best is None or left == 0):
            continue  # its component has no such cycle, or was looked at often enough
        left -= best is not None
        before, times, depth = {root: root}, {root: 0}, {root: 0}
        queue = deque([root])
        closing: tuple[int, int, int] | None = None
        while queue:
            i = queue.popleft()
            if closing is not None and 2 * depth[i] + 1 > closing[0]:
                break
            for j, winding in near[i].items():
                if j not in before:
                    before[j], times[j], depth[j] = i, times[i] + winding, depth[i] + 1
                    queue.append(j)
                elif times[i] + winding != times[j]:
                    length = depth[i] + depth[j] + 1
                    if closing is None or length < closing[0]:
                        closing = length, i, j
        seen |= set(before)
        if closing is not None:
            cycle = _closed(before, closing[1], closing[2])
            if best is None or len(cycle) < len(best):
                best = cycle
    return best


def _closed(before: dict[int, int], i: int, j: int) -> list[int]:
    """Joins an edge with the ways from both ends back to their meeting point: a cycle."""

    def back(k: int) -> list[int]:
        way = [k]
        while before[way[-1]] != way[-1]:
            way.append(before[way[-1]])
        return way

    first, second = back(i), back(j)
    while len(first) > 1 and len(second) > 1 and first[-2] == second[-2]:
        first.pop()
        second.pop()
    return first + second[-2::-1]
