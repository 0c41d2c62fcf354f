"""The Euler characteristic of the intersection of two polycubes. For `sP` and `x - Q` it equals the
full convolution's winding number around x, in space (docs/space-sums.md)."""

from __future__ import annotations

from bisect import bisect_left
from fractions import Fraction
from itertools import product

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.cells import cells_of

Box = tuple[Point, Point]


def euler_of_meeting(P: Polyhedron, Q: Polyhedron, s: Fraction, x: Point) -> int | None:
    """Returns the characteristic for closed `sP` and `x - Q`; None unless both are polycubes.
    Exact."""
    if P.is_thin or Q.is_thin:
        return None
    try:
        first, second = cells_of(P), cells_of(Q)
    except ValueError:
        return None
    boxes_P = [_box(cell, s) for cell in sorted(first)]
    boxes_Q = [_mirrored(_box(cell, Fraction(1)), x) for cell in sorted(second)]
    stops = [sorted({end[k] for box in (*boxes_P, *boxes_Q) for end in box}) for k in range(3)]
    parts = _parts(boxes_P, stops) & _parts(boxes_Q, stops)
    return sum(-1 if sum(part) % 2 else 1 for part in parts)


def _box(cell: tuple[int, int, int], s: Fraction) -> Box:
    x, y, z = (s * number for number in cell)
    return (x, y, z), (x + s, y + s, z + s)


def _mirrored(box: Box, x: Point) -> Box:
    low, high = box
    a, b, c = (x[k] - high[k] for k in range(3))
    u, v, w = (x[k] - low[k] for k in range(3))
    return (a, b, c), (u, v, w)


def _parts(boxes: list[Box], stops: list[list[Fraction]]) -> set[tuple[int, ...]]:
    """The grid's open cells, squares, edges and vertices whose union equals the closed boxes."""
    found: set[tuple[int, ...]] = set()
    for low, high in boxes:
        spans = []
        for k in range(3):
            first, last = (bisect_left(stops[k], end[k]) for end in (low, high))
            spans.append(range(2 * first, 2 * last + 1))
        found |= set(product(*spans))
    return found
