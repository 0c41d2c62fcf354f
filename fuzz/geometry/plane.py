"""The plane in fractions and whole numbers: points, rings, polygon sets and their JSON, membership,
intersection tests, maps, areas and hulls. Exact; imports the standard library only."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any, TypeVar

Number = Fraction | int
One = TypeVar("One", int, Fraction)
Vector = tuple[One, One]
Point = tuple[Number, Number]
Ring = list[Point]  # a corner once, either way around
Polygon = list[Ring]  # the outer ring, then holes
Shape = list[Polygon]
Edge = tuple[Point, Point]
ORIGIN = (Fraction(0), Fraction(0))


def rings_of(polygon: Mapping[str, Any]) -> list[Any]:
    """Returns a polygon's outer ring in the canonical JSON's form, then its holes; as written."""
    return [polygon["outer"], *polygon["holes"]]


def written_rings(text: str) -> list[list[list[str]]]:
    """Returns all rings of a set in the canonical JSON's form, one after another; as written."""
    return [ring for polygon in json.loads(text)["polygons"] for ring in rings_of(polygon)]


def fraction_rings(text: str, factor: Number = 1) -> list[list[Vector[Fraction]]]:
    """The same in fractions, scaled about the origin."""
    return [
        [(factor * Fraction(x), factor * Fraction(y)) for x, y in ring]
        for ring in written_rings(text)
    ]


def scale_factors(scale: str) -> Vector[Fraction]:
    """The factors of the two axes: of `S`, the same for both, or of `SX,SY`."""
    factors = [Fraction(factor) for factor in scale.split(",")]
    x, y = factors * 2 if len(factors) == 1 else factors
    return x, y


def is_uniform(scale: str) -> bool:
    return "," not in scale


def read_shape(text: str, factor: Number | Point = 1, shift: Point = ORIGIN) -> Shape:
    """A set of the canonical JSON's form in fractions, scaled about the origin, perhaps by a factor
    for each axis, and then moved."""
    a, b = factor if isinstance(factor, tuple) else (factor, factor)
    return [
        [
            [(a * Fraction(x) + shift[0], b * Fraction(y) + shift[1]) for x, y in ring]
            for ring in rings_of(polygon)
        ]
        for polygon in json.loads(text)["polygons"]
    ]


def mapped(shape: Shape, change: Callable[[Point], Point]) -> Shape:
    return [[[change(p) for p in ring] for ring in polygon] for polygon in shape]


def scaled(shape: Shape, factor: Number | Point) -> Shape:
    """Scaled about the origin, perhaps by a factor for each axis."""
    a, b = factor if isinstance(factor, tuple) else (factor, factor)
    return mapped(shape, lambda p: (p[0] * a, p[1] * b))


def moved(shape: Shape, dx: Number, dy: Number) -> Shape:
    return mapped(shape, lambda p: (p[0] + dx, p[1] + dy))


def box(x0: Number, y0: Number, width: Number, height: Number) -> Ring:
    return [(x0, y0), (x0 + width, y0), (x0 + width, y0 + height), (x0, y0 + height)]


def extent(ring: Ring) -> tuple[Number, Number, Number, Number]:
    """x, y, width and height of the bounding box."""
    xs, ys = [p[0] for p in ring], [p[1] for p in ring]
    return (min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys))


def plus(a: Vector[One], b: Vector[One]) -> Vector[One]:
    return (a[0] + b[0], a[1] + b[1])


def minus(a: Vector[One], b: Vector[One]) -> Vector[One]:
    return (a[0] - b[0], a[1] - b[1])


def dot(a: Vector[One], b: Vector[One]) -> One:
    return a[0] * b[0] + a[1] * b[1]


def cross(a: Vector[One], b: Vector[One]) -> One:
    return a[0] * b[1] - a[1] * b[0]


def doubled_area(ring: Sequence[Point]) -> Number:
    """Twice the area, positive where the ring runs counter-clockwise."""
    total: Number = 0
    for k, (x, y) in enumerate(ring):
        total += ring[k - 1][0] * y - ring[k - 1][1] * x
    return total


def contains(polygons: Shape, point: Point) -> bool:
    """The point lies in the closed set."""
    y = point[1]
    for polygon in polygons:
        inside = False
        for ring in polygon:
            for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
                a_above, b_above = a[1] > y, b[1] > y
                if (a_above and b_above) or (not a_above and not b_above and a[1] != y != b[1]):
                    continue  # most edges: wholly above or below
                side = turn(a, b, point)
                if side == 0 and in_box(a, b, point):
                    return True
                if a_above != b_above and (side > 0) == (b[1] > a[1]):
                    inside = not inside
        if inside:
            return True
    return False


def meet(first: Shape, second: Shape) -> bool:
    """The two closed sets share a point: their boundaries meet, or one holds a vertex of the
    other."""
    others = sorted(edges(second), key=lambda edge: min(edge[0][0], edge[1][0]))
    for a, b in edges(first):
        right = max(a[0], b[0])
        for c, d in others:
            if min(c[0], d[0]) > right:
                break
            if segments_meet(a, b, c, d):
                return True
    return any(contains(second, polygon[0][0]) for polygon in first) or any(
        contains(first, polygon[0][0]) for polygon in second
    )


def edges(polygons: Shape) -> list[Edge]:
    return [
        (ring[k - 1], ring[k]) for polygon in polygons for ring in polygon for k in range(len(ring))
    ]


def turn(a: Point, b: Point, c: Point) -> int:
    """1 where a, b, c turn to the left, -1 to the right, 0 on one line."""
    value = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (value > 0) - (value < 0)


def hull(points: Iterable[Point]) -> list[Point]:
    """The convex hull, counter-clockwise, without collinear points (Andrew's monotone chain)."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered
    found: list[Point] = []
    for chain in (ordered, ordered[::-1]):
        start = len(found)
        for point in chain:
            while len(found) - start >= 2 and turn(found[-2], found[-1], point) <= 0:
                found.pop()
            found.append(point)
        found.pop()
    return found


def in_box(a: Point, b: Point, p: Point) -> bool:
    """p, known to be on the line a b, lies on the closed segment."""
    return min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])


def segments_meet(a: Point, b: Point, c: Point, d: Point) -> bool:
    """The closed segments a b and c d share a point. Written out: the generators spend most of
    their time here."""
    (ax, ay), (bx, by), (cx, cy), (dx, dy) = a, b, c, d
    ux, uy = bx - ax, by - ay
    t1 = ux * (cy - ay) - uy * (cx - ax)
    t2 = ux * (dy - ay) - uy * (dx - ax)
    if (t1 > 0 and t2 > 0) or (t1 < 0 and t2 < 0):
        return False
    vx, vy = dx - cx, dy - cy
    t3 = vx * (ay - cy) - vy * (ax - cx)
    t4 = vx * (by - cy) - vy * (bx - cx)
    if (t3 > 0 and t4 > 0) or (t3 < 0 and t4 < 0):
        return False
    if t1 and t2 and t3 and t4:
        return True
    return (
        (t1 == 0 and in_box(a, b, c))
        or (t2 == 0 and in_box(a, b, d))
        or (t3 == 0 and in_box(c, d, a))
        or (t4 == 0 and in_box(c, d, b))
    )


def crossing(a: Point, b: Point, c: Point, d: Point) -> Point:
    """Where the line a b crosses the line c d. Not for parallel lines."""
    u, v = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1])
    t = Fraction((c[0] - a[0]) * v[1] - (c[1] - a[1]) * v[0]) / (u[0] * v[1] - u[1] * v[0])
    return (a[0] + t * u[0], a[1] + t * u[1])
