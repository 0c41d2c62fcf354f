"""The boundary, seen from the complement: edges, corners and wedges, along walks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from math import gcd

Point = tuple[Fraction, Fraction]
Ring = list[Point]


def minus(p: Point, q: Point) -> Point:
    return p[0] - q[0], p[1] - q[1]


def cross(p: Point, q: Point) -> Fraction:
    return p[0] * q[1] - p[1] * q[0]


def dot(p: Point, q: Point) -> Fraction:
    return p[0] * q[0] + p[1] * q[1]


def primitive(way: Point) -> tuple[int, int]:
    common = way[0].denominator * way[1].denominator
    x, y = int(way[0] * common), int(way[1] * common)
    divisor = gcd(x, y)
    return x // divisor, y // divisor


@dataclass(frozen=True, eq=False)
class Edge:
    """An open edge from a to b, a site, the set to the left. Polygons of one `part` touch."""

    a: Point
    b: Point
    part: int

    @cached_property
    def along(self) -> Point:
        return minus(self.b, self.a)

    @cached_property
    def normal(self) -> Point:
        """Outwards, as long as the edge."""
        dx, dy = self.along
        return dy, -dx

    @cached_property
    def height(self) -> Fraction:
        """The value of normal . p along the edge."""
        return dot(self.normal, self.a)

    @cached_property
    def square(self) -> Fraction:
        return dot(self.along, self.along)

    def over(self, p: Point) -> Fraction:
        """Positive in front."""
        return dot(self.normal, p) - self.height


@dataclass(frozen=True, eq=False)
class Corner:
    """A vertex with a wedge of the complement of more than half a turn: a site."""

    at: Point
    part: int


Site = Edge | Corner


@dataclass(frozen=True, eq=False)
class Wedge:
    """A wedge of the complement of less than half a turn: a reflex end of the medial axis. Edge
    `first` arrives at the vertex and edge `second` leaves it, the wedge on their right."""

    at: Point
    first: Edge
    second: Edge


class Outline:
    """Walks along the complement's boundary. Straight vertices are dropped; touching rings give a
    vertex several wedges, each passed by itself. Exact; O(n^2)."""

    def __init__(self, polygons: Sequence[Sequence[Sequence[Point]]]) -> None:
        self.edges: list[Edge] = []
        self.corners: list[Corner] = []
        self.wedges: list[Wedge] = []
        self.holes = 0  # bounded components of the complement
        self.walks = 0
        pieces = edges_of(polygons)
        after = _links(pieces)
        left = set(range(len(pieces)))
        while left:
            walk = [min(left)]
            while (following := after[walk[-1]]) != walk[0]:
                walk.append(following)
            left -= set(walk)
            self._add([pieces[k] for k in walk])
        self.sites: list[Site] = [*self.edges, *self.corners]
        self.gaps = _gaps(self)

    def _add(self, walk: list[Edge]) -> None:
        self.walks += 1
        self.holes += sum(cross(e.a, e.b) for e in walk) < 0
        turns = [cross(e.along, f.along) for e, f in zip(walk, [*walk[1:], walk[0]], strict=True)]
        start = next(k for k, turn in enumerate(turns) if turn) + 1
        merged: list[Edge] = []
        first = walk[start % len(walk)]
        for k in range(start, start + len(walk)):
            edge, turn = walk[k % len(walk)], turns[k % len(walk)]
            if turn:
                merged.append(Edge(first.a, edge.b, edge.part))
                first = walk[(k + 1) % len(walk)]
        self.edges += merged
        for e, f in zip(merged, [*merged[1:], merged[0]], strict=True):
            if cross(e.along, f.along) > 0:
                self.corners.append(Corner(e.b, e.part))
            else:
                self.wedges.append(Wedge(e.b, e, f))


def edges_of(polygons: Sequence[Sequence[Sequence[Point]]]) -> list[Edge]:
    """Edges with the set on the left, cut where vertices lie on them."""
    return _split(_turned(polygons))


def _turned(polygons: Sequence[Sequence[Sequence[Point]]]) -> list[list[Ring]]:
    """Outer rings counter-clockwise, holes clockwise, no point twice in a row."""
    found = []
    for polygon in polygons:
        rings = []
        for k, given in enumerate(polygon):
            points = [(Fraction(x), Fraction(y)) for x, y in given]
            ring = [p for p, q in zip(points, [*points[1:], points[0]], strict=True) if p != q]
            area = sum(cross(p, q) for p, q in zip(ring, [*ring[1:], *ring[:1]], strict=True))
            if area != 0:  # else a point or a segment
                rings.append(ring if (area > 0) == (k == 0) else ring[::-1])
        found.append(rings)
    return found


def _split(polygons: list[list[Ring]]) -> list[Edge]:
    """Edges, cut at vertices of touching rings."""
    corners = {p for polygon in polygons for ring in polygon for p in ring}
    found = []
    for part, polygon in enumerate(polygons):
        for ring in polygon:
            for a, b in zip(ring, [*ring[1:], ring[0]], strict=True):
                along = minus(b, a)
                square = dot(along, along)
                on = [(dot(along, minus(p, a)), p) for p in corners
                      if cross(along, minus(p, a)) == 0]  # fmt: skip
                stops = [p for far, p in sorted(on) if 0 <= far <= square]
                found += [Edge(p, q, part) for p, q in pairwise(stops)]
    name = list(range(len(polygons)))
    seen: dict[Point, int] = {}
    for edge in found:
        mine, other = name[edge.part], name[seen.setdefault(edge.a, edge.part)]
        name = [mine if own == other else own for own in name]
    return [Edge(edge.a, edge.b, name[edge.part]) for edge in found]


def _links(pieces: list[Edge]) -> list[int]:
    """The edge after each edge: the first counter-clockwise from the way back."""
    leaving: dict[Point, list[int]] = {}
    for k, edge in enumerate(pieces):
        leaving.setdefault(edge.a, []).append(k)
    found = []
    for edge in pieces:
        back = minus(edge.a, edge.b)
        best = leaving[edge.b][0]
        for k in leaving[edge.b][1:]:
            if _is_before(back, pieces[k].along, pieces[best].along):
                best = k
        found.append(best)
    return found


def _is_before(start: Point, p: Point, q: Point) -> bool:
    """Whether p comes before q, counter-clockwise from a start."""

    def half(way: Point) -> int:
        side = cross(start, way)
        return 0 if side > 0 or (side == 0 and dot(start, way) > 0) else 1

    if half(p) != half(q):
        return half(p) < half(q)
    return cross(p, q) > 0


def _gaps(outline: Outline) -> list[tuple[Corner, Corner]]:
    """Consecutive corners along the hull's boundary, counter-clockwise, with no edge between."""
    by_place = {corner.at: corner for corner in outline.corners}
    edges = {(edge.a, edge.b) for edge in outline.edges}
    hull: list[Point] = []
    for points in (sorted(by_place), sorted(by_place, reverse=True)):
        chain: list[Point] = []
        for p in points:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], p) < 0:
                chain.pop()
            chain.append(p)
        hull += chain[:-1]
    pairs = zip(hull, [*hull[1:], *hull[:1]], strict=True)
    return [(by_place[p], by_place[q]) for p, q in pairs if (p, q) not in edges]


def _turn(p: Point, q: Point, r: Point) -> Fraction:
    return cross(minus(q, p), minus(r, p))
