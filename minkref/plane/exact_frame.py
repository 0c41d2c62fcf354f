"""Sets of any size, fitted to a picture's frame: moved and scaled exactly, then rounded to
doubles."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.exact import rounded

Exact = tuple[Fraction, Fraction]
ExactPolygons = list[list[list[Exact]]]  # per polygon: outer ring, holes
ExactBox = tuple[Fraction, Fraction, Fraction, Fraction]  # left, bottom, right, top
Ring = list[tuple[float, float]]
Polygons = list[list[Ring]]


def exact_polygons(region: _core.PolygonSet) -> ExactPolygons:
    """List a set's rings; a point or a segment gives a ring of one or two points."""
    return [
        [
            [(Fraction(x), Fraction(y)) for x, y in ring]
            for ring in (polygon["outer"], *polygon["holes"])
        ]
        for polygon in json.loads(_core.write(region, "json"))["polygons"]
    ]


def box_of(polygons: ExactPolygons) -> ExactBox | None:
    """Return the bounding box; None for the empty set."""
    outer = [point for polygon in polygons for point in polygon[0]]
    if not outer:
        return None
    xs, ys = zip(*outer, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def box_text(box: ExactBox) -> str:
    """Write a box as `x 0 to 7/5, y -1 to 1`; rounds long numbers."""
    left, bottom, right, top = (_short(str(number)) for number in box)
    return f"x {left} to {right}, y {bottom} to {top}"


def _short(number: str) -> str:
    if len(number) <= 9:
        return number
    return rounded(number, 6)


@dataclass(frozen=True)
class Frame:
    """A frame: `left` and `bottom` become 0, and `factor` multiplies lengths."""

    left: Fraction
    bottom: Fraction
    factor: Fraction

    def polygons(self, exact: ExactPolygons) -> Polygons:
        """Return the rings, with each number rounded once."""
        return [[self.ring(ring) for ring in polygon] for polygon in exact]

    def ring(self, ring: Sequence[Exact]) -> Ring:
        return [
            (float((x - self.left) * self.factor), float((y - self.bottom) * self.factor))
            for x, y in ring
        ]


def fitted(box: ExactBox, width: int, height: int) -> Frame:
    """Fit the box into `width` by `height`, as large as possible; a point gets the factor 1."""
    left, bottom, right, top = box
    factors = [
        room / length for room, length in ((width, right - left), (height, top - bottom)) if length
    ]
    return Frame(left, bottom, min(factors, default=Fraction(1)))
