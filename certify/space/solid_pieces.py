"""Convex pieces of a polyhedron for a certificate (docs/certificates-solids.md): their hulls at a
scaling, in whole numbers, and the features of all pieces with the pieces that hold them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import chain
from math import gcd, lcm

from minkref import _core

Whole = tuple[int, int, int]
Feature = tuple[Whole, ...]  # the corners of a corner, an edge or a facet of a piece
Row = tuple[str, str, str]


class Tiling:
    """Convex pieces with disjoint interiors whose union is a polyhedron, as the reference finds
    them. Exact."""

    def __init__(self, surface: _core.Polyhedron, name: str) -> None:
        """Raises _core.BadInput if the polyhedron is invalid."""
        _core.PolyhedralSet(surface, name)
        place: dict[Row, int] = {}
        for i, point in enumerate(surface.written_points()):
            place.setdefault(point, i)
        self.points = list(surface.written_points())
        self.given = len(self.points)
        self.rings: list[list[list[int]]] = []  # facets' rings, by piece
        for piece in _core.convex_pieces(surface):
            convex = _core.ConvexPolyhedron(piece, name).surface()
            for point in convex.written_points():
                if point not in place:
                    place[point] = len(self.points)
                    self.points.append(point)
            numbers = [place[point] for point in convex.written_points()]
            self.rings.append([[numbers[v] for v in ring] for ring in convex.rings()])

    def value(self) -> dict[str, object]:
        """The tiling as a certificate writes it."""
        hulls = [sorted(set(chain(*rings))) for rings in self.rings]
        return {"points": self.points[self.given :], "hulls": hulls}

    def unit(self) -> int:
        return lcm(*(Fraction(c).denominator for point in self.points for c in point))


class Hull:
    """A piece at a scaling."""

    def __init__(self, rings: Iterable[list[Whole]]) -> None:
        self.facets = {normal_of(ring): ring for ring in rings}
        self.corners = sorted({p for ring in self.facets.values() for p in ring})
        self.edges = {
            (min(a, b), max(a, b)) for ring in self.facets.values() for a, b in edges_of(ring)
        }
        self.ways = sorted({primitive(minus(b, a)) for a, b in self.edges})
        self.levels = [(n, inner(n, ring[0])) for n, ring in self.facets.items()]

    def support(self, n: Whole) -> int:
        return max(inner(n, p) for p in self.corners)

    def holds(self, p: Whole) -> bool:
        return all(inner(n, p) <= level for n, level in self.levels)


def hulls_at(tiling: Tiling, scaling: Row, unit: int) -> list[Hull]:
    """The pieces at a scaling, times `unit`, which makes coordinates whole."""
    factors = [Fraction(factor) * unit for factor in scaling]
    at: list[Whole] = []
    for point in tiling.points:
        x, y, z = (int(f * Fraction(c)) for f, c in zip(factors, point, strict=True))
        at.append((x, y, z))
    return [Hull([[at[v] for v in ring] for ring in rings]) for rings in tiling.rings]


class ScaledTiling:
    """All pieces at a scaling, times `unit`, which makes coordinates whole."""

    def __init__(self, tiling: Tiling, scaling: Row, unit: int) -> None:
        self.hulls = hulls_at(tiling, scaling, unit)
        holders = {
            p: frozenset(k for k, hull in enumerate(self.hulls) if hull.holds(p))
            for p in {p for hull in self.hulls for p in hull.corners}
        }
        self.features: dict[Feature, frozenset[int]] = {}
        for hull in self.hulls:
            facets = (tuple(sorted(ring)) for ring in hull.facets.values())
            for feature in chain(((p,) for p in hull.corners), hull.edges, facets):
                held = frozenset.intersection(*(holders[p] for p in feature))
                self.features[feature] = held
        self.normals = {n for hull in self.hulls for n in hull.facets}
        self.edges = [
            (feature, sorted({p for k in held for p in self.hulls[k].corners}))
            for feature, held in self.features.items()
            if len(feature) == 2
        ]

    def tops(self, n: Whole) -> Iterator[tuple[Feature, int]]:
        """Features level along n above which no piece that holds them rises; their heights."""
        supports = [hull.support(n) for hull in self.hulls]
        for feature, held in self.features.items():
            level = inner(n, feature[0])
            if any(inner(n, p) != level for p in feature[1:]):
                continue
            if all(supports[k] <= level for k in held):
                yield feature, level


def inner(a: Whole, b: Whole) -> int:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def outer(a: Whole, b: Whole) -> Whole:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def minus(a: Whole, b: Whole) -> Whole:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def plus(a: Whole, b: Whole) -> Whole:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def primitive(a: Whole) -> Whole:
    divisor = gcd(*a) or 1
    return a[0] // divisor, a[1] // divisor, a[2] // divisor


def edges_of(ring: list[Whole]) -> Iterator[tuple[Whole, Whole]]:
    return zip(ring, ring[1:] + ring[:1], strict=True)


def normal_of(ring: list[Whole]) -> Whole:
    x = y = z = 0
    for a, b in edges_of(ring):
        n = outer(a, b)
        x, y, z = x + n[0], y + n[1], z + n[2]
    return primitive((x, y, z))
