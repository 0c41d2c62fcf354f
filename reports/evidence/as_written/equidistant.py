"""Places as far from several features, from their equations: n · x = h + r in front of an edge with
the outward unit normal n, |x - v| = r about a vertex. In numbers of 1,500 bits."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import gmpy2
from minkref.reports.evidence.as_written.units import TIE, Real

Row = tuple[Real, Real, Real, Real]  # a x + b y + c r = d


@dataclass(frozen=True)
class Vertex:
    x: Any
    y: Any


@dataclass(frozen=True)
class Edge:
    """From one vertex to the next, with the set on the left."""

    start: Vertex
    end: Vertex

    def row(self) -> Row:
        dx, dy = self.end.x - self.start.x, self.end.y - self.start.y
        long = gmpy2.sqrt(gmpy2.mpfr(dx * dx + dy * dy))
        n = dy / long, -dx / long
        return n[0], n[1], gmpy2.mpq(-1), n[0] * self.start.x + n[1] * self.start.y

    def across(self, end: Vertex) -> Row:
        """The edge's normal line through an end."""
        dx, dy = self.end.x - self.start.x, self.end.y - self.start.y
        return dx, dy, gmpy2.mpq(0), dx * end.x + dy * end.y


Feature = Vertex | Edge
Solution = tuple[Real, Real, Real]


def distance(p: tuple[Real, Real], feature: Feature) -> Real:
    """The distance from a vertex, or from the line of an edge."""
    if isinstance(feature, Vertex):
        return gmpy2.sqrt(gmpy2.mpfr((p[0] - feature.x) ** 2 + (p[1] - feature.y) ** 2))
    a, b, _, d = feature.row()
    return a * p[0] + b * p[1] - d


def solutions(features: list[Feature]) -> Iterator[Solution]:
    """Places equally far from three or more features: x, y and the radius. Tries every three
    features, so that features on one line hide no solution."""
    for three in combinations(features, 3):
        for found in _of_three(list(three)):
            if found[2] > 0 and all(_as_far(found, feature) for feature in features):
                yield found


def _as_far(at: Solution, feature: Feature) -> bool:
    return bool(abs(distance(at[:2], feature) - at[2]) <= at[2] * gmpy2.mpq(1, 2**500))


def _of_three(features: list[Feature]) -> list[Solution]:
    points = [one for one in features if isinstance(one, Vertex)]
    rows = [one.row() for one in features if isinstance(one, Edge)]
    # |x - v|² = |x - w|² gives a linear row
    rows += [_between(points[0], other) for other in points[1:]]
    rows += [_in_front(one, points[0]) for one in features if points and isinstance(one, Edge)]
    if not points:
        found = _linear(rows)
        return [found] if found else []
    for two in combinations(rows, 2):
        found_two = _with_circle(two[0], two[1], points[0])
        if found_two:
            return found_two
    return []


def _between(v: Vertex, w: Vertex) -> Row:
    squares = w.x**2 + w.y**2 - v.x**2 - v.y**2
    return 2 * (w.x - v.x), 2 * (w.y - v.y), gmpy2.mpq(0), squares


def _in_front(edge: Edge, vertex: Vertex) -> Row:
    """The edge's normal at one of its ends, on which both distances agree; zeros for other
    vertices."""
    if vertex in (edge.start, edge.end):
        return edge.across(vertex)
    return gmpy2.mpq(0), gmpy2.mpq(0), gmpy2.mpq(0), gmpy2.mpq(0)


def _cross(a: Row, b: Row) -> tuple[Real, Real, Real]:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _size(row: Row | tuple[Real, Real, Real]) -> Real:
    return sum(abs(one) for one in row[:3])


def _small(value: Real, size: Real) -> bool:
    return bool(abs(value) <= size * TIE)


def _linear(rows: list[Row]) -> Solution | None:
    a, b, c = rows
    normal = _cross(a, b)
    turn = sum(p * q for p, q in zip(normal, c[:3], strict=True))
    if _small(turn, _size(a) * _size(b) * _size(c)):
        return None
    ways = [_cross(b, c), _cross(c, a), normal]
    x, y, r = (
        sum(one[3] * way[k] for one, way in zip(rows, ways, strict=True)) / turn for k in range(3)
    )
    return x, y, r


def _with_circle(a: Row, b: Row, v: Vertex) -> list[Solution]:
    """Where two linear equations and |x - v| = r hold."""
    way = _cross(a, b)
    if _small(_size(way), _size(a) * _size(b)):
        return []
    # the point of the line of solutions with way · (x - v, y - v, r) = 0
    da, db = a[3] - a[0] * v.x - a[1] * v.y, b[3] - b[0] * v.x - b[1] * v.y
    foot = _linear([(*a[:3], da), (*b[:3], db), (*way, gmpy2.mpq(0))])
    if foot is None:
        return []
    # (foot + t way) in the cone x² + y² = r²
    p = way[0] ** 2 + way[1] ** 2 - way[2] ** 2
    q = foot[0] * way[0] + foot[1] * way[1] - foot[2] * way[2]
    s = foot[0] ** 2 + foot[1] ** 2 - foot[2] ** 2
    return [
        (foot[0] + t * way[0] + v.x, foot[1] + t * way[1] + v.y, foot[2] + t * way[2])
        for t in _roots(p, q, s, _size(way) ** 2, _size(foot) * _size(way))
    ]


def _roots(p: Real, q: Real, s: Real, p_size: Real, q_size: Real) -> list[Real]:
    """The roots of p t² + 2 q t + s, without cancellation."""
    if _small(p, p_size):
        return [] if _small(q, q_size) else [-s / (2 * q)]
    left = q * q - p * s
    if _small(left, q_size * q_size):
        left = gmpy2.mpq(0)  # they touch
    if left < 0:
        return []
    root = gmpy2.sqrt(gmpy2.mpfr(left))
    far = -q - root if q > 0 else -q + root
    return [far / p] if far == 0 or root == 0 else [far / p, s / far]


def between(a: Feature, b: Feature) -> Solution | None:
    """The midpoint between two features, where they come nearest to each other."""
    if isinstance(a, Edge) and isinstance(b, Edge):
        return None
    if isinstance(a, Edge):
        a, b = b, a
    assert isinstance(a, Vertex)
    if isinstance(b, Vertex):
        x, y = (a.x + b.x) / 2, (a.y + b.y) / 2
        return x, y, distance((x, y), a)
    nx, ny, _, _ = b.row()
    half = distance((a.x, a.y), b) / 2
    return a.x - half * nx, a.y - half * ny, half
