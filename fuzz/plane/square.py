"""Whether a whole square lies inside or outside a sum, in plain Python fractions.

A sum's boundary lies on segments vertex + edge and edge + vertex. Lines through segments that cross
the square cut it into convex cells, each wholly inside or wholly outside: one point decides a cell.
"""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.geometry.plane import (
    ORIGIN,
    Edge,
    Point,
    Shape,
    contains,
    crossing,
    edges,
    hull,
    meet,
    segments_meet,
    turn,
)

MOST_CELLS = 2000
Cell = list[Point]


def clear_of_square(P: Shape, reflected: Shape, half: Fraction, boundary: bool) -> bool:
    """No point within `half` of x, in the maximum norm, lies in the sum, where `reflected` is x -
    Q: P and x - Q are more than `half` apart. With `boundary`, tests the distance of their
    boundaries."""
    others = edges(reflected)
    if any(_near(first, second, half) for first in edges(P) for second in others):
        return False
    if boundary:
        return True
    return not any(contains(reflected, polygon[0][0]) for polygon in P) and not any(
        contains(P, polygon[0][0]) for polygon in reflected
    )


def _near(first: Edge, second: Edge, half: Fraction) -> bool:
    """Whether two segments are at most `half` apart in the maximum norm: the hull of all
    differences of end points, widened by the square, contains the origin."""
    if any(
        max(first[0][k], first[1][k]) + half < min(second[0][k], second[1][k])
        or max(second[0][k], second[1][k]) + half < min(first[0][k], first[1][k])
        for k in (0, 1)
    ):
        return False
    differences = [(a[0] - b[0], a[1] - b[1]) for a in first for b in second]
    corners: Cell = [
        (x + dx, y + dy) for x, y in differences for dx in (-half, half) for dy in (-half, half)
    ]
    return _in_hull(ORIGIN, corners)


def _in_hull(x: Point, points: list[Point]) -> bool:
    around = hull(points)
    return all(turn(around[k - 1], around[k], x) >= 0 for k in range(len(around)))


def square_inside(P: Shape, Q: Shape, x: Point, half: Fraction, boundary: bool) -> bool:
    """Whether the closed square with half side `half` around x lies in the sum of P and Q, or with
    `boundary` in the sum of their boundaries. False also after more than MOST_CELLS cells."""
    low, high = (x[0] - half, x[1] - half), (x[0] + half, x[1] + half)
    cells: list[Cell] = [[low, (high[0], low[1]), high, (low[0], high[1])]]
    for line in _crossing(P, Q, low, high):
        cells = [piece for cell in cells for piece in _cut(cell, line)]
        if len(cells) > MOST_CELLS:
            return False
    return all(_in_sum(P, Q, _centre(cell), boundary) for cell in cells)


def _in_sum(P: Shape, Q: Shape, x: Point, boundary: bool) -> bool:
    reflected = [[[(x[0] - a, x[1] - b) for a, b in ring] for ring in polygon] for polygon in Q]
    if not boundary:
        return meet(P, reflected)
    others = edges(reflected)
    return any(segments_meet(a, b, c, d) for a, b in edges(P) for c, d in others)


def _crossing(P: Shape, Q: Shape, low: Point, high: Point) -> list[Edge]:
    """The segments vertex + edge and edge + vertex that meet the closed square."""
    found = []
    for one, other in ((P, Q), (Q, P)):
        vertices = [vertex for polygon in one for ring in polygon for vertex in ring]
        for a, b in edges(other):
            for v in vertices:
                segment = ((a[0] + v[0], a[1] + v[1]), (b[0] + v[0], b[1] + v[1]))
                if _meets_box(segment, low, high):
                    found.append(segment)
    return found


def _meets_box(segment: Edge, low: Point, high: Point) -> bool:
    a, b = segment
    if any(max(a[k], b[k]) < low[k] or high[k] < min(a[k], b[k]) for k in (0, 1)):
        return False
    corners = (low, (high[0], low[1]), high, (low[0], high[1]))
    sides = {turn(a, b, corner) for corner in corners}
    return a != b and not (sides == {1} or sides == {-1})


def _cut(cell: Cell, line: Edge) -> list[Cell]:
    """Returns both sides of a convex cell; the whole cell if the line misses its inside."""
    a, b = line
    sides = [turn(a, b, corner) for corner in cell]
    if min(sides) >= 0 or max(sides) <= 0:
        return [cell]
    left: Cell = []
    right: Cell = []
    for k, corner in enumerate(cell):
        before, side, last = cell[k - 1], sides[k], sides[k - 1]
        if side * last < 0:
            meeting = crossing(before, corner, a, b)
            left.append(meeting)
            right.append(meeting)
        if side >= 0:
            left.append(corner)
        if side <= 0:
            right.append(corner)
    return [left, right]


def _centre(cell: Cell) -> Point:
    count = len(cell)
    return (sum(x for x, _ in cell) / Fraction(count), sum(y for _, y in cell) / Fraction(count))
