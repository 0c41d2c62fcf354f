"""Sets and lines grown or eroded by a disc, in doubles, from the page of the protocol alone: the
rings of the set, and rectangles, discs and joins around them. Points with a winding number above
zero are meant, so nothing has to be united; to erode, what is around runs clockwise."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

Point = tuple[float, float]
Ring = list[Point]
How = dict[str, Any]
STRAIGHT = 1e-12  # turns that doubles may take for others: a join leaves no slit there


class PlainOffset:
    """Seeded faults replace methods. `corners`: a circle's."""

    corners = 64
    turn = 0.5  # of a step: where the first corner lies

    def answer(self, P: dict[str, Any], radius: float, how: How) -> dict[str, Any]:
        """Returns the result's members."""
        r = self.radius(radius, P)
        if "lines" in P:
            lines = self.lines([[(x, y) for x, y in line] for line in P["lines"]])
            rings = [ring for line in lines for ring in self.of_line(line, r, how)]
        else:
            rings = self.of_set(self.polygons(rings_of(P), abs(r)), r, how)
        return {"rings": [[list(p) for p in ring] for ring in self.finished(rings, r)]}

    def radius(self, radius: float, P: dict[str, Any]) -> float:
        return radius

    def polygons(self, polygons: list[list[Ring]], r: float) -> list[list[Ring]]:
        return polygons

    def lines(self, lines: list[Ring]) -> list[Ring]:
        return lines

    def finished(self, rings: list[Ring], r: float) -> list[Ring]:
        return [ring for ring in rings if len(ring) > 2]

    def of_set(self, polygons: list[list[Ring]], r: float, how: How) -> list[Ring]:
        own, around = [], []
        for rings in polygons:
            if len(rings[0]) < 3:
                around += self.of_line(rings[0], r, how)
                continue
            own += rings
            for k, ring in enumerate(rings):
                around += self.of_ring(ring, r, how, k > 0)
        return own + ([ring[::-1] for ring in around] if r < 0 else around)

    def of_ring(self, ring: Ring, r: float, how: How, is_hole: bool) -> Iterator[Ring]:
        """Outside of it or, to erode, inside; outer rings and holes have the set on their left."""
        count = len(ring)
        for k in self.sides(ring, r):
            a, b, c = ring[k], ring[(k + 1) % count], ring[(k + 2) % count]
            yield self.rectangle(a, b, self.normal(a, b), r)
            yield self.join(b, self.normal(a, b), self.normal(b, c), r, how)

    def of_line(self, line: Ring, r: float, how: How) -> Iterator[Ring]:
        if len(line) == 1:
            yield self.disc(line[0], r)
            return
        for way in self.ways(line):
            for k in range(len(way) - 1):
                n = self.normal(way[k], way[k + 1])
                yield self.rectangle(way[k], way[k + 1], n, r)
                if k + 2 < len(way):
                    m = self.normal(way[k + 1], way[k + 2])
                    yield self.join(way[k + 1], n, m, r, how)
            yield self.end(way[-1], self.normal(way[-2], way[-1]), r, how.get("cap", "round"))

    def ways(self, line: Ring) -> list[Ring]:
        return [line, line[::-1]]

    def sides(self, ring: Ring, r: float) -> list[int]:
        return list(range(len(ring)))

    def normal(self, a: Point, b: Point) -> Point:
        """A unit vector to the right."""
        length = math.hypot(b[0] - a[0], b[1] - a[1])
        return ((b[1] - a[1]) / length, (a[0] - b[0]) / length)

    def rectangle(self, a: Point, b: Point, n: Point, r: float) -> Ring:
        return ccw([a, go(a, n, r), go(b, n, r), b])

    def disc(self, v: Point, r: float) -> Ring:
        steps = [math.tau * (k + self.turn) / self.corners for k in range(self.corners)]
        return [go(v, (math.cos(t), math.sin(t)), abs(r)) for t in steps]

    def join(self, v: Point, n: Point, m: Point, r: float, how: How) -> Ring:
        """`n`, `m`: the normals before and after the corner."""
        join = how.get("join", "round")
        if join == "round":
            return self.disc(v, r)
        turned, along = n[0] * m[1] - n[1] * m[0], n[0] * m[0] + n[1] * m[1]
        if turned < -STRAIGHT:
            return []
        ratio = math.sqrt(2 / (1 + along))
        if join == "bevel" or (join == "mitre" and ratio > self.limit(how, r)):
            return self.bevel(v, n, m, r)
        axis = ((n[0] + m[0]) / 2, (n[1] + m[1]) / 2)
        tip = go(v, axis, r * ratio * ratio)
        if join == "mitre":
            return [v, go(v, n, r), tip, go(v, m, r)]
        t = (1 - 1 / ratio) / math.sqrt(1 - 1 / ratio**2) if ratio > 1 else 0.0
        return [v, go(v, n, r), go(go(v, n, r), (-n[1], n[0]), r * t),
                go(go(v, m, r), (m[1], -m[0]), r * t), go(v, m, r)]  # fmt: skip

    def limit(self, how: How, r: float) -> float:
        return float(how["limit"])

    def bevel(self, v: Point, n: Point, m: Point, r: float) -> Ring:
        return [v, go(v, n, r), go(v, m, r)]

    def end(self, v: Point, n: Point, r: float, cap: str) -> Ring:
        if cap == "round":
            return self.disc(v, r)
        if cap == "flat":
            return []
        return self.square_end(v, n, r)

    def square_end(self, v: Point, n: Point, r: float) -> Ring:
        left, right, d = go(v, n, -r), go(v, n, r), (-n[1], n[0])
        return ccw([left, v, right, go(right, d, r), go(left, d, r)])  # v: no slit beside the sides


def rings_of(P: dict[str, Any]) -> list[list[Ring]]:
    """Returns each polygon's rings."""
    return [
        [[(x, y) for x, y in ring] for ring in (each["outer"], *each["holes"])]
        for each in P["polygons"]
    ]


def go(a: Point, way: Point, far: float) -> Point:
    return (a[0] + way[0] * far, a[1] + way[1] * far)


def area(ring: Ring) -> float:
    """Twice the area, seen from the first point."""
    x, y = ring[0]
    at = [(a - x, b - y) for a, b in ring]
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(at, at[1:] + at[:1], strict=True))


def ccw(ring: Ring) -> Ring:
    return ring if area(ring) >= 0 else ring[::-1]
