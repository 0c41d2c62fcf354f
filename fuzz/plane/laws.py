"""Laws for the sum: how it changes with the operands. No expected value is needed.

A case is changed, the target computes both sums, and the law derives the second from the first, if
the first is right. If the sums break the law, one point of their difference is decided, and one sum
is wrong.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.plane import Point, Shape, mapped, moved, scale_factors, scaled
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.exact_shapes import set_of, shape_of
from minkref.fuzz.plane.maps import hull_of, quarter_turn, refined, without_holes
from minkref.scaling import joined

FAR = (Fraction(1013), Fraction(-778))
FACTOR = Fraction(3)
THERE = (Fraction(-3), Fraction(5))


@dataclass(frozen=True)
class Law:
    """`carry(base, R)` is the changed sum if R is the sum of `base`, both in fractions; with
    `contains`, only a part of the changed sum. `constant`: independent of R."""

    title: str
    change: Callable[[Case], Case]
    carry: Callable[[Case, Shape], Shape]
    contains: bool = False
    constant: bool = False

    def changed(self, base: Case) -> Case:
        name = next(name for name, law in LAWS.items() if law is self)
        return replace(self.change(base), law=(name, base), family=base.family)


def _made(change: Callable[[Shape], Shape], operand: _core.PolygonSet) -> _core.PolygonSet:
    return set_of(change(shape_of(operand)))


def _moved(shape: Shape) -> Shape:
    return moved(shape, *FAR)


def _scaled(shape: Shape) -> Shape:
    return scaled(shape, FACTOR)


def _turned(shape: Shape) -> Shape:
    return mapped(shape, quarter_turn)


def _times(factors: Point, along: Point) -> Point:
    return factors[0] * along[0], factors[1] * along[1]


def _doubled(scale: str) -> str:
    return joined([str(2 * Fraction(factor)) for factor in scale.split(",")])


def _exchanged(scale: str) -> str:
    """The factors after a quarter turn, which exchanges the axes."""
    return joined(scale.split(",")[::-1])


def _same(_: Case, R: Shape) -> Shape:
    return R


LAWS: dict[str, Law] = {
    "translate-P": Law(
        "s(P + t) + Q = (sP + Q) + st",
        lambda case: replace(case, P=_made(_moved, case.P)),
        lambda base, R: moved(R, *_times(scale_factors(base.scale), FAR)),
    ),
    "translate-Q": Law(
        "sP + (Q + t) = (sP + Q) + t",
        lambda case: replace(case, Q=_made(_moved, case.Q)),
        lambda _, R: _moved(R),
    ),
    "swap": Law(
        "sP + Q = Q + sP",
        lambda case: replace(case, P=case.Q, Q=case.P.scaled(case.scale), scale="1"),
        _same,
    ),
    "homogeneity": Law(
        "s(kP) + kQ = k(sP + Q)",
        lambda case: replace(case, P=_made(_scaled, case.P), Q=_made(_scaled, case.Q)),
        lambda _, R: _scaled(R),
    ),
    "scale-split": Law(
        "(2s)(P/2) + Q = sP + Q",
        lambda case: replace(case, P=case.P.scaled("1/2"), scale=_doubled(case.scale)),
        _same,
    ),
    "empty": Law(
        "sP + {} = {}",
        lambda case: replace(case, Q=_core.PolygonSet()),
        lambda _, R: [],
        constant=True,
    ),
    "point": Law(
        "sP + {q} = sP moved by q",
        lambda case: replace(case, Q=_core.PolygonSet(THERE)),
        lambda base, R: moved(scaled(shape_of(base.P), scale_factors(base.scale)), *THERE),
        constant=True,
    ),
    "monotonicity": Law(
        "P in P' : sP + Q in sP' + Q",
        lambda case: replace(case, P=_made(without_holes, case.P)),
        _same,
        contains=True,
    ),
    "refinement": Law(
        "vertices amid edges change nothing",
        lambda case: replace(case, P=_made(refined, case.P), Q=_made(refined, case.Q)),
        _same,
    ),
    "quarter-turn": Law(
        "the sum turns with the operands",
        lambda case: replace(
            case, P=_made(_turned, case.P), Q=_made(_turned, case.Q), scale=_exchanged(case.scale)
        ),
        lambda _, R: _turned(R),
    ),
    "hull": Law(
        "hull(sP + Q) = s hull(P) + hull(Q)",
        lambda case: replace(case, P=_made(hull_of, case.P), Q=_made(hull_of, case.Q)),
        lambda _, R: hull_of(R),
    ),
}


def applies(name: str, case: Case) -> bool:
    """Whether the law says anything of the case: points and segments have no hull to compare, and
    the sum of two points is none."""
    if name == "point":
        return case.P.is_region
    if name in ("hull", "monotonicity"):
        return case.P.is_region and case.Q.is_region
    return True
