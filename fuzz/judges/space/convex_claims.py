"""Compares the facets that a repair of a convex sum claims with the exact sum's facets, and finds
where they differ."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, pairwise
from math import gcd

from minkref import _core
from minkref.fuzz.judges.plane.rounded_sums import last_place

Vector = tuple[Fraction, Fraction, Fraction]
Pair = tuple[int, int]
Claim = tuple[str, list[Pair]]  # fv, vf or ee; the ring, pairs (vertex of P, vertex of Q)
Scaling = tuple[str, str, str]
NOT_SUPPORTING, OVERLAPPING, MISSING = "not-supporting", "overlapping", "missing"


@dataclass(frozen=True)
class ClaimComparison:
    """`fault` is None if the claimed facets equal the sum's. Otherwise
    - `not-supporting`: `vertex`, a vertex of P and one of Q, gives a point of the sum above the
      plane of the claimed facet `ring`, whose kind is `kind`;
    - `overlapping`: `ring` shares some area with another claimed facet;
    - `missing`: no claimed facet covers a part of the sum's facet with the corners `ring`.

    `ulps`: the largest error of a coordinate, in units in the last place of the exact sum's largest
    coordinate."""

    fault: str | None
    kind: str | None = None
    ring: tuple[Pair, ...] = ()
    vertex: Pair | None = None
    ulps: Fraction = Fraction(0)


def compare_claims(
    P: _core.ConvexPolyhedron, Q: _core.ConvexPolyhedron, scaling: Scaling, claims: Sequence[Claim]
) -> ClaimComparison:
    """Exact, from the static route. The claimed facets equal the sum's iff each supports the sum,
    no two share an area, and in each plane their area equals the area of the sum's facet. Facets
    without area count for nothing. O(k (m + n))."""
    exact = _core.convex_sum(P, Q, scaling)
    first = _points(P.surface(), scaling)
    second = _points(Q.surface())
    facets = _by_direction(exact)
    claimed: dict[Vector, list[tuple[str, list[Pair], list[Vector], Vector]]] = {}
    for kind, ring in claims:
        corners = [_add(first[p], second[q]) for p, q in ring]
        area = _area(corners)
        if not any(area):
            continue
        direction = _direction(area)
        found = facets.get(direction)
        if found is None or not all(p in found.P and q in found.Q for p, q in ring):
            above = _farthest(first, area), _farthest(second, area)
            return ClaimComparison(NOT_SUPPORTING, kind, tuple(ring), above)
        claimed.setdefault(direction, []).append((kind, ring, corners, area))
    for group in claimed.values():
        for (_, _, a, area), (kind, ring, b, _) in combinations(group, 2):
            if _overlap(a, b, area):
                return ClaimComparison(OVERLAPPING, kind, tuple(ring))
    for direction, facet in facets.items():
        areas = [area for *_, area in claimed.get(direction, ())]
        if _total(areas) != facet.area:
            return ClaimComparison(MISSING, None, facet.ring)
    return ClaimComparison(None)


def largest_distance(
    P: _core.ConvexPolyhedron,
    Q: _core.ConvexPolyhedron,
    scaling: Scaling,
    repair: _core.PaperRepair,
    bits: int,
) -> Fraction:
    """The largest coordinate error among claimed corners, in units in the last place."""
    first, second = _points(P.surface(), scaling), _points(Q.surface())
    pairs = sorted({pair for _, ring in repair.facets() for pair in ring})
    right = [_add(first[p], second[q]) for p, q in pairs]
    largest = max(abs(x) for point in right for x in point)
    off = max(
        abs(Fraction(x) - y)
        for point, other in zip(repair.coordinates(pairs), right, strict=True)
        for x, y in zip(point, other, strict=True)
    )
    return off / last_place(largest, bits)


@dataclass(frozen=True)
class _Facet:
    P: frozenset[int]
    Q: frozenset[int]
    area: Vector
    ring: tuple[Pair, ...]


def _by_direction(exact: _core.ConvexSum) -> dict[Vector, _Facet]:
    points = _points(exact.surface)
    found = {}
    for ring, (P, Q) in zip(exact.surface.rings(), exact.facet_parents, strict=True):
        area = _area([points[k] for k in ring])
        pairs = tuple(exact.vertex_parents[k] for k in ring)
        found[_direction(area)] = _Facet(frozenset(P), frozenset(Q), area, pairs)
    return found


def _points(surface: _core.Polyhedron, scaling: Scaling = ("1", "1", "1")) -> list[Vector]:
    x, y, z = map(Fraction, scaling)
    return [
        (x * Fraction(point[0]), y * Fraction(point[1]), z * Fraction(point[2]))
        for point in surface.points()
    ]


def _add(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def _minus(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _cross(u: Vector, v: Vector) -> Vector:
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def _dot(u: Vector, v: Vector) -> Fraction:
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def _total(vectors: Sequence[Vector]) -> Vector:
    total = (Fraction(0), Fraction(0), Fraction(0))
    for vector in vectors:
        total = _add(total, vector)
    return total


def _area(corners: Sequence[Vector]) -> Vector:
    """Twice the area, along the normal."""
    start, *others = corners
    sides = [_minus(corner, start) for corner in others]
    return _total([_cross(u, v) for u, v in pairwise(sides)])


def _direction(vector: Vector) -> Vector:
    """The same for all positive multiples."""
    under = 1
    for x in vector:
        under = under * x.denominator // gcd(under, x.denominator)
    common = gcd(*(int(x * under) for x in vector))
    x, y, z = (x * under / common for x in vector)
    return (x, y, z)


def _farthest(points: Sequence[Vector], along: Vector) -> int:
    return max(range(len(points)), key=lambda k: _dot(points[k], along))


def _overlap(a: Sequence[Vector], b: Sequence[Vector], normal: Vector) -> bool:
    """Whether two convex rings in one plane, both counter-clockwise seen against the normal, share
    an area: whether no side of either has the other ring on its outer side."""
    return not any(
        all(_dot(_cross(_minus(end, start), _minus(p, start)), normal) <= 0 for p in other)
        for ring, other in ((a, b), (b, a))
        for start, end in zip(ring, [*ring[1:], ring[0]], strict=True)
    )
