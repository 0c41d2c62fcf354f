"""Steps that make a plane case smaller."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from math import gcd, lcm
from typing import Any

from minkref import _core
from minkref.plane.scaling import PlaneScale, factors_of, read_plane_scale, text_of

Point = tuple[Fraction, Fraction]
Ring = tuple[Point, ...]
Polygon = tuple[Ring, ...]  # outer ring, holes
Operand = tuple[Polygon, ...]


@dataclass(frozen=True)
class PlaneCase:
    P: Operand
    Q: Operand
    scale: PlaneScale

    @cached_property
    def size(self) -> tuple[int, int, int, str]:
        """Vertices first; then holes and polygons; then the numbers' length, where a scale other
        than 1 counts more than its length."""
        text = self.literal
        rings = [ring for operand in (self.P, self.Q) for polygon in operand for ring in polygon]
        length = len(text) + (0 if self.scale == 1 else 40) + 2 * text.count("-")
        length += 20 * text.count("/")
        return (sum(len(ring) for ring in rings), len(rings), length, text)

    @cached_property
    def literal(self) -> str:
        value = {
            "P": plain_operand(self.P),
            "Q": plain_operand(self.Q),
            "scale": text_of(self.scale),
        }
        return json.dumps(value, separators=(",", ":"))

    @staticmethod
    def read(P_json: str, Q_json: str, scale: str) -> PlaneCase:
        return PlaneCase(_operand(P_json), _operand(Q_json), read_plane_scale(scale))

    def valid(self) -> bool:
        for operand in (self.P, self.Q):
            text = json.dumps(_texts(operand))
            try:
                _core.PolygonSet.from_json(text).validate("shrunk")
            except (ValueError, _core.BadInput):
                return False
        return True

    def with_operand(self, which: int, operand: Operand) -> PlaneCase:
        P, Q = (self.P, operand) if which else (operand, self.Q)
        return PlaneCase(P, Q, self.scale)

    @property
    def operands(self) -> tuple[Operand, Operand]:
        return (self.P, self.Q)


def _operand(text: str) -> Operand:
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


def smaller_in_plane(case: PlaneCase) -> Iterator[PlaneCase]:
    """Valid candidates, the boldest first."""
    for candidate in _candidates(case):
        if candidate.size < case.size and candidate.valid():
            yield candidate


def _simpler_scales(scale: PlaneScale) -> Iterator[PlaneScale]:
    """Whole numbers; given a factor for each axis, also either factor for both."""
    whole = [Fraction(round(factor) or 1) for factor in factors_of(scale)]
    yield whole[0] if whole[0] == whole[1] else (whole[0], whole[1])
    if isinstance(scale, tuple):
        yield from scale


def _candidates(case: PlaneCase) -> Iterator[PlaneCase]:
    if case.scale != 1:
        yield PlaneCase(case.P, case.Q, Fraction(1))
        yield PlaneCase(scaled_operand(case.P, case.scale), case.Q, Fraction(1))
        yield from (PlaneCase(case.P, case.Q, scale) for scale in _simpler_scales(case.scale))
    for which, operand in enumerate(case.operands):
        for fewer in (*_fewer_polygons(operand), *_fewer_holes(operand)):
            yield case.with_operand(which, fewer)
    for part in (2, 3, 4):
        for which, operand in enumerate(case.operands):
            for fewer in _without_runs(operand, part):
                yield case.with_operand(which, fewer)
    for which, operand in enumerate(case.operands):
        for fewer in _without_vertices(operand, 1):
            yield case.with_operand(which, fewer)
    yield from _simpler_numbers(case)
    for which, operand in enumerate(case.operands):
        for fewer in _without_vertices(operand, 2):
            yield case.with_operand(which, fewer)
    for which, operand in enumerate(case.operands):
        for moved in _vertices_moved(operand):
            yield case.with_operand(which, moved)


def _fewer_polygons(operand: Operand) -> Iterator[Operand]:
    if len(operand) > 1:
        for polygon in operand:
            yield (polygon,)
        for k in range(len(operand)):
            yield operand[:k] + operand[k + 1 :]


def _fewer_holes(operand: Operand) -> Iterator[Operand]:
    if any(len(polygon) > 1 for polygon in operand):
        yield tuple(polygon[:1] for polygon in operand)
    for i, polygon in enumerate(operand):
        for k in range(1, len(polygon)):
            shorter = polygon[:k] + polygon[k + 1 :]
            yield (*operand[:i], shorter, *operand[i + 1 :])


def _without_runs(operand: Operand, part: int) -> Iterator[Operand]:
    """A half, a third, a quarter of a ring's vertices left out."""
    for i, polygon in enumerate(operand):
        for j, ring in enumerate(polygon):
            count = len(ring) // part
            if count < 2 or len(ring) - count < 3:
                continue
            for k in range(0, len(ring), count):
                yield _replaced(operand, i, j, ring[:k] + ring[k + count :])


