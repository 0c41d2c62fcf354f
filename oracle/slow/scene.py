"""The union of the sums t + (s Σ + -R) of many copies of shapes Σ, from its definition.

One frame holds the pieces of all placed shapes beside the pieces of the turned robot, so the union
of the sums of all pairs of pieces is the scene's union. Pieces of two copies may overlap: the union
asks nothing about them. Seams between copies need no care beside a robot with an area: where two
shapes abut, the sums of their interiors with the robot's interior overlap.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import lcm

from .exact import InputError, Point, Vector
from .frame import Face, Frame
from .minkowski import Sum, checked_frame, sum_of
from .operand import Operand, Polygon
from .pieces import Shape, common_denominator, shape_of
from .state import state

Copy = tuple[Operand, Fraction, Point]  # shape, scale, place
ORIGIN = Operand([], [(Fraction(0), Fraction(0))])
ONE = Fraction(1)


@dataclass
class SceneFrame(Frame):
    """A frame whose first operand has pieces with an area and pieces without."""

    def flat_passages(self) -> list[tuple[Vector, Face, Face]]:
        if self.Q.is_flat:
            return super().flat_passages()
        flat = [piece for piece in self.P.pieces if len(piece.points) < 3]
        return Frame(Shape(flat, [], self.P.unit, bool(flat)), self.Q).flat_passages()


def scene_sum(robot: Operand, copies: Sequence[Copy]) -> Sum:
    """Compute the closed union of the sums of all copies and the turned robot, and its tight
    passages. A robot without area meets the obstacles as one regular set, so shapes that abut leave
    no seam open. InputError for a scale that is not positive, for a copy without area beside such a
    robot, or crossing rings. Exact. Cost: as a sum of all copies together."""
    if any(scale <= 0 for _, scale, _ in copies):
        raise InputError("a scale is positive")
    turned = moved(robot, Fraction(-1), (Fraction(0), Fraction(0)))
    placed = [moved(*copy) for copy in copies if not copy[0].is_empty]
    if not turned.ends:
        return union(placed, turned)
    if any(operand.ends for operand in placed):
        raise InputError("only one of robot and shape may be a point or a segment")
    obstacles = Operand(union(placed, ORIGIN).polygons, [])
    found = sum_of(state(checked_frame(obstacles, turned, ONE), ONE))
    # The interior of the obstacles plus a point is the interior of the sum.
    tight = [] if len(turned.ends) == 1 else found.tight
    return Sum(found.polygons, found.components, found.holes, found.area, found.digest, tight)


def union(placed: Sequence[Operand], turned: Operand) -> Sum:
    """Unite the sums of the placed shapes and the turned robot."""
    unit = lcm(1, *(common_denominator(operand) for operand in (*placed, turned)))
    shapes = [shape_of(operand, unit) for operand in placed]
    pieces = [piece for shape in shapes for piece in shape.pieces]
    diagonals = [diagonal for shape in shapes for diagonal in shape.diagonals]
    frame = SceneFrame(Shape(pieces, diagonals, unit, False), shape_of(turned, unit))
    return sum_of(state(frame, ONE))


def moved(operand: Operand, scale: Fraction, place: Point) -> Operand:
    """Scale about the origin, by -1 for a half turn, then move."""

    def ring(points: Sequence[Point]) -> list[Point]:
        return [(scale * x + place[0], scale * y + place[1]) for x, y in points]

    polygons = [Polygon(ring(p.outer), [ring(hole) for hole in p.holes]) for p in operand.polygons]
    return Operand(polygons, ring(operand.ends))
