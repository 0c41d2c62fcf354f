"""Tells whether x + Q lies within P, from the definition: no sum, no complement.

Cut at the other's corners and at crossings, each piece of an edge of x + Q lies in P or outside, so
that its middle decides; so does each piece of an edge of P, which must not pass through the
interior of x + Q. Where pieces of both lie on each other, the interiors must be on the same side.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from .exact import Point
from .operand import Operand, Ring
from .place import inside, on_boundary
from .validity import sides

Side = tuple[Point, Point]


def lies_within(P: Operand, Q: Operand, x: Point, scale: Fraction = Fraction(1)) -> bool:
    """Decide whether x + Q is a part of the closed set sP. Exact. Cost: (m + n)^2 and more."""
    rings = [[(scale * a, scale * b) for a, b in ring] for ring in P.rings()]
    ends = [(scale * a, scale * b) for a, b in P.ends]
    placed = [[(a + x[0], b + x[1]) for a, b in ring] for ring in Q.rings()]
    if not rings:
        return not placed and all(between(ends, (a + x[0], b + x[1])) for a, b in Q.ends)
    own = [(a + x[0], b + x[1]) for a, b in Q.ends]
    if len(own) == 1:
        return in_closed(rings, own[0])
    edges = sides_of(rings)
    moved = sides_of(placed) if placed else [(own[0], own[1])]
    for a, b, middle in pieces(moved, edges):
        if not on_boundary(rings, middle):
            if not inside(rings, middle):
                return False
        elif placed and any(runs_against((a, b), edge, middle) for edge in edges):
            return False
    return not any(
        inside(placed, middle) and not on_boundary(placed, middle)
        for _, _, middle in pieces(edges, moved)
    )


def sides_of(rings: list[Ring]) -> list[Side]:
    return [side for ring in rings for side in sides(ring)]


def in_closed(rings: list[Ring], p: Point) -> bool:
    return on_boundary(rings, p) or inside(rings, p)


def between(ends: list[Point], p: Point) -> bool:
    """Tell whether a point, or the segment of two ends, has the point."""
    return bool(ends) and on_boundary([ends], p)


def runs_against(piece: Side, edge: Side, middle: Point) -> bool:
    """Tell whether an edge passes the middle along the piece's line the other way round."""
    (a, b), (c, d) = piece, edge
    u, v = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1])
    if u[0] * v[1] != u[1] * v[0] or not on_boundary([[c, d]], middle):
        return False
    return u[0] * v[0] + u[1] * v[1] < 0


def pieces(of: list[Side], by: list[Side]) -> Iterator[tuple[Point, Point, Point]]:
    """Yield the parts into which sides cut each edge, with their middles."""
    for a, b in of:
        stops = sorted({Fraction(0), Fraction(1), *(t for c, d in by for t in cuts(a, b, c, d))})
        for low, high in pairwise(stops):
            t = (low + high) / 2
            yield a, b, (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))


def cuts(a: Point, b: Point, c: Point, d: Point) -> list[Fraction]:
    """Return where the line of cd, or an end of it, meets the open segment ab: a superset does."""
    ux, uy, vx, vy = b[0] - a[0], b[1] - a[1], d[0] - c[0], d[1] - c[1]
    turn = ux * vy - uy * vx
    if turn:
        t = ((c[0] - a[0]) * vy - (c[1] - a[1]) * vx) / Fraction(turn)
        return [t] if 0 < t < 1 else []
    if ux * (c[1] - a[1]) != uy * (c[0] - a[0]):
        return []
    length = Fraction(ux * ux + uy * uy)
    found = [(ux * (p[0] - a[0]) + uy * (p[1] - a[1])) / length for p in (c, d)]
    return [t for t in found if 0 < t < 1]
