"""Shapes with merge trees known by hand."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from minkref import PolygonSet

Point = tuple[Any, Any]
Ring = Sequence[Point]
Shape = list[list[Ring]]  # polygons: an outer ring, then holes
HALF = Fraction(1, 2)


def made(shape: Shape, move: Callable[[Any, Any], Point] = lambda x, y: (x, y)) -> PolygonSet:
    """A set, moved point by point."""
    return PolygonSet([[[move(x, y) for x, y in ring] for ring in rings] for rings in shape])


def box(x: Any, y: Any, width: Any, height: Any) -> Ring:
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def slot(width: Any, depth: Any) -> Shape:
    """A block with a slot from above, whose bottom has square corners."""
    return [[[(0, 0), (4 + width, 0), (4 + width, depth + 1), (2 + width, depth + 1),
              (2 + width, 1), (2, 1), (2, depth + 1), (0, depth + 1)]]]  # fmt: skip


def with_hole(*holes: Ring) -> Shape:
    """A wide square with holes."""
    return [[box(-100, -100, 200, 200), *holes]]


#: The vertices (±16, ±63), (±63, ±16), ...: on a circle of radius 65, symmetric, not regular.
OCTAGON: Ring = [(63, 16), (16, 63), (-16, 63), (-63, 16), (-63, -16), (-16, -63), (16, -63),
                 (63, -16)]  # fmt: skip
TIP_TO_TIP: Shape = [[[(-3, -3), (0, 0), (-3, 3)]], [[(2, 0), (5, -3), (5, 3)]]]
FLAT_TIPS: Shape = [
    [[(0, -HALF), (0, HALF), (-4, 6), (-4, -6)]],
    [[(2, HALF), (2, -HALF), (6, -6), (6, 6)]],
]
#: Parallel walls at the distance 2, one twice as long.
CORRIDOR: Shape = [[box(0, 0, 8, 1)], [box(2, 3, 4, 1)]]
#: Two squares that touch at a corner: two wedges of a quarter turn.
CORNER_TO_CORNER: Shape = [[box(0, 0, 2, 2)], [box(2, 2, 2, 2)]]
#: Three blocks around a bay in the shape of a T.
BAY_OF_THREE: Shape = [[box(0, 0, 10, 2)], [box(0, 8, 4, 2)], [box(6, 8, 4, 2)]]
