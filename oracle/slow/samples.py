"""Rational points inside components at a scale, and their components just below or above.

A point in the sum of the interiors stays there, with a ball around it, at all nearby scales, and so
does a point in the sum's complement. So a sample off all boundary edges, tight segments and tight
points at the scale lies inside one component just below and one just above, and no boundary comes
close.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from .exact import Point, Vector, cross
from .germ import Side
from .plane import Edge, Node, Plane
from .state import State
from .walks import Component


def sample(
    plane: Plane, part: Component, edges: Sequence[Edge], unit: int, avoided: Sequence[Node]
) -> Point:
    """Find a point in the component: start at the middle of an outer edge and go left half way to
    the next edge, or a smaller share if `avoided` has that point. `edges` must contain the
    component's edges, cut at all nodes."""
    start = part.outer[0]
    x, y, den = plane.middle(start)
    middle = (Fraction(x, den), Fraction(y, den))
    way = (-start.d[1], start.d[0])
    first = min(hits(plane, middle, way, edges))
    taken = {
        (Fraction(x, den), Fraction(y, den)) for x, y, den in map(plane.points.__getitem__, avoided)
    }
    # Tries one more share than the number of points to avoid.
    for share in range(2, len(taken) + 3):
        point = (middle[0] + first * way[0] / share, middle[1] + first * way[1] / share)
        if point not in taken:
            return point[0] / unit, point[1] / unit
    raise AssertionError("more places taken than there are points")


def hits(plane: Plane, middle: Point, way: Vector, edges: Sequence[Edge]) -> Iterator[Fraction]:
    """Yield the parameters t > 0 where middle + t way hits an edge."""
    mx, my = middle
    level = way[0] * my - way[1] * mx  # cross(way, x) on the ray
    for edge in edges:
        turn = cross(edge.d, way)
        ends = [plane.points[node] for node in (edge.start, edge.end)]
        sides = [way[0] * y - way[1] * x - level * den for x, y, den in ends]
        if turn == 0:
            # The ray hits an edge along its line at an end.
            if sides[0] == 0:
                norm = way[0] ** 2 + way[1] ** 2
                for x, y, den in ends:
                    t = ((Fraction(x, den) - mx) * way[0] + (Fraction(y, den) - my) * way[1]) / norm
                    if t > 0:
                        yield t
        elif (sides[0] <= 0 <= sides[1]) or (sides[1] <= 0 <= sides[0]):
            t = (edge.offset - (edge.d[0] * my - edge.d[1] * mx)) / Fraction(turn)
            if t > 0:
                yield t


def place_of(state: State, parts: list[Component], point: Point) -> int | None:
    """Return the component that holds a sample, or None."""
    x, y = point[0] * state.side.unit, point[1] * state.side.unit
    for index, part in enumerate(parts):
        rings = (part.outer, *part.holes)
        if sum(holds(state.outline.plane, state.side, ring, x, y) for ring in rings) % 2:
            return index
    return None


def holds(plane: Plane, side: Side, ring: list[Edge], x: Fraction, y: Fraction) -> bool:
    """Tell whether the ring surrounds the sample: counts the edges below by leading coefficients.

    Compares x as germs. An edge below or above has the sample strictly on one side, already by the
    leading coefficient, since no edge comes close.
    """

    def is_left(edge: Edge) -> bool:
        a, _, den = plane.points[edge.start]
        low, high = side.coefficients(a)
        return (low, high) <= (x * den, 0)

    lefts = [is_left(edge) for edge in ring]
    odd = False
    for index, edge in enumerate(ring):
        if lefts[index] != lefts[(index + 1) % len(ring)]:
            level = edge.d[0] * y - edge.d[1] * x - side.coefficients(edge.offset)[0]
            assert level != 0, "an edge comes close to a sample"
            odd ^= (level > 0) == (edge.d[0] > 0)
    return odd
