"""Faults in reading, rounding and comparing numbers."""

from __future__ import annotations

import math
from fractions import Fraction

from plain_geometry import Point
from plain_sum import Exact, PlainSum
from plain_union import Cycle, Node, Ratio, Stretch, node, node_turn


class ReadsNumbersAsDoubles(PlainSum):
    """Coordinates go through a double when they are read."""

    def number(self, text: str) -> Fraction:
        return Fraction(float(Fraction(text)))


class LosesTheSignAboveMinusOne(PlainSum):
    """The sign is taken from the whole part, which is 0 between -1 and 0."""

    def number(self, text: str) -> Fraction:
        value = Fraction(text)
        whole = int(value)
        rest = abs(value - whole)
        return whole - rest if whole < 0 else whole + rest


class RoundsIntersectionsToDoubles(PlainSum):
    """Intersections of edges are rounded to doubles."""

    def place(self, a: Point, b: Point, at: Ratio) -> Node:
        x, y, w = super().place(a, b, at)
        if w == 1:
            return (x, y, w)
        fx, fy = Fraction(x / w), Fraction(y / w)
        common = math.lcm(fx.denominator, fy.denominator)
        return node(int(fx * common), int(fy * common), common)


class WritesTwelveDecimals(PlainSum):
    """Results are written with twelve digits after the point."""

    def text(self, numerator: int, denominator: int) -> str:
        return str(Fraction(round(Fraction(numerator * 10**12, denominator)), 10**12))


class WritesWholeNumbers(PlainSum):
    """Vertices of the result are rounded to whole numbers."""

    def text(self, numerator: int, denominator: int) -> str:
        return str(round(Fraction(numerator, denominator)))


class MergesNearbyNodes(PlainSum):
    """Vertices of the union that are less than 1e-6 apart, or nearly, become one."""

    _unit = 1

    def unit(self, P: list[list[list[Exact]]], Q: list[list[list[Exact]]]) -> int:
        self._unit = super().unit(P, Q)
        return self._unit

    def boundary(self, pieces: list[list[Point]]) -> list[Stretch]:
        kept: dict[tuple[int, int], Node] = {}

        def merged(p: Node) -> Node:
            cell = p[2] * self._unit
            return kept.setdefault((p[0] * 10**6 // cell, p[1] * 10**6 // cell), p)

        moved = [(merged(a), merged(b)) for a, b in super().boundary(pieces)]
        return [(a, b) for a, b in moved if a != b]


class StraightensNearlyStraight(PlainSum):
    """Vertices of the result that turn by less than a millionth are taken for straight."""

    def straightened(self, cycle: Cycle) -> Cycle:
        n = len(cycle)
        kept = [
            p for k, p in enumerate(cycle) if self.bends(cycle[k - 1], p, cycle[(k + 1) % n]) > 1e-6
        ]
        return kept if len(kept) > 2 else cycle

    def bends(self, a: Node, b: Node, c: Node) -> float:
        (ax, ay), (bx, by), (cx, cy) = ((p[0] / p[2], p[1] / p[2]) for p in (a, b, c))
        size = math.hypot(bx - ax, by - ay) * math.hypot(cx - bx, cy - by)
        return abs(node_turn(a, b, c) / (a[2] ** 2 * b[2] * c[2])) / size if size else 0.0


class MultipliesIn32Bits(PlainSum):
    """Directions are compared by products that wrap around at 32 bits."""

    bits = 32

    def compare(self, a: Point, b: Point, c: Point, d: Point) -> int:
        half = 1 << (self.bits - 1)
        return (super().compare(a, b, c, d) + half) % (2 * half) - half


class MultipliesIn64Bits(MultipliesIn32Bits):
    """Directions are compared by products that wrap around at 64 bits."""

    bits = 64


class ComparesProductsOfDoubles(PlainSum):
    """Directions are compared by products of doubles."""

    def compare(self, a: Point, b: Point, c: Point, d: Point) -> int:
        left = float(b[0] - a[0]) * float(d[1] - c[1])
        right = float(b[1] - a[1]) * float(d[0] - c[0])
        return (left > right) - (left < right)


class SortsByAngle(PlainSum):
    """Directions are compared by atan2."""

    def compare(self, a: Point, b: Point, c: Point, d: Point) -> int:
        one = math.atan2(b[1] - a[1], b[0] - a[0]) % math.tau
        other = math.atan2(d[1] - c[1], d[0] - c[0]) % math.tau
        return (one < other) - (one > other)


class MovesBackByADouble(PlainSum):
    """The sum is computed near the origin and moved back by a translation in doubles."""

    _moved = (Fraction(0), Fraction(0))

    def total(
        self, P: list[list[list[Exact]]], Q: list[list[list[Exact]]]
    ) -> dict[str, object] | None:
        if not P or not Q:
            return super().total(P, Q)
        (px, py), (qx, qy) = P[0][0][0], Q[0][0][0]
        self._moved = (
            Fraction(float(px) + float(qx)) - px - qx,
            Fraction(float(py) + float(qy)) - py - qy,
        )
        return super().total(P, Q)

    def ring_text(self, cycle: Cycle, unit: int) -> list[list[str]]:
        dx, dy = self._moved
        return [
            [str(Fraction(x, w * unit) + dx), str(Fraction(y, w * unit) + dy)] for x, y, w in cycle
        ]
