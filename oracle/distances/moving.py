"""The distance of a part on a path and obstacles, at one scale, in fractions."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from .segments import Point, Ring, Segment, edges_of, is_inside, legs_of, squared_between


def squared_distance_on_path(
    part: Sequence[Ring], obstacles: Sequence[Ring], path: Sequence[Point], scale: Fraction
) -> Fraction:
    """Return the least squared distance of x + scale part and the obstacles over all places x of
    the path, 0 if they meet: an edge of each is as far as x is from a parallelogram."""
    grown = [[(scale * x, scale * y) for x, y in ring] for ring in part]
    if _one_holds_other(grown, obstacles, path[0]):
        return Fraction(0)
    own = [edge for ring in grown for edge in edges_of(ring)]
    others = [edge for ring in obstacles for edge in edges_of(ring)]
    return min(
        _from_parallelogram(leg, mine, other)
        for leg in legs_of(path)
        for mine in own
        for other in others
    )


def squared_distance_inside(
    part: Sequence[Ring], container: Sequence[Ring], place: Point, scale: Fraction
) -> Fraction:
    """Return the squared distance of place + scale part from a container's boundary, 0 unless the
    part lies inside."""
    placed = [[(place[0] + scale * x, place[1] + scale * y) for x, y in ring] for ring in part]
    if not is_inside(container, placed[0][0]):
        return Fraction(0)
    if any(is_inside(placed, ring[0]) for ring in container):
        return Fraction(0)
    walls = [edge for ring in container for edge in edges_of(ring)]
    return min(
        squared_between(edge, wall) for ring in placed for edge in edges_of(ring) for wall in walls
    )


def _one_holds_other(part: Sequence[Ring], obstacles: Sequence[Ring], at: Point) -> bool:
    """Tell whether a ring of either set has a vertex inside of the other one, at a place."""
    placed = [[(at[0] + x, at[1] + y) for x, y in ring] for ring in part]
    return any(is_inside(obstacles, ring[0]) for ring in placed) or any(
        is_inside(placed, ring[0]) for ring in obstacles
    )


def _from_parallelogram(leg: Segment, mine: Segment, other: Segment) -> Fraction:
    """Return the squared distance of the leg from all y - m, for y and m of the two edges."""
    a, b, c, d = ((y[0] - m[0], y[1] - m[1]) for m in mine for y in other)
    corners = [a, b, d, c]
    if _is_inside_convex(corners, leg[0]):
        return Fraction(0)
    return min(squared_between(leg, side) for side in edges_of(corners))


def _is_inside_convex(corners: Ring, p: Point) -> bool:
    turns = set()
    for (ax, ay), (bx, by) in edges_of(corners):
        turn = (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax)
        turns.add((turn > 0) - (turn < 0))
    return turns in ({1}, {-1})
