"""Solids that remain: erosions, openings, closings and no-fit regions (docs/erosion.md)."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Protocol

from minkref import _core
from minkref.errors import Refusal
from minkref.space.ball_sum import Told, untold
from minkref.space.eroded import cavities, negated, outside_of, room
from minkref.space.general_sum import general_sum
from minkref.space.operand import SpaceOperand
from minkref.space.scaling import UNIT, Scaling
from minkref.space.tight_passages import NONE, tight_passages

Passages = dict[str, Any] | None
Found = tuple[_core.PolyhedralSet, float, Passages]


class Find(Protocol):
    """Answers a question about two operands, the first one scaled: the set, the seconds of its
    sums, and what has no volume if asked for."""

    def __call__(
        self,
        P: SpaceOperand,
        Q: SpaceOperand,
        scaling: Scaling,
        route: str,
        passages: bool,
        /,
        threads: int = 1,
        told: Told = untold,
    ) -> Found: ...


def no_fit(
    A: SpaceOperand,
    B: SpaceOperand,
    scaling: Scaling,
    route: str,
    passages: bool,
    threads: int = 1,
    told: Told = untold,
) -> Found:
    """Find the places at which B meets A: the sum of A and -B."""
    turned = negated(B)
    with told(f"route {route}") as tell:
        summed = general_sum(A, turned, scaling, route, threads, tell)
    tight = tight_passages(A, turned, scaling) if passages else None
    return summed.set, summed.seconds, tight


def eroded(
    P: SpaceOperand,
    Q: SpaceOperand,
    scaling: Scaling,
    route: str,
    passages: bool,
    threads: int = 1,
    told: Told = untold,
) -> Found:
    """Erode: the set, its sum's seconds, and remnants if wanted or known to be none."""
    _refuse_empty(Q)
    if P.surface.vertices == 0:
        return _core.PolyhedralSet(P.surface), 0.0, NONE
    outside, turned, places = outside_of(P), negated(Q), room(P, Q, scaling)
    if places.is_empty:
        return _core.PolyhedralSet(_core.Polyhedron([], [])), 0.0, NONE
    with told(f"route {route}") as tell:
        summed = general_sum(outside, turned, scaling, route, threads, tell)
    tight = tight_passages(outside, turned, scaling) if passages else None
    return cavities(summed.set, places), summed.seconds, tight


def opened(
    P: SpaceOperand,
    Q: SpaceOperand,
    scaling: Scaling,
    route: str,
    passages: bool,
    threads: int = 1,
    told: Told = untold,
) -> Found:
    """Open: the sum of the erosion's region and Q. Copies of Q that just fit are left out; their
    places are the erosion's remnants."""
    left, seconds, fits = eroded(P, Q, scaling, route, passages, threads, told)
    if left.is_empty:
        return left, seconds, fits
    within = _operand(left, f"the erosion of {P.name}")
    summed, more, _ = _summed(within, Q, UNIT, route, threads, told)
    return summed, seconds + more, fits


def closed(
    P: SpaceOperand,
    Q: SpaceOperand,
    scaling: Scaling,
    route: str,
    passages: bool,
    threads: int = 1,
    told: Told = untold,
) -> Found:
    """Close: the sum of P and Q, eroded by Q; with remnants if wanted."""
    _refuse_empty(Q)
    if P.surface.vertices == 0:
        return _core.PolyhedralSet(P.surface), 0.0, NONE
    outside_of(P)  # refuses a P without volume
    around, seconds, _ = _summed(P, Q, scaling, route, threads, told)
    summed = _operand(around, f"the sum of {P.name} and {Q.name}")
    left, more, remnants = eroded(summed, Q, UNIT, route, passages, threads, told)
    return left, seconds + more, remnants


def _summed(
    P: SpaceOperand, Q: SpaceOperand, scaling: Scaling, route: str, threads: int, told: Told
) -> Found:
    with told(f"route {route}") as tell:
        summed = general_sum(P, Q, scaling, route, threads, tell)
    return summed.set, summed.seconds, None


def _operand(found: _core.PolyhedralSet, name: str) -> SpaceOperand:
    """Take a set as an operand; triangles make the mesh manifold where the set touches itself."""
    return SpaceOperand(name, Path(), found.surface().mesh(True), None)


def _refuse_empty(Q: SpaceOperand) -> None:
    if Q.surface.vertices == 0:
        what = "Q is empty, so that every place is in the erosion"
        mend = "give a polyhedron, a plane polygon, a segment or a point"
        raise Refusal(what, Q.name, mend, "empty-operand")
