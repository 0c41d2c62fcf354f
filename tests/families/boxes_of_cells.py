"""Sums of polycubes as unions of boxes, on a grid of all box coordinates, at any scale."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from fractions import Fraction
from itertools import product
from math import prod

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.cells import cells_of
from minkref.oracle.slow import of_faces
from minkref.oracle.slow.space.solid_cells import side

Place = tuple[Fraction, Fraction, Fraction]
Cell = tuple[int, int, int]
MOST_PAIRS, MOST_CELLS = 3000, 30_000


def sum_by_boxes(P: Polyhedron, Q: Polyhedron, s: Fraction) -> str | None:
    """The canonical text; None if an operand is no polycube, or the grid is too large."""
    try:
        first, second = cells_of(P), cells_of(Q)
    except ValueError:
        return None
    if not 0 < len(first) * len(second) <= MOST_PAIRS:
        return None
    corners = {tuple(s * a + b for a, b in zip(p, q, strict=True)) for p in first for q in second}
    stops = [sorted({c[k] + d for c in corners for d in (0, s + 1)}) for k in range(3)]
    if len(stops[0]) * len(stops[1]) * len(stops[2]) > MOST_CELLS:
        return None
    cells: set[Cell] = set()
    for corner in corners:
        ranges = [
            range(bisect_left(stops[k], corner[k]), bisect_left(stops[k], corner[k] + s + 1))
            for k in range(3)
        ]
        cells |= set(product(*ranges))  # type: ignore[arg-type]
    return of_faces(_rims(cells, stops)).text()


def _rims(cells: set[Cell], stops: list[list[Fraction]]) -> Iterator[list[Place]]:
    """Rectangles from the sides of cells with no cell beyond, those in a row taken together,
    counter-clockwise seen from outside."""
    for axis, step in product(range(3), (0, 1)):
        u = (axis + 1) % 3
        bare = {cell for cell in cells if _next(cell, axis, 2 * step - 1) not in cells}
        for cell in bare:
            if _next(cell, u, -1) in bare:
                continue
            last = cell
            while _next(last, u, 1) in bare:
                last = _next(last, u, 1)
            ring = []
            for corner in side(cell, axis, step):
                at_end = corner[u] > cell[u]
                ring.append(_place(stops, _next(corner, u, last[u] - cell[u] if at_end else 0)))
            yield ring


def _next(cell: Cell, axis: int, steps: int) -> Cell:
    x, y, z = (c + steps * (k == axis) for k, c in enumerate(cell))
    return x, y, z


def _place(stops: list[list[Fraction]], corner: Cell) -> Place:
    x, y, z = (stops[k][corner[k]] for k in range(3))
    return x, y, z


def euler_by_points(P: Polyhedron, Q: Polyhedron, s: Fraction, x: Place) -> int:
    """The Euler characteristic of the intersection of sP and x - Q, both polycubes: tests whether a
    point of each open cell, square, edge and vertex of a grid lies in both."""
    first = [tuple((s * c, s * c + s) for c in cell) for cell in cells_of(P)]
    second = [tuple((x[k] - c - 1, x[k] - c) for k, c in enumerate(cell)) for cell in cells_of(Q)]
    stops = [sorted({end for box in (*first, *second) for end in box[k]}) for k in range(3)]
    total = 0
    # A point on a stop is a part of dimension 0 along the axis, a point between stops of dimension
    # 1.
    places = [
        [(stop, 1) for stop in stops[k]]
        + [((a + b) / 2, -1) for a, b in zip(stops[k], stops[k][1:], strict=False)]
        for k in range(3)
    ]
    having = [
        [[{n for n, box in enumerate(boxes) if box[k][0] <= at <= box[k][1]} for at, _ in places[k]]
         for k in range(3)]
        for boxes in (first, second)
    ]  # fmt: skip
    for place in product(*(range(len(places[k])) for k in range(3))):
        if all(set.intersection(*(sets[k][place[k]] for k in range(3))) for sets in having):
            total += prod(places[k][place[k]][1] for k in range(3))
    return total
