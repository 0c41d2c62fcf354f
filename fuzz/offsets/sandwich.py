"""Whether a polygon set lies between a set grown by two discs: decided exactly.

Let d be the distance from P, low < high two radii, and R' a region. P grown by `high` holds R' iff
no point of R' has d > high. Such points form open sets, each of which meets the boundary of R', or
is a whole hole of the grown set inside R'. The interior of P grown by `low` lies in R' iff no point
outside R' has d < low. Connected parts of {d < low} hold a polygon of P each; so each of them meets
the boundary of R', or leaves R' with a whole polygon of P. So edges of R', a point for each hole,
and a point for each polygon of P decide.

Erosion is the same, turned inside out: d is the distance from the outside of P, R' is what the
result leaves out, and both have the edges that P and the result have.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import chain
from math import inf

from minkref.fuzz.geometry.plane import Point, Shape, contains, crossing, minus, segments_meet, turn
from minkref.fuzz.offsets.cover import uncovered
from minkref.fuzz.offsets.distance import (
    ROUNDED,
    Distances,
    Exact,
    ExactEdge,
    Spot,
    exact,
    exact_edges,
    from_edge,
    nearest_places,
    spot_distance,
)

STEPS = 64  # how often a step beside an edge is halved
Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class Breach:
    """A point outside the result with d < low (`missing`), or of it with d > high. `whole`: a
    polygon of P is missing, or a hole of the grown set is filled."""

    point: Exact
    missing: bool
    square: Fraction
    edge: ExactEdge | None = None  # of the result, on which a missing point lies
    whole: bool = False


@dataclass
class Sandwich:
    """`low`, above zero, and `high`: the radii. `turned`: what the result leaves out is meant."""

    near: Distances
    low: Fraction
    high: Fraction
    result: Shape
    turned: bool = False

    def _has(self, point: Point) -> bool:
        """Whether R' has a point; either answer serves on its boundary."""
        return contains(self.result, point) != self.turned

    def breaches(self, holes: Iterable[Exact]) -> list[Breach]:
        """A point too much and a missing point, if any; exact, and about the worst. `holes`: a
        point of each hole of the set grown by `high`. O(m n) in doubles for m edges of the result
        and n of the set, and as many exact tests as doubles leave open."""
        missing = next(chain(self._lost(), self._inside()), None)
        extra = self.too_far(holes)
        return ([extra] if extra else []) + ([self._short(missing)] if missing else [])

    def too_far(self, holes: Iterable[Exact]) -> Breach | None:
        """A point too much, if any; `low` does not matter."""
        extra = next(chain(self._filled(holes), self._outside()), None)
        return None if extra is None else self._short(extra)

    def __post_init__(self) -> None:
        own = exact_edges(self.result)
        spots = [(self.near.spot(a), self.near.spot(b)) for a, b in own]
        walls = self.near.walls
        size = max((abs(x) for pair in spots for p in pair for x in p), default=0.0)
        self._margin = ROUNDED * (size + self.near.size + float(self.high))
        self._reach = float(self.high) + self._margin
        self._beside = [
            (edge, spot, list(self._candidates(spot, walls)))
            for edge, spot in zip(own, spots, strict=True)
        ]

    def _candidates(
        self, own: tuple[Spot, Spot], walls: Sequence[tuple[Spot, Spot]]
    ) -> Iterator[tuple[ExactEdge, tuple[Spot, Spot]]]:
        """Yields edges of P with boxes within reach."""
        left, low, right, up = _box(own)
        left, low, right, up = (
            left - self._reach, low - self._reach, right + self._reach, up + self._reach,
        )  # fmt: skip
        for edge, wall in zip(self.near.edges, walls, strict=True):
            (ax, ay), (bx, by) = wall
            if (ax if ax > bx else bx) < left or (ax if ax < bx else bx) > right:
                continue
            if (ay if ay > by else by) < low or (ay if ay < by else by) > up:
                continue
            yield edge, wall

    def _outside(self) -> Iterator[Breach]:
        """Points of edges of the result with d > high, about the farthest first."""
        safe = float(self.high) - self._margin
        left = []
        for edge, (p, q), candidates in self._beside:
            ends = [(spot_distance(p, *wall), spot_distance(q, *wall)) for _, wall in candidates]
            if any(a < safe and b < safe for a, b in ends):
                continue  # within reach of one edge: convex
            far = max((min(pair[k] for pair in ends) for k in (0, 1)), default=inf) if ends else inf
            left.append((far, edge, [wall for wall, _ in candidates]))
        for _, (a, b), near in sorted(left, key=lambda one: -one[0]):
            for point in uncovered(a, b, near, self.high):
                square = self.near.of(point).square
                if square > self.high**2:
                    yield Breach(point, False, square)

    def _filled(self, holes: Iterable[Exact]) -> Iterator[Breach]:
        for point in holes:
            if self._has(point):
                yield Breach(point, False, self.near.of(point).square, whole=True)

    def _inside(self) -> Iterator[Breach]:
        """Points beside edges of the result with d < low, the deepest first."""
        safe = float(self.low) + self._margin
        close = []
        for edge, own, candidates in self._beside:
            for wall, spots in candidates:
                rounded = _distance(own, spots, self._margin)
                if rounded <= safe:
                    close.append((rounded, edge, wall))
        for _, (a, b), wall in sorted(close, key=lambda one: one[0]):
            places = nearest_places(a, b, wall)
            if segments_meet(a, b, *wall):
                places += _common(a, b, wall)
            square, place = min((from_edge(x, wall).square, x) for x in places)
            if square < self.low**2:
                yield Breach(place, True, square, (a, b))
        for rings in self.result:
            for ring in rings:  # off the boundary of P, so wholly in P if one vertex is
                if self.near.has(ring[0]):
                    yield Breach(exact(ring[0]), True, Fraction(0), _first(ring))

    def _lost(self) -> Iterator[Breach]:
        for point in self.near.seeds():
            if not self._has(point):
                yield Breach(point, True, Fraction(0), whole=True)

    def _short(self, one: Breach) -> Breach:
        """The same with short numbers; if a missing point lies on an edge of the result, a point
        beside it."""

        def serves(x: Exact) -> bool:
            if self._has(x) == one.missing:
                return False
            square = self.near.of(x).square
            return square < self.low**2 if one.missing else square > self.high**2

        starts = [one.point] if one.edge is None else _beside(one.point, one.edge)
        start = next(filter(serves, starts), None)
        if start is None:
            return one
        point = shortened(start, serves)
        return replace(one, point=point, square=self.near.of(point).square)


