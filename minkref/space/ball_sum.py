"""Sums of a solid and a ball, and erosions by a ball, between two polyhedral sets."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from minkref import _core
from minkref.disc.disc import Disc
from minkref.space.ball import polyhedron_near
from minkref.space.general_sum import GENERAL_ROUTES, Progress, general_sum
from minkref.space.operand import SpaceOperand
from minkref.space.scaling import Scaling
from minkref.space.sums import ROUTES, compute

Told = Callable[[str], AbstractContextManager[Progress | None]]
Polyhedra = tuple[_core.ConvexPolyhedron, _core.ConvexPolyhedron]


@dataclass(frozen=True)
class Between:
    """Encloses a set in space: `inner` lies within the set, and `outer` contains it."""

    inner: _core.PolyhedralSet
    outer: _core.PolyhedralSet

    @property
    def volume(self) -> tuple[Fraction, Fraction]:
        """Two exact bounds of the set's volume."""
        return self.inner.volume, self.outer.volume

    def counts(self) -> dict[str, tuple[int, int]]:
        """Count components, cavities and tunnels of `inner` and `outer`. Equal numbers of
        components prove the number for a sum with a ball; other equal numbers prove nothing
        (docs/space-sums.md)."""
        names = ("components", "cavities", "tunnels")
        both = zip(self.inner.surface().topology(), self.outer.surface().topology(), strict=True)
        return dict(zip(names, both, strict=True))


def untold(work: str) -> AbstractContextManager[None]:
    return nullcontext()


def polyhedra_near(ball: Disc, within: Fraction) -> Polyhedra:
    """Make a convex polyhedron inside the ball and another around it."""
    return polyhedron_near(ball, within, False), polyhedron_near(ball, within, True)


def ball_operand(ball: Disc, body: _core.ConvexPolyhedron) -> SpaceOperand:
    return SpaceOperand(ball.name, Path(), body.surface(), body)


def sum_between(
    P: SpaceOperand,
    ball: Disc,
    within: Fraction,
    scaling: Scaling,
    threads: int = 1,
    told: Told = untold,
) -> Between:
    """Enclose the sum of S P and a ball: `inner` lies in the sum, `outer` contains the sum, and no
    point of the larger set is farther than `within` from the smaller one. Exact. Takes the time of
    two sums with polyhedra of about 5 R / `within` facets. Refuses a `within` that needs too many
    facets."""
    sets = []
    for name, body in zip(("inner", "outer"), polyhedra_near(ball, within), strict=True):
        with told(f"the {name} sum") as tell:
            sets.append(_set_of_sum(P, ball_operand(ball, body), scaling, threads, tell))
    return Between(*sets)


def _set_of_sum(
    P: SpaceOperand, Q: SpaceOperand, scaling: Scaling, threads: int, tell: Progress | None
) -> _core.PolyhedralSet:
    if P.body is not None or P.is_thin:
        return _core.PolyhedralSet(compute(P, Q, scaling, ROUTES[0]).surface)
    return general_sum(P, Q, scaling, GENERAL_ROUTES[0], threads, tell).set
