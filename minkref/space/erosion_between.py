"""Erosions by a ball, between two polyhedral sets."""

from __future__ import annotations

from fractions import Fraction

from minkref.disc.disc import Disc
from minkref.space.ball_sum import Between, Told, ball_operand, polyhedra_near, untold
from minkref.space.general_sum import GENERAL_ROUTES
from minkref.space.operand import SpaceOperand
from minkref.space.remaining import eroded
from minkref.space.scaling import Scaling


def erosion_between(
    P: SpaceOperand,
    ball: Disc,
    within: Fraction,
    scaling: Scaling,
    threads: int = 1,
    told: Told = untold,
) -> Between:
    """Enclose the erosion of S P by a ball: `inner` lies within the erosion, `outer` contains the
    erosion's region. They are the erosions by polyhedra around and inside the ball, which are as
    near to the ball as `within`. Exact. Takes the time of two sums of the outside of P and such a
    polyhedron. Refuses a P without volume, and a `within` that needs too many facets."""
    inside, around = (ball_operand(ball, body) for body in polyhedra_near(ball, within))
    route = GENERAL_ROUTES[0]
    sets = [eroded(P, Q, scaling, route, False, threads, told)[0] for Q in (around, inside)]
    return Between(*sets)
