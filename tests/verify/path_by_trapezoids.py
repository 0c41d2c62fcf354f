"""Whether a part passes along a path at one scale, in plain fractions: both sets are cut into
trapezoids, and for each pair a path segment is tested against the directions across their sides.
Uses nothing from minkref."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

Point = tuple[Fraction, Fraction]
Piece = list[Point]


def passes(part: Any, obstacles: Any, path: list[Point], scale: Fraction, contact: str) -> bool:
    own = [[(-scale * x, -scale * y) for x, y in piece] for piece in trapezoids(part)]
    fixed = trapezoids(obstacles)
    segments = list(pairwise(path)) or [(path[0], path[0])]
    return not any(
        collides(a, b, moved, piece, contact == "allowed")
        for moved in own
        for piece in fixed
        for a, b in segments
    )


def trapezoids(value: Any) -> list[Piece]:
    """Between the vertical lines through all vertices, by the rule of even and odd."""
    rings = [
        [(Fraction(x), Fraction(y)) for x, y in ring]
        for polygon in value["polygons"]
        for ring in (polygon["outer"], *polygon.get("holes", []))
    ]
    edges = [
        (min(p, q), max(p, q))
        for ring in rings
        for p, q in zip(ring, [*ring[1:], ring[0]], strict=True)
        if p[0] != q[0]
    ]
    pieces = []
    for left, right in pairwise(sorted({x for ring in rings for x, _ in ring})):
        crossing = [edge for edge in edges if edge[0][0] <= left and edge[1][0] >= right]
        heights = sorted((height(edge, left), height(edge, right)) for edge in crossing)
        heights.sort(key=sum)
        for (a, b), (c, d) in zip(heights[::2], heights[1::2], strict=True):
            pieces.append([(left, a), (right, b), (right, d), (left, c)])
    return pieces


def height(edge: tuple[Point, Point], x: Fraction) -> Fraction:
    (px, py), (qx, qy) = edge
    return py + (qy - py) * (x - px) / (qx - px)


def collides(a: Point, b: Point, moved: Piece, piece: Piece, may_touch: bool) -> bool:
    """Whether some place on the segment lies in the sum of both pieces (without its boundary if
    they may touch): no direction separates them."""
    u, v = b[1] - a[1], a[0] - b[0]
    directions = [*across(moved), *across(piece), (u, v), (-u, -v)]
    for x, y in directions:
        if not x and not y:
            continue
        reach = max(x * p + y * q for p, q in moved) + max(x * p + y * q for p, q in piece)
        least = min(x * a[0] + y * a[1], x * b[0] + y * b[1])
        if least > reach or (may_touch and least == reach):
            return False
    return True


def across(piece: Piece) -> list[Point]:
    """Outward directions across a piece's sides."""
    sides = zip(piece, [*piece[1:], piece[0]], strict=True)
    middle = (sum(x for x, _ in piece) / len(piece), sum(y for _, y in piece) / len(piece))
    found = []
    for (px, py), (qx, qy) in sides:
        x, y = qy - py, px - qx
        outward = x * (px - middle[0]) + y * (py - middle[1]) >= 0
        found.append((x, y) if outward else (-x, -y))
    return found
