"""Curves that may bound the sum of a set with a disc, in decimals: which parts edges block."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from typing import Any

from minkref.certify.disc.joint_places import (
    Exact,
    JointPlace,
    Near,
    circles_meet,
    decimal,
    line_meets_circle,
    lines_meet,
    near,
    rational,
)
from minkref.certify.disc.near_edge import Edge, NearEdge, cross, dot, minus, way_of
from minkref.certify.simplest import simplest_between

BEYOND = Decimal(5)  # all directions


@dataclass(frozen=True)
class Spot:
    """A place on the curve at the radius from an edge, and its position along the curve."""

    position: Decimal
    exact: JointPlace
    at: Near


@dataclass(frozen=True)
class Interval:
    """Positions blocked by an edge; `facing`: right between two edges."""

    low: Decimal
    high: Decimal
    edge: int
    facing: bool = False

    def holds(self, position: Decimal, slack: Decimal) -> bool:
        return self.low + slack < position < self.high - slack


@dataclass
class OffsetCurve:
    """Edge `n` moved to its right, or the arc about the vertex where it begins. Positions nearer
    to each other than `same` times the size are one."""

    n: int
    own: NearEdge
    square: Fraction
    same: Decimal
    before: NearEdge | None = None  # of an arc, the edge that ends where it is
    intervals: list[Interval] = field(default_factory=list)
    spots: list[Spot] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.radius = decimal(self.square).sqrt()
        self.edge, self.v = self.own.exact, self.own.a
        self.length, self.is_covered = self.own.length, False
        self.along = self.own.u[0] / self.length, self.own.u[1] / self.length
        self.normal = self.along[1], -self.along[0]
        if self.before is None:
            self.slack = self.same * (self.length + self.radius)
            self.ends = Decimal(0), self.length
            self.over = self.normal
            return
        w, long = self.before.u, self.before.length
        first = w[1] / long, -w[0] / long
        self.over = first[0] + self.normal[0], first[1] + self.normal[1]
        if dot(self.over, self.over) < Decimal("1e-8"):  # almost half a turn
            self.over = -first[1], first[0]
        size = Fraction(max(map(abs, self.over)))
        x, y = ((Fraction(c) / size).limit_denominator(1 << 20) for c in self.over)
        self.middle, self._middle = (x, y), near((x, y))
        self.slack = self.same
        self.ends = self.position_of(first), self.position_of(self.normal)

    @property
    def is_arc(self) -> bool:
        return self.before is not None

    def position_of(self, way: Near) -> Decimal:
        """Grows with the angle from the arc's middle, from -4 to 4: the tangent up to 45 degrees,
        then 2 less the cotangent, up to 135 degrees."""
        x, y = dot(self._middle, way), cross(self._middle, way)
        if abs(y) <= x:
            return y / x
        found = 2 - x / abs(y) if abs(y) >= -x else 4 + abs(y) / x
        return found if y >= 0 else -found

    def position(self, at: Near) -> Decimal:
        way = minus(at, self.v)
        return self.position_of(way) if self.is_arc else dot(self.along, way)

    def point(self, position: Decimal) -> Near:
        if not self.is_arc:
            way, out = self.along, self.normal
            return (self.v[0] + position * way[0] + self.radius * out[0],
                    self.v[1] + position * way[1] + self.radius * out[1])  # fmt: skip
        x, y = self.direction(position)
        long = (x * x + y * y).sqrt()
        return self.v[0] + self.radius * x / long, self.v[1] + self.radius * y / long

    def direction(self, position: Decimal) -> Near:
        x, y = self._middle
        along, across = _turned(position)
        return along * x - across * y, along * y + across * x

    def tangent(self, at: Near) -> Near:
        """The direction of the curve, P on its left."""
        way = minus(at, self.v)
        return (-way[1], way[0]) if self.is_arc else self.along

    def station(self, low: Decimal, high: Decimal) -> object:
        """A rational place strictly between two positions, as a certificate writes it."""
        third = (high - low) / 3
        if not self.is_arc:
            bounds = [Fraction((low + third) / self.length), Fraction((high - third) / self.length)]
            return str(simplest_between(*bounds))
        low, high = low + third, high - third
        if low <= 0 <= high:
            part = Fraction(0)
        elif high < 0:
            part = -simplest_between(Fraction(-high), Fraction(-low))
        else:
            part = simplest_between(Fraction(low), Fraction(high))
        x, y = self.middle
        along, across = _turned(part)
        return [str(along * x - across * y), str(along * y + across * x)]

    def height(self, edge: NearEdge) -> Decimal:
        """How far the edge reaches in the curve's direction, from anywhere."""
        return max(dot(self.over, edge.a), dot(self.over, edge.b))

    def look_at(self, f: int, edge: NearEdge, tips: tuple[Exact, ...]) -> bool:
        """Adds the part that an edge blocks, or the places that it touches. Returns whether it
        blocks some of the curve, or faces the edge. `tips`: vertices at the ends."""
        if self.is_arc and self.edge[0] in edge.exact:
            return True
        heights = [dot(self.normal, minus(p, self.v)) for p in (edge.a, edge.b)]
        if not self.is_arc and max(map(abs, heights)) <= self.slack:
            return False  # on the edge's own line
        spots = list(self._candidates(edge))
        if not spots:
            return False
        low, high = (end(spots, key=lambda one: one.position) for end in (min, max))
        if high.position - low.position <= self.slack:
            at_tip = any(p in edge.exact for p in tips) and any(
                abs(low.position - end) <= self.slack for end in self.ends
            )
            if not at_tip:
                self.spots.append(low)
            return False
        made = list(self._parts(f, edge, low, high))
        first, last = self.ends[0] - 2 * self.slack, self.ends[1] + 2 * self.slack
        self.intervals += made
        if any(one.low < first and last < one.high for one in made if not one.facing):
            self.is_covered = True
            self.spots.clear()
            return True
        self.spots += [low, high]
        if made[0].facing:
            self.spots += self._facing_ends(made[0], edge.exact)
        first, last = self.ends
        return any(one.low < last - self.slack and first + self.slack < one.high for one in made)

    def _parts(self, f: int, edge: NearEdge, low: Spot, high: Spot) -> Iterator[Interval]:
        if self.is_arc:
            inner = self.position_of(minus(edge.nearest(self.v), self.v))
            if low.position < inner < high.position:
                yield Interval(low.position, high.position, f)
            else:
                yield Interval(-BEYOND, low.position, f)
                yield Interval(high.position, BEYOND, f)
            return
        yield Interval(low.position, high.position, f, self._faces(edge.exact))

    def _faces(self, edge: Edge) -> bool:
        """Whether an edge is parallel, at the height of the diameter."""
        (ax, ay), u, w = self.edge[0], way_of(self.edge), way_of(edge)
        height = (edge[0][0] - ax) * u[1] - (edge[0][1] - ay) * u[0]
        level = u[0] * w[1] == u[1] * w[0]
        return level and height**2 == 4 * self.square * (u[0] ** 2 + u[1] ** 2)

    def _facing_ends(self, part: Interval, edge: Edge) -> Iterator[Spot]:
        """The curve's own ends that are right between two edges: their places are rational."""
        u, (x, y) = way_of(self.edge), self.edge[0]
        height = (edge[0][0] - x) * u[1] - (edge[0][1] - y) * u[0]
        part_of = height / (2 * (u[0] ** 2 + u[1] ** 2))
        for position, tip in zip(self.ends, self.edge, strict=True):
            if part.holds(position, self.slack):
                exact = rational((tip[0] + part_of * u[1], tip[1] - part_of * u[0]))
                yield Spot(position, exact, exact.near())

    def _candidates(self, edge: NearEdge) -> Iterator[Spot]:
        """Places on the whole line or circle as far from an edge as the radius."""
        slack = self.slack * edge.length
        tips = (edge.exact[0], edge.a, 1), (edge.exact[1], edge.b, -1)
        for tip, p, way in tips:
            for exact in self._near_point(tip):
                at = exact.near()
                if way * dot(minus(at, p), edge.u) <= slack:
                    yield Spot(self.position(at), exact, at)
        for exact in self._near_line(edge.exact):
            at = exact.near()
            over = dot(minus(at, edge.a), edge.u)
            if -slack <= over <= edge.length**2 + slack:
                yield Spot(self.position(at), exact, at)

    def _near_point(self, p: Exact) -> Iterator[JointPlace]:
        if self.is_arc:
            return circles_meet(self.edge[0], p, self.square)
        return line_meets_circle(self.edge[0], way_of(self.edge), p, self.square)

    def _near_line(self, edge: Edge) -> Iterator[JointPlace]:
        u = way_of(edge)
        if self.is_arc:
            return line_meets_circle(edge[0], u, self.edge[0], self.square, (1, -1))
        return lines_meet(self.edge[0], way_of(self.edge), edge[0], u, self.square)


def _turned(position: Any) -> tuple[Any, Any]:
    """A direction at a position between two right angles, seen from the arc's middle."""
    if abs(position) <= 1:
        return 1, position
    return 2 - abs(position), 1 if position > 0 else -1
