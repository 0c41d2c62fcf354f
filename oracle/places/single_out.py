"""Places singled out by named features, equally far from all features: linear equations and at most
one square root."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from .boundary import Boundary, Edge, Place, Point
from .surd import Surd

# a x + b y + c r = e
Equation = tuple[Fraction, Fraction, Fraction, Fraction]


class NotSingled(Exception):
    """The features single out no place."""


def places_of(boundary: Boundary, features: Sequence[Mapping[str, Any]]) -> list[Place]:
    """Find all points in front of the edges and equally far from the edges' lines and the vertices;
    for two features, the point halfway between."""
    edges, points = [], []
    for each in features:
        if "edge" in each:
            edge = boundary.names.get(tuple(each["edge"]))
            if edge is None:
                raise NotSingled(f"there is no edge {each['edge']}")
            edges.append(edge)
        else:
            points.append((Fraction(each["vertex"][0]), Fraction(each["vertex"][1])))
    if any(point not in boundary.vertices for point in points):
        raise NotSingled("one of its vertices is none")
    equations = [_of_line(edge) for edge in edges]
    equations += [_half_way(points[0], point) for point in points[1:]]
    # If an equally near vertex lies on an edge's line, the place is right in front of the vertex.
    for edge in edges:
        for point in points:
            is_on_line = _height(edge, point) == 0
            if is_on_line or (len(edges) == len(points) == 1):
                equations.append(_in_front(edge, point))
    if not edges and len(points) == 2:
        equations.append(_on_line(*points))
    return list(_solutions(equations, points))


def _of_line(edge: Edge) -> Equation:
    """Equate r with the distance in front of the line."""
    length = Surd.root(edge.squared_length).rational
    if length is None:
        raise ValueError("an edge has an irrational length")
    (dx, dy), (ax, ay) = edge.along, edge.a
    return dy / length, -dx / length, Fraction(-1), (dy * ax - dx * ay) / length


def _half_way(p: Point, q: Point) -> Equation:
    square = (q[0] ** 2 + q[1] ** 2 - p[0] ** 2 - p[1] ** 2) / 2
    return q[0] - p[0], q[1] - p[1], Fraction(0), square


def _in_front(edge: Edge, point: Point) -> Equation:
    (dx, dy), (x, y) = edge.along, point
    return dx, dy, Fraction(0), dx * x + dy * y


def _on_line(p: Point, q: Point) -> Equation:
    dx, dy = q[0] - p[0], q[1] - p[1]
    return dy, -dx, Fraction(0), dy * p[0] - dx * p[1]


def _height(edge: Edge, point: Point) -> Fraction:
    (dx, dy), (ax, ay) = edge.along, edge.a
    return dy * (point[0] - ax) - dx * (point[1] - ay)


def _solutions(equations: Sequence[Equation], points: Sequence[Point]) -> Iterator[Place]:
    base, free = _solved(equations)
    if not free:
        yield Surd(base[0]), Surd(base[1])
        return
    if len(free) > 1 or not points:
        raise NotSingled("its features single out no place")
    # On the line base + t way: points at distance r from a vertex.
    way, (px, py) = free[0], points[0]
    w = base[0] - px, base[1] - py, base[2]
    a, b, c = (u[0] * v[0] + u[1] * v[1] - u[2] * v[2] for u, v in ((way, way), (w, way), (w, w)))
    if a == 0:
        ts = [Surd(-c / (2 * b))] if b else []
    elif b * b < a * c:
        ts = []
    else:
        root = Surd.root(b * b - a * c)
        ts = [Surd((-b + s * root.a) / a, s * root.b / a, root.d) for s in (1, -1)]
    for t in ts:
        x, y = (Surd(base[k]) + t.times(way[k]) for k in (0, 1))
        yield x, y


def _solved(equations: Sequence[Equation]) -> tuple[list[Fraction], list[list[Fraction]]]:
    """Solve for x, y, r: a solution, and the directions in which more solutions lie. Raises
    NotSingled without any solution."""
    rows: list[list[Fraction]] = []
    pivots: list[int] = []
    for equation in equations:
        row = list(equation)
        for known, pivot in zip(rows, pivots, strict=True):
            row = [x - row[pivot] * y for x, y in zip(row, known, strict=True)]
        pivot_here = next((k for k in range(3) if row[k]), None)
        if pivot_here is None:
            if row[3]:
                raise NotSingled("no place is as far from its features")
            continue
        row = [x / row[pivot_here] for x in row]
        for k, known in enumerate(rows):
            rows[k] = [x - known[pivot_here] * y for x, y in zip(known, row, strict=True)]
        rows.append(row)
        pivots.append(pivot_here)
    base = [Fraction(0)] * 3
    for row, pivot in zip(rows, pivots, strict=True):
        base[pivot] = row[3]
    free = []
    for k in range(3):
        if k not in pivots:
            way = [Fraction(int(j == k)) for j in range(3)]
            for row, pivot in zip(rows, pivots, strict=True):
                way[pivot] = -row[k]
            free.append(way)
    return base, free
