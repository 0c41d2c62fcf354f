"""The convolution at one scale, as places: what overlaps, runs back on itself, or winds. Exact."""

from __future__ import annotations

import json
from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any

from minkref import _core
from minkref.certify.case_text import ring_numbers
from minkref.certify.plane.coincidence import Edge, ends_of
from minkref.certify.plane.predicate import Place, Vertices

Segment = tuple[Place, Place]
Window = tuple[Fraction, Fraction, Fraction, Fraction]  # the least x and y, the greatest


class ConvolutionAt:
    """The convolution of two operands at a scale."""

    def __init__(
        self, P: _core.PolygonSet, Q: _core.PolygonSet, vertices: Vertices, scale: Fraction
    ) -> None:
        self.P, self.Q, self.vertices, self.scale = P, Q, vertices, scale
        self._rings = ring_numbers(P), ring_numbers(Q)

    def reduced(self) -> list[Segment]:
        """The edges of the reduced convolution."""
        return [self.ends(edge) for edge in _core.reduced_convolution(self.P, self.Q)]

    def full(self) -> list[Segment]:
        """The full convolution's segments, directed like its cycles: backwards where the sign is
        negative."""
        edges = _core.full_convolution(self.P, self.Q)
        return [self.ends(e) if e[1] > 0 else self.ends(e)[::-1] for e in edges]

    def ends(self, edge: Edge) -> Segment:
        a, b = (self.vertices.at(end, self.scale) for end in ends_of(edge, self._rings))
        return a, b

    def overlaps(self) -> bool:
        """Whether two edges of the reduced convolution share a segment."""
        lines: dict[Any, list[tuple[Fraction, Fraction]]] = {}
        for a, b in self.reduced():
            line, low, high = _on_line(a, b)
            lines.setdefault(line, []).append((low, high))
        return any(
            second[0] < first[1]
            for spans in lines.values()
            for first, second in pairwise(sorted(spans))
        )

    def runs_back(self) -> bool:
        """Whether a segment of the full convolution comes to a point and another leaves it by the
        same way."""
        segments = self.full()
        leaving: dict[Place, list[Place]] = {}
        for a, b in segments:
            leaving.setdefault(a, []).append((b[0] - a[0], b[1] - a[1]))
        for a, b in segments:
            back = a[0] - b[0], a[1] - b[1]
            for d in leaving.get(b, []):
                if back[0] * d[1] == back[1] * d[0] and back[0] * d[0] + back[1] * d[1] > 0:
                    return True
        return False

    def wound_zero_times(self) -> Place | None:
        """Finds a point inside the sum around which the full convolution winds zero times. None
        exists unless a hole of one operand has room for the other operand: elsewhere the winding
        number, which equals components minus holes of the intersection of sP and x - Q, is
        positive."""
        windows = list(self._windows())
        if not windows:
            return None
        segments = self.full()
        for x in _between(_abscissas(segments), windows):
            for y in _wound_zero_times(segments, x):
                inside = any(w[0] < x < w[2] and w[1] < y < w[3] for w in windows)
                if inside and self._contact(x, y) == "overlapping":
                    return x, y
        return None

    def _contact(self, x: Fraction, y: Fraction) -> str:
        answer = _core.decide(self.P, self.Q, str(self.scale), str(x), str(y))
        return str(answer["contact"])

    def _windows(self) -> Iterator[Window]:
        """Yields ranges for x in which the box of one operand's hole lies inside the other's
        box."""
        P = _boxes(self.P, self.scale)
        Q = _boxes(self.Q, Fraction(1))
        for (_, holes), (outers, _) in ((P, Q), (Q, P)):
            for h in holes:
                for o in outers:
                    window = h[2] + o[0], h[3] + o[1], h[0] + o[2], h[1] + o[3]
                    if window[0] < window[2] and window[1] < window[3]:
                        yield window


def _boxes(operand: _core.PolygonSet, factor: Fraction) -> tuple[list[Window], list[Window]]:
    """Returns the boxes of outer rings, and of holes."""

    def box(ring: list[list[str]]) -> Window:
        xs, ys = ([factor * Fraction(p[i]) for p in ring] for i in (0, 1))
        return min(xs), min(ys), max(xs), max(ys)

    polygons = json.loads(operand.to_json())["polygons"]
    return [box(p["outer"]) for p in polygons], [box(h) for p in polygons for h in p["holes"]]


def _on_line(a: Place, b: Place) -> tuple[Any, Fraction, Fraction]:
    """Returns the line, equal for all its segments, and the segment's bounds on the line."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    if dx == 0:
        return (None, a[0]), min(a[1], b[1]), max(a[1], b[1])
    slope = dy / dx
    return (slope, a[1] - slope * a[0]), min(a[0], b[0]), max(a[0], b[0])


def _abscissas(segments: list[Segment]) -> list[Fraction]:
    """Returns the abscissas of ends and crossings, sorted."""
    found = {p[0] for segment in segments for p in segment}
    spans = [
        (min(a[0], b[0]), max(a[0], b[0]), min(a[1], b[1]), max(a[1], b[1])) for a, b in segments
    ]
    for i, j in combinations(range(len(segments)), 2):
        u, v = spans[i], spans[j]
        if u[0] >= v[1] or v[0] >= u[1] or u[2] > v[3] or v[2] > u[3]:
            continue
        (a, b), (c, d) = segments[i], segments[j]
        w = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0])
        if w != 0:
            t = ((c[0] - a[0]) * (d[1] - c[1]) - (c[1] - a[1]) * (d[0] - c[0])) / w
            if 0 < t < 1:
                found.add(a[0] + t * (b[0] - a[0]))
    return sorted(found)


def _between(abscissas: list[Fraction], windows: list[Window]) -> Iterator[Fraction]:
    for low, high in pairwise(abscissas):
        middle = (low + high) / 2
        if any(w[0] < middle < w[2] for w in windows):
            yield middle


def _wound_zero_times(segments: list[Segment], x: Fraction) -> Iterator[Fraction]:
    """Yields ordinates at x with winding number zero, one for each gap between neighbouring
    crossings."""
    crossed: list[tuple[Fraction, int]] = []
    for a, b in segments:
        if min(a[0], b[0]) < x < max(a[0], b[0]):
            y = a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0])
            crossed.append((y, 1 if b[0] > a[0] else -1))
    winding = 0
    for (low, turn), (high, _) in pairwise(sorted(crossed)):
        winding += turn
        if winding == 0 and low < high:
            yield (low + high) / 2
