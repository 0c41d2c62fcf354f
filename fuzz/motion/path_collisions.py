"""Decides by definition whether a part collides along a path at one scale: all edges of one set at
all vertices of the other cut the path, and each cut and each middle between two cuts is decided as
a point, by the slow engine or by pairs of triangles. Knows no event and no index."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

from minkref import _core
from minkref.fuzz.geometry.plane import Point, fraction_rings
from minkref.oracle import slow
from minkref.oracle.slow.witness import Pieces

#: How sP and x - Q meet: empty, touching or overlapping.
Decide = Callable[[Fraction, Point], str]
SLOW_WORDS = {"disjoint": "empty", "touching": "touching", "overlapping": "overlapping"}


def by_triangles(part: _core.PolygonSet, obstacles: _core.PolygonSet) -> Decide:
    turned = part.scaled("-1")
    return lambda scale, x: str(
        _core.decide(turned, obstacles, str(scale), str(x[0]), str(x[1]))["contact"]
    )


def by_slow_engine(part: _core.PolygonSet, obstacles: _core.PolygonSet) -> Decide:
    P, Q = (
        Pieces.of(slow.operand_from_json(json.loads(operand.to_json())))
        for operand in (part.scaled("-1"), obstacles)
    )
    return lambda scale, x: SLOW_WORDS[
        slow.witness(P, Q, scale, (Fraction(x[0]), Fraction(x[1]))).contact
    ]


@dataclass(frozen=True)
class Located:
    """A place of a path: on the segment from one vertex to the next, how far along, the point."""

    segment: int
    t: Fraction
    point: Point


class Collisions:
    """Collisions of a part with a set of obstacles along a path."""

    def __init__(
        self, part: _core.PolygonSet, obstacles: _core.PolygonSet, path: Sequence[Point]
    ) -> None:
        self._part = fraction_rings(part.to_json())
        self._obstacles = fraction_rings(obstacles.to_json())
        self._path = list(path)

    def collides(self, scale: Fraction, contact: str, decide: Decide) -> bool:
        """With contact allowed, whether interiors meet at some place; else whether sets do."""
        bad = ("overlapping",) if contact == "allowed" else ("overlapping", "touching")
        return any(decide(scale, place.point) in bad for place in self.located(scale))

    def located(self, scale: Fraction) -> Iterator[Located]:
        """Yields places that decide for the whole path. Vertices first: most collisions show
        there."""
        last = len(self._path) - 1
        for k, point in enumerate(self._path):
            yield (
                Located(k, Fraction(0), point)
                if k < max(last, 1)
                else Located(k - 1, Fraction(1), point)
            )
        edges = list(self._edges(scale))
        for segment, (a, b) in enumerate(pairwise(self._path)):
            if a == b:
                continue
            cuts = sorted({Fraction(0), Fraction(1), *_cuts(a, b, edges)})
            middles = [(s + t) / 2 for s, t in pairwise(cuts)]
            for t in (*middles, *cuts):
                yield Located(segment, t, (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))

    def _edges(self, scale: Fraction) -> Iterator[tuple[Point, Point]]:
        """Yields each edge of one set at each vertex of the other, as a segment of part places."""
        for edges, vertices, own, other in (
            (self._obstacles, self._part, Fraction(1), -scale),
            (self._part, self._obstacles, -scale, Fraction(1)),
        ):
            corners = [v for ring in vertices for v in ring]
            for ring in edges:
                for k, (ax, ay) in enumerate(ring):
                    bx, by = ring[(k + 1) % len(ring)]
                    for vx, vy in corners:
                        dx, dy = other * vx, other * vy
                        yield (own * ax + dx, own * ay + dy), (own * bx + dx, own * by + dy)


def _cuts(a: Point, b: Point, edges: Sequence[tuple[Point, Point]]) -> Iterator[Fraction]:
    """Yields parameters at which edges meet the segment from a to b."""
    wx, wy = b[0] - a[0], b[1] - a[1]
    length = wx * wx + wy * wy
    for (px, py), (qx, qy) in edges:
        p = wx * (py - a[1]) - wy * (px - a[0])
        q = wx * (qy - a[1]) - wy * (qx - a[0])
        if p * q > 0:
            continue
        if p == q:  # both 0: on the line
            ends = [(px, py), (qx, qy)]
        else:
            t = Fraction(p) / (p - q)
            ends = [(px + t * (qx - px), py + t * (qy - py))]
        for x, y in ends:
            part = ((x - a[0]) * wx + (y - a[1]) * wy) / Fraction(length)
            if 0 < part < 1:
                yield part