def _without_vertices(operand: Operand, count: int) -> Iterator[Operand]:
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


def _moved(operand: Operand, by: Point) -> Operand:
    return _map(operand, lambda p: (p[0] + by[0], p[1] + by[1]))


def vertices_of(operand: Operand) -> list[Point]:
    return [point for polygon in operand for ring in polygon for point in ring]


def _simpler_numbers(case: PlaneCase) -> Iterator[PlaneCase]:
    for which, operand in enumerate(case.operands):
        points = vertices_of(operand)
        if points:
            x, y = min(p[0] for p in points), min(p[1] for p in points)
            yield case.with_operand(which, _moved(operand, (-x, -y)))
    both = vertices_of(case.P) + vertices_of(case.Q)
    if both:
        denominator = lcm(*(number.denominator for point in both for number in point))
        divisor = gcd(*(int(number * denominator) for point in both for number in point))
        if divisor:
            factor = Fraction(denominator, divisor)
            yield PlaneCase(
                scaled_operand(case.P, factor), scaled_operand(case.Q, factor), case.scale
            )
        for unit in (8, 4, 2, 1):
            step = Fraction(unit)
            yield PlaneCase(_rounded(case.P, step), _rounded(case.Q, step), case.scale)
        for factor in (Fraction(1, 16), Fraction(1, 4), Fraction(1, 2)):
            P, Q = scaled_operand(case.P, factor), scaled_operand(case.Q, factor)
            yield PlaneCase(_rounded(P, Fraction(1)), _rounded(Q, Fraction(1)), case.scale)
    for most in (1, 2, 4, 8, 16, 64):
        yield PlaneCase(
            _with_denominators(case.P, most), _with_denominators(case.Q, most), case.scale
        )
        for which, operand in enumerate(case.operands):
            yield case.with_operand(which, _with_denominators(operand, most))
    for which, operand in enumerate(case.operands):
        yield case.with_operand(which, _ranked(operand))
        for axis in (0, 1):
            for gap in _gaps(operand, axis):
                yield case.with_operand(which, _narrowed(operand, axis, *gap))


def _rounded(operand: Operand, step: Fraction) -> Operand:
    return _map(operand, lambda p: (step * round(p[0] / step), step * round(p[1] / step)))


def _with_denominators(operand: Operand, most: int) -> Operand:
    """Each number by the nearest with a denominator of at most `most`."""
    return _map(operand, lambda p: (p[0].limit_denominator(most), p[1].limit_denominator(most)))


def _ranked(operand: Operand) -> Operand:
    """Replaces each coordinate by its rank: the order stays, the numbers become small."""
    points = vertices_of(operand)
    places = [
        {value: Fraction(k) for k, value in enumerate(sorted({p[axis] for p in points}))}
        for axis in (0, 1)
    ]
    return _map(operand, lambda p: (places[0][p[0]], places[1][p[1]]))


def _gaps(operand: Operand, axis: int) -> list[tuple[Fraction, Fraction]]:
    """Where the operand can be made narrower: coordinates with more than 1 to the next."""
    values = sorted({p[axis] for p in vertices_of(operand)})
    return [(a, b - a - 1) for a, b in pairwise(values) if b - a > 1]


def _narrowed(operand: Operand, axis: int, after: Fraction, by: Fraction) -> Operand:
    def image(p: Point) -> Point:
        moved = p[axis] - by if p[axis] > after else p[axis]
        return (moved, p[1]) if axis == 0 else (p[0], moved)

    return _map(operand, image)


def _vertices_moved(operand: Operand) -> Iterator[Operand]:
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
