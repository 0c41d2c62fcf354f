"""The sum of two polygon sets by the plainest exact way: convex pieces, their sums, the union."""

from __future__ import annotations

from fractions import Fraction
from math import lcm
from typing import Any

from plain_geometry import Point, Ring, area, is_around, without_straight_corners
from plain_pieces import Pieces
from plain_union import Cycle, Union, box_of, cycle_area

Set = dict[str, Any]
Exact = tuple[Fraction, Fraction]
Polygon = list[Ring]  # the outer ring, then holes


class PlainSum(Pieces, Union):
    """Sums sP and Q, given as canonical JSON; each stage is a method, which a fault replaces."""

    def __call__(self, P: Set, Q: Set) -> Set | None:
        return self.total(self.read(P), self.read(Q))

    def total(self, P: list[list[list[Exact]]], Q: list[list[list[Exact]]]) -> Set | None:
        unit = self.unit(P, Q)
        first, second = self.on_grid(P, unit), self.on_grid(Q, unit)
        if all(self.is_flat(polygon) for polygon in first) and second:
            if all(self.is_flat(polygon) for polygon in second) and first:
                return None  # no region
        first, second = self.filled(first, second), self.filled(second, first)
        cycles = self.cycles(self.boundary(self.piece_sums(first, second)))
        return self.written(self.nested([self.straightened(cycle) for cycle in cycles]), unit)

    def read(self, operand: Set) -> list[list[list[Exact]]]:
        return [
            [
                [(self.number(x), self.number(y)) for x, y in ring]
                for ring in (polygon["outer"], *polygon.get("holes", []))
            ]
            for polygon in operand["polygons"]
        ]

    def number(self, text: str) -> Fraction:
        return Fraction(text)

    def unit(self, P: list[list[list[Exact]]], Q: list[list[list[Exact]]]) -> int:
        """A common denominator of all coordinates."""
        return lcm(
            *(
                number.denominator
                for operand in (P, Q)
                for polygon in operand
                for ring in polygon
                for point in ring
                for number in point
            )
        )

    def on_grid(self, operand: list[list[list[Exact]]], unit: int) -> list[Polygon]:
        return [
            [[(int(x * unit), int(y * unit)) for x, y in ring] for ring in polygon]
            for polygon in operand
        ]

    def is_flat(self, polygon: Polygon) -> bool:
        return len(polygon[0]) < 3

    def filled(self, operand: list[Polygon], other: list[Polygon]) -> list[Polygon]:
        """Removes the holes that have no room for any polygon of the other operand."""
        sizes = [self.size(polygon[0]) for polygon in other]
        return [
            [polygon[0], *(hole for hole in polygon[1:] if self.has_room(hole, sizes))]
            for polygon in operand
        ]

    def size(self, ring: Ring) -> tuple[int, int]:
        x0, y0, x1, y1 = box_of(ring)
        return (x1 - x0, y1 - y0)

    def has_room(self, hole: Ring, sizes: list[tuple[int, int]]) -> bool:
        width, height = self.size(hole)
        return any(width > other[0] and height > other[1] for other in sizes)

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        first = [piece for polygon in P for piece in self.pieces(polygon)]
        second = [piece for polygon in Q for piece in self.pieces(polygon)]
        return self.regions([self.convex_sum(a, b) for a in first for b in second])

    def regions(self, sums: list[Ring]) -> list[Ring]:
        """Each region once, without regions of zero area, large regions first."""
        once = {tuple(ring): None for ring in map(without_straight_corners, sums) if len(ring) > 2}
        return sorted(map(list, once), key=area, reverse=True)

    def convex_sum(self, A: Ring, B: Ring) -> Ring:
        """Merges the edges of both by direction, starting at the lowest vertices."""
        a, b = self.from_lowest(A), self.from_lowest(B)
        m, n = len(A), len(B)
        if m == 1 or n == 1:
            return [(p[0] + q[0], p[1] + q[1]) for p in a for q in b]
        found: Ring = []
        i = j = 0
        while i < m or j < n:
            found.append((a[i % m][0] + b[j % n][0], a[i % m][1] + b[j % n][1]))
            step = self.compare(a[i % m], a[(i + 1) % m], b[j % n], b[(j + 1) % n])
            if j == n or (i < m and step >= 0):
                i += 1
                j += j < n and step == 0
            else:
                j += 1
        return found

    def from_lowest(self, ring: Ring) -> Ring:
        at = min(range(len(ring)), key=lambda k: (ring[k][1], ring[k][0]))
        return ring[at:] + ring[:at]

    def compare(self, a: Point, b: Point, c: Point, d: Point) -> int:
        """Positive if direction a b comes before c d, zero if they are equal."""
        return (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0])

    def nested(self, cycles: list[Cycle]) -> list[list[Cycle]]:
        """Polygons: each outer ring with its holes."""
        areas = [(cycle_area(cycle), cycle) for cycle in cycles]
        outers = sorted((pair for pair in areas if pair[0] > 0), key=lambda pair: pair[0])
        polygons = [[cycle] for _, cycle in outers]
        for size, hole in areas:
            if size < 0:
                self.put_hole(polygons, hole)
        return polygons

    def put_hole(self, polygons: list[list[Cycle]], hole: Cycle) -> None:
        """Puts a hole into the first polygon around it, the smallest."""
        for polygon in polygons:
            if self.is_around(polygon[0], hole):
                polygon.append(hole)
                return
        raise ValueError("a hole in nothing")

    def is_around(self, outer: Cycle, hole: Cycle) -> bool:
        rings = [[(Fraction(x, w), Fraction(y, w)) for x, y, w in ring] for ring in (outer, hole)]
        return is_around(*rings)

    def written(self, polygons: list[list[Cycle]], unit: int) -> Set:
        return {
            "polygons": [
                {
                    "outer": self.ring_text(polygon[0], unit),
                    "holes": [self.ring_text(hole, unit) for hole in polygon[1:]],
                }
                for polygon in polygons
            ]
        }

    def ring_text(self, cycle: Cycle, unit: int) -> list[list[str]]:
        return [[self.text(x, w * unit), self.text(y, w * unit)] for x, y, w in cycle]

    def text(self, numerator: int, denominator: int) -> str:
        return str(Fraction(numerator, denominator))
