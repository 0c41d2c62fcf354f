"""The largest scale for a path by sums at single scales: CGAL's sum of each obstacle and the turned
part, a test of the path against each sum in plain fractions, and a bisection. Shares nothing with
the reference. Bisection is right if smaller parts pass, too: for parts star-shaped about their
origin."""

from __future__ import annotations

import json
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from typing import Any

from minkref import _core
from minkref.fuzz.cgal.oracle import CgalOracle
from minkref.fuzz.geometry.plane import Point, Shape, contains, crossing, in_box, read_shape, turn

Box = tuple[Fraction, Fraction, Fraction, Fraction]


class NoSum(RuntimeError):
    """CGAL gave none."""


@dataclass
class PathBySums:
    """`cgal_seconds` counts CGAL's function only; `path_seconds` the tests of the path against its
    sums."""

    part: _core.PolygonSet
    obstacles: _core.PolygonSet
    path: Sequence[Point]
    oracle: CgalOracle
    sums: int = 0
    scales: int = 0
    cgal_seconds: float = 0.0
    path_seconds: float = 0.0
    _each: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        polygons: list[Any] = json.loads(self.obstacles.to_json())["polygons"]
        self._each = [json.dumps({"polygons": [polygon]}) for polygon in polygons]

    def bracket(self, low: Fraction, high: Fraction, width: Fraction) -> tuple[Fraction, Fraction]:
        """Returns a valid scale and an invalid scale, at most `width` apart, from a bracket whose
        low end is valid and whose high end is not. Raises NoSum."""
        while high - low > width:
            middle = (low + high) / 2
            if self.passes(middle):
                low = middle
            else:
                high = middle
        return low, high

    def passes(self, scale: Fraction) -> bool:
        """Whether no place on the path lies inside a sum: contact is allowed. Makes all sums, as
        for a picture of the places; sums for separate obstacles need no union."""
        self.scales += 1
        turned = self.part.scaled(str(-scale)).to_json()
        passed = True
        for obstacle in self._each:
            answer = self.oracle.sum(turned, obstacle)
            if answer.status != "result" or answer.rings_json is None:
                raise NoSum(f"{answer.status}: {answer.reason}")
            self.sums += 1
            self.cgal_seconds += answer.seconds or 0.0
            began = time.perf_counter()
            passed = passed and avoids(self.path, read_shape(answer.rings_json))
            self.path_seconds += time.perf_counter() - began
        return passed


def avoids(path: Sequence[Point], shape: Shape) -> bool:
    """Whether no point on a polyline lies in a set's interior. Exact."""
    edges = [(a, b) for polygon in shape for ring in polygon for a, b in _sides(ring)]
    box = _box([a for a, _ in edges])
    places = [path[0], *path] if len(path) == 1 else list(path)
    for a, b in pairwise(places):
        if _apart(_box([a, b]), box):
            continue
        cuts = {a, b}
        near = _box([a, b])
        for c, d in edges:
            if not _apart(near, _box([c, d])):
                cuts |= _meetings(a, b, c, d)
        ordered = sorted(cuts)
        middles = [
            (Fraction(p[0] + q[0]) / 2, Fraction(p[1] + q[1]) / 2) for p, q in pairwise(ordered)
        ]
        for place in (*ordered, *middles):
            on_side = any(turn(c, d, place) == 0 and in_box(c, d, place) for c, d in edges)
            if not on_side and contains(shape, place):
                return False
    return True


def _sides(ring: Sequence[Point]) -> list[tuple[Point, Point]]:
    return list(zip(ring, [*ring[1:], ring[0]], strict=True))


def _meetings(a: Point, b: Point, c: Point, d: Point) -> set[Point]:
    """Points where two segments meet: one point, or the ends of their overlap."""
    found = {p for p in (c, d) if turn(a, b, p) == 0 and in_box(a, b, p)}
    if turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0:
        found.add(crossing(a, b, c, d))
    return found


def _box(points: Sequence[Point]) -> Box:
    xs, ys = [Fraction(x) for x, _ in points], [Fraction(y) for _, y in points]
    return min(xs), min(ys), max(xs), max(ys)


def _apart(a: Box, b: Box) -> bool:
    return a[2] < b[0] or b[2] < a[0] or a[3] < b[1] or b[3] < a[1]
