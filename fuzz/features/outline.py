"""A polygon set's boundary for judges of its outer Voronoi diagram, with features named as
docs/disc.md names curves."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any, Self

Point = tuple[Fraction, Fraction]
# ("vertex", x, y), or ("line", dx, dy, c): the points with dy x - dx y = c, (dx, dy) primitive.
Feature = tuple[Any, ...]
Rings = Sequence[Sequence[tuple[Any, Any]]]


@dataclass(frozen=True, eq=False)
class Piece:
    """An edge, or the part of an edge between points where other rings touch it."""

    start: Point
    end: Point
    line: Feature

    @property
    def along(self) -> Point:
        return self.end[0] - self.start[0], self.end[1] - self.start[1]

    @cached_property
    def rounded(self) -> tuple[float, float, float, float]:
        """Returns start and direction in doubles."""
        (x, y), (dx, dy) = map(float, self.start), map(float, self.along)
        return x, y, dx, dy

    def rounded_distance(self, x: float, y: float) -> float:
        ax, ay, dx, dy = self.rounded
        t = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)
        t = min(max(t, 0.0), 1.0)
        return math.hypot(x - ax - t * dx, y - ay - t * dy)


class Outline:
    """A polygon set's boundary, with the set on the left of its edges, moved so that `origin`, the
    box's lower left corner, comes to (0, 0). Exact."""

    def __init__(self, rings: Rings) -> None:
        given = [[(Fraction(x), Fraction(y)) for x, y in ring] for ring in rings]
        x, y = (min(corner[k] for ring in given for corner in ring) for k in (0, 1))
        self.origin = x, y
        self.rings = [[(a - x, b - y) for a, b in ring] for ring in given]
        corners = [corner for ring in self.rings for corner in ring]
        self.size = float(max(max(corner) for corner in corners))
        self.factor = math.lcm(*(c.denominator for corner in corners for c in corner))
        self.pieces = list(self._pieces())

    @classmethod
    def of(cls, P: Any) -> Self:
        """Returns the outline of a set from the extension module."""
        return cls([ring for polygon in P.rings() for ring in polygon])

    def _pieces(self) -> Iterator[Piece]:
        corners = sorted({corner for ring in self.rings for corner in ring})
        for ring in self.rings:
            for start, end in zip(ring, [*ring[1:], ring[0]], strict=True):
                line = line_through(start, end)
                stops = [start, *_between(corners, start, end), end]
                for a, b in pairwise(stops):
                    yield Piece(a, b, line)

    def vertex(self, x: str, y: str) -> Feature:
        """Names a vertex by its coordinates before the move."""
        return ("vertex", Fraction(x) - self.origin[0], Fraction(y) - self.origin[1])

    def spot(self, x: float, y: float) -> tuple[float, float]:
        """A place, moved as the set is."""
        return float(Fraction(x) - self.origin[0]), float(Fraction(y) - self.origin[1])

    def edge(self, ring: int, index: int) -> Feature:
        """Names an edge's line, by the numbers of the ring and of the edge's first vertex."""
        corners = self.rings[ring]
        return line_through(corners[index], corners[(index + 1) % len(corners)])

    @cached_property
    def straight(self) -> dict[Feature, list[Feature]]:
        """Lines that go on straight at a vertex."""
        arriving: dict[Point, set[Feature]] = {}
        for piece in self.pieces:
            arriving.setdefault(piece.end, set()).add(piece.line)
        found: dict[Feature, list[Feature]] = {}
        for piece in self.pieces:
            if piece.line in arriving.get(piece.start, set()):
                found.setdefault(("vertex", *piece.start), []).append(piece.line)
        return found

    def integers(self) -> list[list[int]]:
        """Returns the pieces, multiplied by `factor`."""
        return [[int(c * self.factor) for c in (*piece.start, *piece.end)] for piece in self.pieces]

    def is_outside(self, x: float, y: float) -> bool:
        """Tests with the edges to the right. In doubles: for places off the boundary."""
        inside = False
        for ax, ay, bx, by in self._bands.get(math.floor(y / self._band), ()):
            if (ay > y) != (by > y) and ax + (y - ay) / (by - ay) * (bx - ax) > x:
                inside = not inside
        return not inside

    @cached_property
    def _band(self) -> float:
        return (self.size or 1.0) / max(1, len(self.pieces) // 4)

    @cached_property
    def _bands(self) -> dict[int, list[tuple[float, float, float, float]]]:
        found: dict[int, list[tuple[float, float, float, float]]] = {}
        for piece in self.pieces:
            (ax, ay), (bx, by) = map(float, piece.start), map(float, piece.end)
            low, high = sorted((ay, by))
            for band in range(math.floor(low / self._band), math.floor(high / self._band) + 1):
                found.setdefault(band, []).append((ax, ay, bx, by))
        return found


def line_through(start: Point, end: Point) -> Feature:
    dx, dy = end[0] - start[0], end[1] - start[1]
    common = math.lcm(dx.denominator, dy.denominator)
    x, y = int(dx * common), int(dy * common)
    divisor = math.gcd(x, y)
    x, y = x // divisor, y // divisor
    return ("line", x, y, y * start[0] - x * start[1])


def _between(corners: list[Point], start: Point, end: Point) -> list[Point]:
    """Returns the corners on the open segment from start to end, in order."""
    along = end[0] - start[0], end[1] - start[1]
    square = along[0] ** 2 + along[1] ** 2
    low, high = min(start[0], end[0]), max(start[0], end[0])
    bottom, top = min(start[1], end[1]), max(start[1], end[1])
    found = []
    for x, y in corners[bisect_left(corners, low, key=lambda corner: corner[0]) :]:
        if x > high:
            break
        if not bottom <= y <= top:
            continue
        way = x - start[0], y - start[1]
        far = along[0] * way[0] + along[1] * way[1]
        if along[0] * way[1] == along[1] * way[0] and 0 < far < square:
            found.append((far, (x, y)))
    return [corner for _, corner in sorted(found)]


def height(spot: tuple[float, float], line: Feature) -> float:
    """Over a line, the set being below. In doubles."""
    _, dx, dy, c = line
    return float(dy * spot[0] - dx * spot[1] - float(c)) / math.hypot(dx, dy)


def distance(spot: tuple[float, float], feature: Feature) -> float:
    """From a vertex or a line. In doubles."""
    if feature[0] == "line":
        return abs(height(spot, feature))
    return math.hypot(spot[0] - float(feature[1]), spot[1] - float(feature[2]))
