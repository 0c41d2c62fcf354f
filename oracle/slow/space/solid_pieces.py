"""A solid as convex pieces with disjoint interiors: face planes halve space until no cell has a
face inside.

Each cell keeps its part of a face as a ring that may run to and fro along one line: cutting a ring
by a half-space, corner by corner, preserves the vector area, and nothing more is needed.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property

from ..exact import InputError
from .solid import Place, Solid, Whole, height, inner, plane_of, shortest, vector_area, wholes

Plane = tuple[Whole, Fraction]
Ring = list[Place]
MOST_CANDIDATES = 24  # planes compared before cutting a cell


@dataclass
class Piece:
    """A convex polytope, a segment or a point with corners `corners` over `unit`. Normals point
    outwards; `edges` keeps one of two opposite directions."""

    unit: int
    corners: list[Whole]
    normals: list[Whole]
    edges: list[Whole]
    low: Place
    high: Place
    supports: dict[Whole, int] = field(default_factory=dict)

    def support(self, n: Whole) -> int:
        """Return the greatest n . x on the piece, times `unit`."""
        found = self.supports.get(n)
        if found is None:
            found = self.supports[n] = max(inner(n, corner) for corner in self.corners)
        return found


@dataclass(frozen=True)
class Part:
    """A face's part in a cell."""

    plane: Plane
    ring: Ring

    @cached_property
    def wholes(self) -> tuple[int, list[Whole]]:
        return wholes(self.ring)


def convex_pieces(solid: Solid) -> list[Piece]:
    """Cut a solid into convex pieces. Exact. Grows with the faces times the cells that they cut."""
    if solid.ends:
        return [piece_of([solid.ends])]
    parts = [Part(plane_of(ring), ring) for ring in solid.faces]
    found: list[Piece] = []
    ahead = [(box_around([point for ring in solid.faces for point in ring]), parts)]
    while ahead:
        cell, parts = ahead.pop()
        plane = best_plane(parts)
        behind, front = sided(parts, plane), sided(parts, opposite(plane))
        # Both halves have a face of the plane on their rim, so a half without further faces is
        # decided.
        faced = any(part.plane == plane for part in parts)
        for half, inside, side in ((behind, faced, plane), (front, not faced, opposite(plane))):
            if not half and not inside:
                continue
            smaller = halved(cell, side)
            if half:
                ahead.append((smaller, half))
            else:
                found.append(piece_of(smaller))
    return found


def opposite(plane: Plane) -> Plane:
    (a, b, c), offset = plane
    return (-a, -b, -c), -offset


def best_plane(parts: list[Part]) -> Plane:
    """Return the plane that cuts the fewest faces, and then balances the sides best."""
    planes = list(dict.fromkeys(part.plane for part in parts))
    step = 1 + len(planes) // MOST_CANDIDATES

    def cost(plane: Plane) -> tuple[int, int]:
        n, offset = plane
        cut = balance = 0
        for part in parts:
            unit, points = part.wholes
            levels = [inner(n, point) * offset.denominator for point in points]
            level = offset.numerator * unit
            above, below = max(levels) > level, min(levels) < level
            cut += above and below
            balance += above - below
        return cut, abs(balance)

    return min(planes[::step], key=cost)


def sided(parts: list[Part], plane: Plane) -> list[Part]:
    """Return the parts below the plane, without faces in the plane."""
    kept = []
    for part in parts:
        if part.plane in (plane, opposite(plane)):
            continue
        ring = below(part.ring, plane)
        if len(ring) > 2 and vector_area(ring) != (0, 0, 0):
            kept.append(Part(part.plane, ring))
    return kept


def below(ring: Ring, plane: Plane) -> Ring:
    """Cut a ring to n . x <= offset."""
    n, offset = plane
    unit, points = wholes(ring)
    levels = [inner(n, point) * offset.denominator - offset.numerator * unit for point in points]
    if max(levels) <= 0:
        return ring
    kept: Ring = []
    for k, b in enumerate(ring):
        a, at_a, at_b = ring[k - 1], levels[k - 1], levels[k]
        if at_a * at_b < 0:
            t = Fraction(at_a, at_a - at_b)
            x, y, z = (p + t * (q - p) for p, q in zip(a, b, strict=True))
            kept.append((x, y, z))
        if at_b <= 0:
            kept.append(b)
    return kept


def halved(cell: list[Ring], plane: Plane) -> list[Ring]:
    """Return the part below the plane of a convex cell, given as facets; the plane must cut the
    interior."""
    kept = []
    on: dict[Place, None] = {}
    for facet in cell:
        ring = below(facet, plane)
        if len(ring) > 2 and vector_area(ring) != (0, 0, 0):
            kept.append(ring)
            on |= dict.fromkeys(point for point in ring if height(plane[0], point) == plane[1])
    kept.append(convex_ring(list(on), plane[0]))
    return kept


def convex_ring(points: list[Place], normal: Whole) -> Ring:
    """Return the convex hull of coplanar points as a ring, counter-clockwise seen from the normal's
    side."""
    axis = next(k for k in range(3) if normal[k])
    u, v = (k for k in range(3) if k != axis)

    def turn(a: Place, b: Place, c: Place) -> Fraction:
        return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u])

    chains: list[Ring] = []
    ordered = sorted(points, key=lambda point: (point[u], point[v]))
    for sequence in (ordered, ordered[::-1]):
        chain: Ring = []
        for point in sequence:
            while len(chain) > 1 and turn(chain[-2], chain[-1], point) <= 0:
                chain.pop()
            chain.append(point)
        chains.append(chain[:-1])
    ring = chains[0] + chains[1]
    if len(ring) < 3:
        raise InputError("the faces do not bound a solid")
    return ring if inner(vector_area(ring), normal) > 0 else ring[::-1]


def box_around(points: list[Place]) -> list[Ring]:
    """Return the facets of a box with all points strictly inside."""
    low = [min(point[k] for point in points) - 1 for k in range(3)]
    high = [max(point[k] for point in points) + 1 for k in range(3)]
    facets = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for end, turns in ((high, 1), (low, -1)):
            ring = []
            for at_u, at_v in ((low, low), (high, low), (high, high), (low, high))[::turns]:
                point = [Fraction(0)] * 3
                point[axis], point[u], point[v] = end[axis], at_u[u], at_v[v]
                ring.append((point[0], point[1], point[2]))
            facets.append(ring)
    return facets


def piece_of(facets: list[Ring]) -> Piece:
    """Make a piece from a polytope's facets, or from a ring of one or two points."""
    points = list(dict.fromkeys(point for ring in facets for point in ring))
    unit, corners = wholes(points)
    place = dict(zip(points, corners, strict=True))
    edges: dict[Whole, None] = {}
    for ring in facets:
        for p, q in zip(ring, ring[1:] + ring[:1], strict=True):
            if p != q:
                a, b = sorted((place[p], place[q]))
                edges[shortest((b[0] - a[0], b[1] - a[1], b[2] - a[2]))] = None
    normals = dict.fromkeys(plane_of(ring)[0] for ring in facets if len(ring) > 2)
    low = [min(point[k] for point in points) for k in range(3)]
    high = [max(point[k] for point in points) for k in range(3)]
    ends = (low[0], low[1], low[2]), (high[0], high[1], high[2])
    return Piece(unit, corners, list(normals), list(edges), *ends)
