"""Erosions as sums: the outside plus -Q leaves the erosion as holes (docs/erosion.md)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.errors import Refusal
from minkref.plane.operand import Operand
from minkref.plane.scaling import PlaneScale, static_pair


@dataclass(frozen=True)
class ErodingPair:
    """P's `outside` and -Q. `least`: below this scale Q's box finds no room in the scaled P's box,
    and the erosion is empty; sums count from half this scale on."""

    outside: _core.Outside
    P: Operand
    Q: Operand
    least: Fraction

    def window(
        self, first: Fraction | None, last: Fraction | None
    ) -> tuple[Fraction | None, Fraction | None]:
        """Cut a window to scales at which sums count; erosions are empty below."""
        if self.least == 0:
            return first, last
        begin = max(first or Fraction(0), self.least / 2)
        return begin, None if last is None else max(begin, last)


def refuse_others(erode: bool, route: str, routes: Sequence[str]) -> None:
    """Refuse other routes with --erode."""
    if erode and route not in routes:
        what = f"the route {route} has no erosion"
        mend = f"choose one of {', '.join(routes)}, or leave out --erode"
        raise Refusal(what, f"--route {route} --erode", mend)


def has_room(P: Operand, Q: Operand, scale: PlaneScale) -> bool:
    """Tell whether the scaled P's box has room for Q's box."""
    made, at = static_pair(P, scale)
    least = _core.least_scale_with_room(made.set, Q.set)
    return least is not None and Fraction(least) <= at


def eroding_pair(P: Operand, Q: Operand) -> ErodingPair:
    """Make the pair for all scales. Refuses a P without area."""
    refuse_empty(Q)
    if not P.set.is_region:
        what = "the first operand has no area, so that it leaves a segment or a point at most"
        mend = "give a set of polygons, or ask for one scale with `minkref erode`"
        raise Refusal(what, P.name, mend, "degenerate-operands")
    least = _core.least_scale_with_room(P.set, Q.set)
    assert least is not None  # P has an area
    outside = _core.Outside(P.set)
    first = Operand(f"the outside of {P.name}", P.source, outside.set, P.warnings)
    second = Operand(f"-{Q.name}", Q.source, _core.negated(Q.set), Q.warnings)
    return ErodingPair(outside, first, second, Fraction(least))


def refuse_empty(Q: Operand) -> None:
    if Q.set.is_empty:
        what = "Q is empty, so that every place is in the erosion"
        mend = "give a polygon set, a segment or a point"
        raise Refusal(what, Q.name, mend, "empty-operand")
