"""A disc of radius s r swept along a polygon, in exact numbers: offset edges with rational normals,
distances, and scales as algebraic numbers."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import isqrt
from typing import Any

import sympy as sp
from minkref.fuzz.geometry.plane import cross
from minkref.fuzz.judges.disc.paper_disc import Corner, Root, Vertex
from minkref.fuzz.judges.disc.paper_disc import Edge as Side
from minkref.reports.audit.edges import Edge
from minkref.reports.audit.plane import Place


def exact(root: Root) -> Any:
    """A scale of the symbolic oracle, as a sympy number."""
    return sum((sp.Rational(c) * sp.sqrt(m) for m, c in root.terms), sp.Integer(0))


def sides(ring: Sequence[Vertex]) -> list[Side]:
    return list(zip(ring, [*ring[1:], ring[0]], strict=True))


def corner(ring: Sequence[Vertex], k: int) -> Corner:
    return ring[k - 1], ring[k], ring[(k + 1) % len(ring)]


def reflex_pairs(ring: Sequence[Vertex]) -> list[tuple[Side, Side]]:
    """The edges before and after each reflex vertex."""
    found = sides(ring)
    pairs = zip([found[-1], *found[:-1]], found, strict=True)
    return [(a, b) for a, b in pairs if cross(along(a), along(b)) < 0]


def along(side: Side) -> Vertex:
    return side[1][0] - side[0][0], side[1][1] - side[0][1]


def unit_normal(side: Side) -> Place:
    """Outward unit normal, with the polygon on the left. Raises ValueError for an irrational
    length."""
    x, y = along(side)
    length = isqrt(x * x + y * y)
    if length * length != x * x + y * y:
        raise ValueError(f"{side}: the length is irrational")
    return Fraction(y, length), Fraction(-x, length)


def moved_out(side: Side, way: Fraction) -> tuple[Place, Place]:
    """The edge offset outward by `way`; only for edges with rational length."""
    n = unit_normal(side)
    a, b = ((x + way * n[0], y + way * n[1]) for x, y in side)
    return a, b


def moving(side: Side, radius: int) -> Edge:
    """The offset edge p + s r n along d is a T-edge at the vertex r n, which has to be whole."""
    x, y = (radius * coordinate for coordinate in unit_normal(side))
    if x.denominator != 1 or y.denominator != 1:
        raise ValueError(f"{side}: r n is not whole")
    return Edge("T", (int(x), int(y)), side[0], along(side))


def crossing(first: Side, second: Side, way: Fraction) -> Place:
    """The crossing of two edges' lines, both offset by `way`."""
    rows = []
    for side in (first, second):
        n = unit_normal(side)
        rows.append((n, n[0] * side[0][0] + n[1] * side[0][1] + way))
    ((a, u), (b, v)) = rows
    below = cross(a, b)
    return (u * b[1] - v * a[1]) / below, (a[0] * v - b[0] * u) / below


def squared_distance(x: tuple[Any, Any], ring: Sequence[Vertex]) -> Any:
    """Squared distance from a place, as fractions or sympy numbers, to a polygon's edges."""
    return min(_to_side(x, side) for side in sides(ring))


def _to_side(x: tuple[Any, Any], side: Side) -> Any:
    d, w = along(side), (x[0] - side[0][0], x[1] - side[0][1])
    t = min(max((d[0] * w[0] + d[1] * w[1]) / (d[0] ** 2 + d[1] ** 2), 0), 1)
    return (w[0] - t * d[0]) ** 2 + (w[1] - t * d[1]) ** 2
