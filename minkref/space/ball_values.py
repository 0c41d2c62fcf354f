"""A ball in space as a value, and what lies between two polyhedral sets."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from minkref import _core
from minkref.argument_types import factors, number, surface_of, whole
from minkref.disc.disc import Disc, read_tolerance
from minkref.disc.disc_index import square_of
from minkref.space.ball import polyhedron_near
from minkref.space.ball_sum import Between, sum_between
from minkref.space.operand import SpaceOperand

Number = str | int | Fraction


@dataclass(frozen=True, init=False)
class Ball:
    """A ball about the origin, given by `radius` > 0 or by the radius's square, which is exact.
    Raises BadInput. docs/space-sums.md."""

    squared_radius: Fraction

    def __init__(self, radius: Number | None = None, squared_radius: Number | None = None) -> None:
        square = Fraction(square_of(radius, squared_radius, "Ball"))
        object.__setattr__(self, "squared_radius", square)

    def __repr__(self) -> str:
        radius = self.disc.radius
        is_root = radius.startswith("sqrt:")
        return f"Ball(squared_radius='{self.squared_radius}')" if is_root else f"Ball('{radius}')"

    def inside(self, tolerance: Number) -> _core.ConvexPolyhedron:
        """Make a convex polyhedron within the ball, no point of the ball farther than `tolerance`
        from the polyhedron. About 5 R / `tolerance` facets. Raises BadInput for too many."""
        return polyhedron_near(self.disc, _within(tolerance), False)

    def around(self, tolerance: Number) -> _core.ConvexPolyhedron:
        """Make a convex polyhedron around the ball, no point of the polyhedron farther than
        `tolerance` from the ball. As inside."""
        return polyhedron_near(self.disc, _within(tolerance), True)

    @property
    def disc(self) -> Disc:
        """The ball as commands know it."""
        return Disc(f"the ball of squared radius {self.squared_radius}", self.squared_radius)


def ball_sum(
    P: _core.Polyhedron | _core.ConvexPolyhedron,
    ball: Ball,
    tolerance: Number,
    scaling: Number | Sequence[Number] = 1,
    threads: int = 1,
) -> Between:
    """Enclose the Minkowski sum of P, scaled about the origin, and a ball: `inner` lies within the
    sum, `outer` contains the sum, and no point of `outer` is farther than twice `tolerance` from
    `inner`. Both are exact sums of polyhedra. P may also be a plane polygon, a segment or a point,
    and is validated first. Takes the time of two sums with polyhedra of about 5 R / `tolerance`
    facets. Raises BadInput, LimitExceeded. docs/space-sums.md, "With a ball"."""
    surface = surface_of("P", P)
    if not isinstance(ball, Ball):
        raise TypeError(f"ball has to be a Ball, and is of type {type(ball).__name__}")
    surface.validate_summand("P")
    operand = SpaceOperand("P", Path(), surface, _body(surface))
    by, count = factors("scaling", scaling), max(1, whole("threads", threads))
    return sum_between(operand, ball.disc, _within(tolerance), by, count)


def _body(surface: _core.Polyhedron) -> _core.ConvexPolyhedron | None:
    """The convex body of a valid surface; None for another shape, and without a volume."""
    if surface.faces < 2:
        return None
    try:
        return _core.ConvexPolyhedron(surface, "P")
    except _core.BadInput as error:
        if error.code != "not-convex":
            raise
        return None


def _within(tolerance: Number) -> Fraction:
    return read_tolerance(number("tolerance", tolerance), "tolerance")
