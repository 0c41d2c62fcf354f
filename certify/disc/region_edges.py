"""A region's edges by number, as certificates with discs name them."""

from __future__ import annotations

import itertools
import json
from collections import defaultdict
from collections.abc import Callable
from fractions import Fraction

from minkref import _core
from minkref.certify.case_text import places, plain_polygons, ring_numbers
from minkref.certify.disc.joint_places import Exact
from minkref.certify.disc.near_edge import Edge, way_of


class RegionEdges:
    """Edge n leads from vertex n to the next vertex of its ring. `before`: the edge that ends where
    edge n begins, next to it clockwise; what is between lies outside."""

    def __init__(self, P: _core.PolygonSet) -> None:
        at = places(P)
        self.rings, self._polygons = ring_numbers(P), [len(rings) for rings in P.rings()]
        self.next = {n: ring[(k + 1) % len(ring)] for ring in self.rings
                     for k, n in enumerate(ring)}  # fmt: skip
        self.edges: dict[int, Edge] = {n: (at[n], at[m]) for n, m in self.next.items()}
        arriving: dict[Exact, list[int]] = defaultdict(list)
        for n, edge in self.edges.items():
            arriving[edge[1]].append(n)
        self.before = {n: self._first_right(n, arriving[edge[0]]) for n, edge in self.edges.items()}

    def turn(self, m: int, n: int) -> int:
        """1 if edge n leads to the left of edge m."""
        return _side(way_of(self.edges[m]), way_of(self.edges[n]))

    def _first_right(self, n: int, arriving: list[int]) -> int:
        along = way_of(self.edges[n])
        first, *others = arriving
        for m in others:
            ways = [_back(self.edges[k]) for k in (m, first)]
            sides = [_side(along, way) for way in ways]
            if sides[0] < sides[1] or (sides[0] == sides[1] and _side(*ways) < 0):
                first = m
        return first

    def classes(self) -> tuple[Callable[[int], int], Callable[[int, int], None]]:
        """A union-find of edges, with those of a polygon together: the class of an edge, and a
        function that joins two."""
        above: dict[int, int] = {}

        def root(n: int) -> int:
            while n in above:
                n = above[n]
            return n

        def join(n: int, m: int) -> None:
            if root(n) != root(m):
                above[root(n)] = root(m)

        rings = iter(self.rings)
        for count in self._polygons:
            own = [n for ring in itertools.islice(rings, count) for n in ring]
            for n in own:
                join(n, own[0])
        return root, join


def squared_distance(p: Exact, edge: Edge) -> Fraction:
    (ax, ay), u = edge[0], way_of(edge)
    part = ((p[0] - ax) * u[0] + (p[1] - ay) * u[1]) / (u[0] ** 2 + u[1] ** 2)
    part = min(max(part, Fraction(0)), Fraction(1))
    return (p[0] - ax - part * u[0]) ** 2 + (p[1] - ay - part * u[1]) ** 2


def winds(p: Exact, edges: list[Edge]) -> int:
    """How often edges wind around a point off all of them."""
    found = 0
    for (ax, ay), (bx, by) in edges:
        if (ay <= p[1]) != (by <= p[1]):
            left = (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax)
            found += (by > ay and left > 0) - (by < ay and left < 0)
    return found


def with_touching_vertices(P: _core.PolygonSet) -> _core.PolygonSet:
    """The same set; where a vertex of one ring lies inside an edge of another, both have it."""
    polygons = plain_polygons(P)
    vertices = set(places(P))
    changed = False
    for polygon in polygons:
        rings = [polygon["outer"], *polygon["holes"]]
        made = [_with_vertices(ring, vertices) for ring in rings]
        changed = changed or made != rings
        polygon["outer"], polygon["holes"] = made[0], made[1:]
    return _core.PolygonSet.from_json(json.dumps({"polygons": polygons})) if changed else P


def _with_vertices(ring: list[list[str]], vertices: set[Exact]) -> list[list[str]]:
    corners = [(Fraction(x), Fraction(y)) for x, y in ring]
    found: list[Exact] = []
    for a, b in zip(corners, [*corners[1:], corners[0]], strict=True):
        inside = [p for p in vertices if _is_inside(p, a, b)]
        found += [a, *sorted(inside, reverse=a > b)]
    return [[str(x), str(y)] for x, y in found]


def _is_inside(p: Exact, a: Exact, b: Exact) -> bool:
    if not (min(a, b) < p < max(a, b)):
        return False
    return _side((b[0] - a[0], b[1] - a[1]), (p[0] - a[0], p[1] - a[1])) == 0


def _side(u: Exact, w: Exact) -> int:
    turn = u[0] * w[1] - u[1] * w[0]
    return (turn > 0) - (turn < 0)


def _back(edge: Edge) -> Exact:
    return edge[0][0] - edge[1][0], edge[0][1] - edge[1][1]
