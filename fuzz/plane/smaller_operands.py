"""Steps that make a set in the plane smaller."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any

from minkref import _core
from minkref.plane.scaling import PlaneScale, factors_of

Point = tuple[Fraction, Fraction]
Ring = tuple[Point, ...]
Polygon = tuple[Ring, ...]  # outer ring, holes
Operand = tuple[Polygon, ...]


def read_operand_text(text: str) -> Operand:
    return tuple(
        tuple(
            tuple((Fraction(x), Fraction(y)) for x, y in ring)
            for ring in (polygon["outer"], *polygon.get("holes", []))
        )
        for polygon in json.loads(text)["polygons"]
    )


def _number(value: Fraction) -> int | str:
    return value.numerator if value.denominator == 1 else str(value)


def plain_operand(operand: Operand) -> dict[str, Any]:
    polygons = []
    for outer, *holes in operand:
        rings = [[[_number(x), _number(y)] for x, y in ring] for ring in (outer, *holes)]
        polygon: dict[str, Any] = {"outer": rings[0]}
        if holes:
            polygon["holes"] = rings[1:]
        polygons.append(polygon)
    return {"polygons": polygons}


def is_valid_operand(operand: Operand) -> bool:
    try:
        _core.PolygonSet.from_json(json.dumps(_texts(operand))).validate("shrunk")
    except (ValueError, _core.BadInput):
        return False
    return True


def _texts(operand: Operand) -> dict[str, Any]:
    return {
        "polygons": [
            {
                "outer": [[str(x), str(y)] for x, y in outer],
                "holes": [[[str(x), str(y)] for x, y in hole] for hole in holes],
            }
            for outer, *holes in operand
        ]
    }


def fewer_polygons(operand: Operand) -> Iterator[Operand]:
    if len(operand) > 1:
        for polygon in operand:
            yield (polygon,)
        for k in range(len(operand)):
            yield operand[:k] + operand[k + 1 :]


def fewer_holes(operand: Operand) -> Iterator[Operand]:
    if any(len(polygon) > 1 for polygon in operand):
        yield tuple(polygon[:1] for polygon in operand)
    for i, polygon in enumerate(operand):
        for k in range(1, len(polygon)):
            shorter = polygon[:k] + polygon[k + 1 :]
            yield (*operand[:i], shorter, *operand[i + 1 :])


def without_runs(operand: Operand, part: int) -> Iterator[Operand]:
    """A half, a third, a quarter of a ring's vertices left out."""
    for i, polygon in enumerate(operand):
        for j, ring in enumerate(polygon):
            count = len(ring) // part
            if count < 2 or len(ring) - count < 3:
                continue
            for k in range(0, len(ring), count):
                yield _replaced(operand, i, j, ring[:k] + ring[k + count :])


def without_vertices(operand: Operand, count: int) -> Iterator[Operand]:
    for i, polygon in enumerate(operand):
        for j, ring in enumerate(polygon):
            if len(ring) - count < 3:
                continue
            for k in range(len(ring)):
                yield _replaced(operand, i, j, (ring[k:] + ring[:k])[count:])


def _replaced(operand: Operand, i: int, j: int, ring: Ring) -> Operand:
    polygon = (*operand[i][:j], ring, *operand[i][j + 1 :])
    return (*operand[:i], polygon, *operand[i + 1 :])


def _map(operand: Operand, image: Callable[[Point], Point]) -> Operand:
    return tuple(
        tuple(tuple(image(point) for point in ring) for ring in polygon) for polygon in operand
    )


def scaled_operand(operand: Operand, factor: PlaneScale) -> Operand:
    x, y = factors_of(factor)
    return _map(operand, lambda p: (x * p[0], y * p[1]))


def moved_operand(operand: Operand, by: Point) -> Operand:
    return _map(operand, lambda p: (p[0] + by[0], p[1] + by[1]))


def vertices_of(operand: Operand) -> list[Point]:
    return [point for polygon in operand for ring in polygon for point in ring]


def rounded_operand(operand: Operand, step: Fraction) -> Operand:
    return _map(operand, lambda p: (step * round(p[0] / step), step * round(p[1] / step)))


def with_denominators(operand: Operand, most: int) -> Operand:
    """Each number by the nearest with a denominator of at most `most`."""
    return _map(operand, lambda p: (p[0].limit_denominator(most), p[1].limit_denominator(most)))


def ranked(operand: Operand) -> Operand:
    """Replaces each coordinate by its rank: the order stays, the numbers become small."""
    points = vertices_of(operand)
    places = [
        {value: Fraction(k) for k, value in enumerate(sorted({p[axis] for p in points}))}
        for axis in (0, 1)
    ]
    return _map(operand, lambda p: (places[0][p[0]], places[1][p[1]]))


def gaps(operand: Operand, axis: int) -> list[tuple[Fraction, Fraction]]:
    """Where the operand can be made narrower: coordinates with more than 1 to the next."""
    values = sorted({p[axis] for p in vertices_of(operand)})
    return [(a, b - a - 1) for a, b in pairwise(values) if b - a > 1]


def narrowed(operand: Operand, axis: int, after: Fraction, by: Fraction) -> Operand:
    def image(p: Point) -> Point:
        moved = p[axis] - by if p[axis] > after else p[axis]
        return (moved, p[1]) if axis == 0 else (p[0], moved)

    return _map(operand, image)


def vertices_moved(operand: Operand) -> Iterator[Operand]:
    """Moves one vertex to the nearest integers, or one step towards zero along x or y."""
    for i, polygon in enumerate(operand):
        for j, ring in enumerate(polygon):
            for k, (x, y) in enumerate(ring):
                for point in dict.fromkeys(_simpler_points(x, y)):
                    if point != (x, y):
                        yield _replaced(operand, i, j, (*ring[:k], point, *ring[k + 1 :]))


def _simpler_points(x: Fraction, y: Fraction) -> Iterator[Point]:
    for most in (1, 2, 4, 8, 16):
        a, b = x.limit_denominator(most), y.limit_denominator(most)
        yield from ((a, b), (a, y), (x, b))
    for step in (10, 1):
        if abs(x) >= step:
            yield (x - step if x > 0 else x + step, y)
        if abs(y) >= step:
            yield (x, y - step if y > 0 else y + step)