def shortened(point: Exact, serves: Callable[[Exact], bool]) -> Exact:
    """A point near by with numbers of fewer digits that serves too; else the point itself."""
    size = max(abs(point[0]), abs(point[1]), Fraction(1, 1 << 20))
    exponent = (size.numerator // size.denominator).bit_length()
    for k in range(2, 60, 2):
        unit = Fraction(2) ** (exponent - k)
        near = (unit * round(point[0] / unit), unit * round(point[1] / unit))
        if serves(near):
            return near
    return point


def _first(ring: Sequence[Point]) -> ExactEdge:
    return (exact(ring[0]), exact(ring[1]))


def _beside(point: Exact, edge: ExactEdge) -> Iterator[Exact]:
    """Points at both sides of an edge, nearer and nearer."""
    u = minus(edge[1], edge[0])
    factor = Fraction(1, 2)
    for _ in range(STEPS):
        for side in (factor, -factor):
            yield (point[0] + side * u[1], point[1] - side * u[0])
        factor /= 2


def _box(pair: tuple[Spot, Spot]) -> Box:
    (ax, ay), (bx, by) = pair
    return min(ax, bx), min(ay, by), max(ax, bx), max(ay, by)


def _distance(first: tuple[Spot, Spot], second: tuple[Spot, Spot], margin: float) -> float:
    """Measures between two segments, rounded; 0 if they may cross."""
    found = min(
        spot_distance(first[0], *second), spot_distance(first[1], *second),
        spot_distance(second[0], *first), spot_distance(second[1], *first),
    )  # fmt: skip
    if _apart(first, second, margin) or _apart(second, first, margin):
        return found
    return 0.0


def _apart(line: tuple[Spot, Spot], other: tuple[Spot, Spot], margin: float) -> bool:
    """Whether a segment lies on one side of another one's line, clearly."""
    (ax, ay), (bx, by) = line
    dx, dy = bx - ax, by - ay
    sides = [dx * (y - ay) - dy * (x - ax) for x, y in other]
    clear = margin * (abs(dx) + abs(dy)) + margin * margin
    return (sides[0] > clear and sides[1] > clear) or (sides[0] < -clear and sides[1] < -clear)


def _common(a: Exact, b: Exact, edge: ExactEdge) -> list[Exact]:
    if turn(a, b, edge[0]) == 0 and turn(a, b, edge[1]) == 0:
        return []  # on one line: ends are among the nearest places
    if edge[0] == edge[1]:
        return [edge[0]]
    return [exact(crossing(a, b, *edge))]
