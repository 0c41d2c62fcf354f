"""Operands as convex pieces: triangles from clipped ears, then diagonals removed while pieces stay
convex.

The pieces have disjoint interiors and unite to the operand. Each diagonal is an open segment inside
the operand; no piece has a vertex there. Coordinates are integers. Cost: quadratic at worst.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field
from math import lcm

from .bridges import joined, minus
from .ears import triangles
from .exact import InputError, Vector, cross, primitive
from .operand import Operand, twice_area
from .plane import Edge, Plane
from .walks import components


@dataclass
class Piece:
    """A convex polygon, counter-clockwise without straight vertices, or a segment or a point.

    `edges` maps each edge's direction to whether the operand's boundary has part of the edge. A
    segment has both directions, a point none.
    """

    points: list[Vector]
    edges: dict[Vector, bool]
    box: tuple[int, int, int, int] = field(init=False)

    def __post_init__(self) -> None:
        xs = [x for x, _ in self.points]
        ys = [y for _, y in self.points]
        self.box = (min(xs), min(ys), max(xs), max(ys))


@dataclass
class Shape:
    """An operand's pieces in integers (coordinates times `unit`), and its inner diagonals."""

    pieces: list[Piece]
    diagonals: list[tuple[Vector, Vector]]
    unit: int
    is_flat: bool  # a point or a segment

    def size(self) -> int:
        return max((abs(c) for piece in self.pieces for p in piece.points for c in p), default=0)


def common_denominator(operand: Operand) -> int:
    return lcm(1, *(c.denominator for point in operand.points() for c in point))


def shape_of(operand: Operand, unit: int) -> Shape:
    """Cut an operand, times `unit` (a multiple of its common denominator), into convex pieces."""
    if operand.ends:
        ends = [(int(x * unit), int(y * unit)) for x, y in operand.ends]
        ways = [primitive(b[0] - a[0], b[1] - a[1]) for a in ends for b in ends if a != b]
        return Shape([Piece(ends, dict.fromkeys(ways, True))], [], unit, True)
    plane, edges = boundary_of(operand, unit)
    boundary = {(edge.start, edge.end) for edge in edges}
    found: list[list[Vector]] = []
    parts, lone = components(plane, edges)
    if lone:
        raise InputError("a hole lies in no outer ring")
    for part in parts:
        found += triangles(joined(part))
    covered = sum(cross(minus(b, a), minus(c, a)) for a, b, c in found)
    if covered != unit * unit * sum(twice_area(ring) for ring in operand.rings()):
        raise InputError("triangles and rings have different areas: rings cross or overlap")
    polygons, diagonals = merged(found, boundary)
    return Shape([piece_of(p, boundary) for p in polygons], diagonals, unit, False)


def boundary_of(operand: Operand, unit: int) -> tuple[Plane, list[Edge]]:
    """Convert rings to integers, drop straight vertices, and cut edges where other rings touch."""
    plane = Plane()
    edges: list[Edge] = []
    for ring in operand.rings():
        points = [(int(x * unit), int(y * unit)) for x, y in ring]
        ways = [
            primitive(b[0] - a[0], b[1] - a[1])
            for a, b in zip(points, points[1:] + points[:1], strict=True)
        ]
        kept = [
            (p, d) for i, (p, d) in enumerate(zip(points, ways, strict=True)) if ways[i - 1] != d
        ]
        for (p, d), (q, _) in zip(kept, kept[1:] + kept[:1], strict=True):
            plane.points[p] = (*p, 1)
            edges.append(Edge(p, q, d, cross(d, p)))
    return plane, plane.split(edges)


def merged(
    polygons: list[list[Vector]], boundary: set[tuple[Vector, Vector]]
) -> tuple[list[list[Vector]], list[tuple[Vector, Vector]]]:
    """Remove each diagonal whose two neighbours together stay convex."""
    whose: dict[tuple[Vector, Vector], int] = {}
    for index, polygon in enumerate(polygons):
        for a, b in zip(polygon, polygon[1:] + polygon[:1], strict=True):
            whose[a, b] = index
    rings: list[list[Vector]] = [list(polygon) for polygon in polygons]
    kept = []
    for a, b in [way for way in whose if way not in boundary and way < way[::-1]]:
        left, right = whose[a, b], whose[b, a]
        one = rotated(rings[left], b)  # b ... a
        other = rotated(rings[right], a)  # a ... b
        at_a = turn(one[-2], a, other[1])
        at_b = turn(other[-2], b, one[1])
        if at_a < 0 or at_b < 0:
            kept.append((a, b))
            continue
        whole = one + other[1:-1]
        rings[left], rings[right] = whole, []
        for c, d in itertools.pairwise(other):
            whose[c, d] = left
    return [ring for ring in rings if ring], kept


def rotated(ring: list[Vector], first: Vector) -> list[Vector]:
    at = ring.index(first)
    return ring[at:] + ring[:at]


def turn(a: Vector, b: Vector, c: Vector) -> int:
    return cross((b[0] - a[0], b[1] - a[1]), (c[0] - b[0], c[1] - b[1]))


def piece_of(ring: list[Vector], boundary: set[tuple[Vector, Vector]]) -> Piece:
    edges: dict[Vector, bool] = {}
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        way = primitive(b[0] - a[0], b[1] - a[1])
        edges[way] = edges.get(way, False) or (a, b) in boundary
    points = [p for i, p in enumerate(ring) if turn(ring[i - 1], p, ring[(i + 1) % len(ring)])]
    return Piece(points, edges)
