"""Erosions, openings and closings in space as functions of Python (docs/erosion.md)."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

from minkref import _core
from minkref.argument_types import factors, number, surface_of, text_of, whole
from minkref.disc.disc import read_tolerance
from minkref.errors import Refusal, choice
from minkref.space.ball_sum import Between
from minkref.space.ball_values import Ball
from minkref.space.erosion_between import erosion_between
from minkref.space.general_sum import GENERAL_ROUTES
from minkref.space.operand import SpaceOperand
from minkref.space.remaining import Find, closed, eroded, opened

Number = str | int | Fraction
Solid = _core.Polyhedron | _core.ConvexPolyhedron


def polyhedral_erosion(
    P: Solid,
    Q: Solid,
    scaling: Number | Sequence[Number] = 1,
    route: str = "edges",
    threads: int = 1,
) -> _core.PolyhedralSet:
    """Erode P, scaled about the origin, by Q: the places x at which x + Q lies within P, without
    those that have no volume around them. Exact, in canonical form. P has a volume; Q may also be a
    plane polygon, a segment or a point. Both are validated first. Takes the time of
    `polyhedral_sum` of P's outside and -Q. Raises BadInput, LimitExceeded, Refusal.
    docs/erosion.md, "In space"."""
    return _found(eroded, P, Q, scaling, route, threads)


def polyhedral_opening(
    P: Solid,
    Q: Solid,
    scaling: Number | Sequence[Number] = 1,
    route: str = "edges",
    threads: int = 1,
) -> _core.PolyhedralSet:
    """Open P, scaled about the origin, by Q: the sum of `polyhedral_erosion` and Q, which unites
    all copies of Q within P, but those that just fit. As polyhedral_erosion."""
    return _found(opened, P, Q, scaling, route, threads)


def polyhedral_closing(
    P: Solid,
    Q: Solid,
    scaling: Number | Sequence[Number] = 1,
    route: str = "edges",
    threads: int = 1,
) -> _core.PolyhedralSet:
    """Close P, scaled about the origin, by Q: `polyhedral_sum`, eroded by Q. As
    polyhedral_erosion."""
    return _found(closed, P, Q, scaling, route, threads)


def ball_erosion(
    P: Solid,
    ball: Ball,
    tolerance: Number,
    scaling: Number | Sequence[Number] = 1,
    threads: int = 1,
) -> Between:
    """Enclose the erosion of P, scaled about the origin, by a ball: `inner` lies within the
    erosion, `outer` contains its region. Both are exact erosions, by polyhedra around and inside
    the ball and as near to the ball as `tolerance`. P has a volume, and is validated first. Takes
    the time of two erosions by polyhedra of about 5 R / `tolerance` facets. Raises BadInput,
    LimitExceeded, Refusal. docs/space-sums.md, "With a ball"."""
    if not isinstance(ball, Ball):
        raise TypeError(f"ball has to be a Ball, and is of type {type(ball).__name__}")
    within = read_tolerance(number("tolerance", tolerance), "tolerance")
    by, count = factors("scaling", scaling), max(1, whole("threads", threads))
    return erosion_between(_operand("P", P), ball.disc, within, by, count)


def _found(
    find: Find, P: Solid, Q: Solid, scaling: Number | Sequence[Number], route: str, threads: int
) -> _core.PolyhedralSet:
    by, chosen = factors("scaling", scaling), text_of("route", route)
    count = max(1, whole("threads", threads))
    if chosen not in GENERAL_ROUTES:
        raise Refusal(f"there is no route {chosen!r}", "route", choice(chosen, GENERAL_ROUTES))
    return find(_operand("P", P), _operand("Q", Q), by, chosen, False, count)[0]


def _operand(name: str, given: Solid) -> SpaceOperand:
    surface = surface_of(name, given)
    surface.validate_summand(name)
    return SpaceOperand(name, Path(), surface, None)
