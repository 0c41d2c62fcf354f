"""Hits: places on a path, with points common to part and obstacles that move linearly with the
scale (docs/certificates-paths.md)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import inf
from typing import Any

from minkref.certify.motion.convex_cells import Place, below, middle
from minkref.certify.motion.moving_parts import Corner, Pair, Way, cut, levels
from minkref.certify.motion.scale_cells import Cut, cuts
from minkref.certify.plane.piece_nodes import Vector
from minkref.motion.scale_ranges import ScaleRange

MOST_HITS = 10_000  # per claim
ENOUGH = 64  # hits that go on at a scale; the longest among so many will do


class NoHit(Exception):
    """At some scale no place of the path collides."""


@dataclass(frozen=True)
class Hit:
    low: Cut
    high: Cut
    value: dict[str, Any]


class Collisions:
    """Finds hits on the segments of a path. `strict`: interiors meet. Exact."""

    def __init__(self, pair: Pair, ways: Sequence[Way], strict: bool) -> None:
        self.pair, self.ways, self.strict = pair, ways, strict

    def hits(self, scales: ScaleRange) -> list[dict[str, Any]]:
        """The hits at all scales of a range, ascending, each as far as it goes. Raises NoHit."""
        reach, end = cuts(scales)
        found: list[dict[str, Any]] = []
        while reach < end:
            best: Hit | None = None
            going = 0
            for hit in self._from(reach, scales):
                if not hit.low <= reach < hit.high:
                    continue
                going += 1
                if best is None or best.high < hit.high:
                    best = hit
                if best.high >= end or going >= ENOUGH:
                    break
            if best is None or len(found) >= MOST_HITS:
                raise NoHit(f"no hit goes on at {reach[0]}")
            found.append(best.value)
            reach = best.high
        return found

    def _from(self, reach: Cut, scales: ScaleRange) -> Iterator[Hit]:
        """Yields hits for all pairs of pieces that at least touch at a scale."""
        here = ScaleRange(reach[0], reach[0], True, True)
        above = ScaleRange(reach[0], scales.high, True, scales.high is not None)
        for number, way in enumerate(self.ways):
            for A, B in self._touching(way, way.cell(here)):
                hit = self._hit(number, way, A, B, way.cell(above))
                if hit is not None:
                    yield hit

    def _touching(self, way: Way, here: list[Corner]) -> Iterator[tuple[int, int]]:
        part, walls = self.pair.R, self.pair.O
        stack = [(part.root, walls.root)] if part.hulls and walls.hulls else []
        while stack:
            A, B = stack.pop()
            if any(min(levels(way.gap(n, A, B), here)) > 0 for n in self._normals(way, A, B)):
                continue
            if part.children[A] and (not walls.children[B] or part.extents[A] >= walls.extents[B]):
                stack += [(child, B) for child in part.children[A]]
            elif walls.children[B]:
                stack += [(A, child) for child in walls.children[B]]
            elif self._polygon(way, A, B, here):
                yield A, B

    def _normals(self, way: Way, A: int, B: int) -> list[Vector]:
        return [*way.across, *self.pair.directions(A, B)]

    def _polygon(self, way: Way, A: int, B: int, corners: list[Corner]) -> list[Corner]:
        """Returns the part of a cell where two pieces have a common point."""
        for normal in self.pair.directions(A, B):
            corners = cut(corners, way.gap(normal, A, B)) if corners else []
        return corners

    def _hit(self, number: int, way: Way, A: int, B: int, corners: list[Corner]) -> Hit | None:
        """From the least scale of a cell on."""
        polygon = self._polygon(way, A, B, corners)
        if not polygon:
            return None
        finite = [(Fraction(t, w), Fraction(s, w)) for t, s, w in polygon if w]
        low, high = (pick(s for _, s in finite) for pick in (min, max))
        endless = len(finite) < len(polygon)
        if way.across == []:  # one place
            finite = [(Fraction(0), s) for _, s in finite]
        ends = [middle([one for one in finite if one[1] == s]) for s in (low, high)]
        inside = middle(finite)
        if endless:
            inside = (inside[0], high + 1)
            ends = ends[:1]
        nodes = [*ends[:1], inside, *ends[1:]]
        if low == high and not endless:
            nodes = [inside]
        points = [self._point(way, A, B, t, s) for t, s in nodes]
        strict = [self._is_strict(way, A, B, t, s) for t, s in nodes]
        if self.strict and not any(strict):
            return None
        if not self.strict and len(nodes) == 3:
            nodes, points = [nodes[0], nodes[2]], [points[0], points[2]]
        if not self.strict:
            strict = [True for _ in nodes]
        entries: list[Any] = [
            [str(t), str(s), [str(x), str(y)]] for (t, s), (x, y) in zip(nodes, points, strict=True)
        ]
        value = {"segment": number, "nodes": [A, B], "points": entries + ["up"] * endless}
        first = (nodes[0][1], not (strict[0] and nodes[0][1] > 0))
        last: Cut = (inf, False) if endless else (nodes[-1][1], strict[-1])
        return Hit(first, last, value)

    def _is_strict(self, way: Way, A: int, B: int, t: Fraction, s: Fraction) -> bool:
        corner = [_corner(t, s)]
        return all(levels(way.gap(n, A, B), corner)[0] < 0 for n in self.pair.directions(A, B))

    def _point(self, way: Way, A: int, B: int, t: Fraction, s: Fraction) -> Place:
        """Returns a middle point of the intersection of x + sA and B, which is not empty."""
        pair = self.pair
        (x, y), unit = way.at(t), pair.unit
        ring = [(x + s * u / unit, y + s * v / unit) for u, v in pair.R.hulls[A]]
        ring = list(dict.fromkeys(ring))
        for n in pair.O.sides[B]:
            ring = below(ring, n, Fraction(pair.O.most(B, n), unit))
        return middle(ring)


def _corner(t: Fraction, s: Fraction) -> Corner:
    w = t.denominator * s.denominator
    return int(t * w), int(s * w), w
