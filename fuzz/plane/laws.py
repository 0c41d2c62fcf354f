"""Laws of the sum: how it changes with the operands. No expected value is needed.

A case is changed, the target is asked for both sums, and the law says what the second must be if
the first is right. Where they break the law, one point of their difference is decided, and one of
the two is wrong.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.maps import hull_of, mapped, refined, without_holes

Polygons = list[dict[str, Any]]
FAR = (Fraction(1013), Fraction(-778))
FACTOR = Fraction(3)
EMPTY = _core.PolygonSet.from_json('{"polygons":[]}')
POINT = _core.PolygonSet.from_json('{"polygons":[{"outer":[["-3","5"]],"holes":[]}]}')


@dataclass(frozen=True)
class Law:
    """`carry(base, R)` is what the changed sum must be where R is the sum of `base`, both as
    polygons; with `contains` it must be a part of the changed sum. `constant`: whatever R is."""

    title: str
    change: Callable[[Case], Case]
    carry: Callable[[Case, Polygons], Polygons]
    contains: bool = False
    constant: bool = False

    def changed(self, base: Case) -> Case:
        name = next(name for name, law in LAWS.items() if law is self)
        return replace(self.change(base), law=(name, base), family=base.family)


def _set(polygons: Polygons) -> _core.PolygonSet:
    return _core.PolygonSet.from_json(json.dumps({"polygons": polygons}))


def _polygons(text: str) -> Polygons:
    polygons: Polygons = json.loads(text)["polygons"]
    return polygons


def _moved(operand: _core.PolygonSet, by: tuple[Fraction, Fraction]) -> _core.PolygonSet:
    return _set(mapped(_polygons(operand.to_json()), shift=by))


def _turned(operand: _core.PolygonSet) -> _core.PolygonSet:
    return _set(mapped(_polygons(operand.to_json()), quarter_turn=True))


def _scaled(operand: _core.PolygonSet, factor: Fraction) -> _core.PolygonSet:
    return _set(mapped(_polygons(operand.to_json()), factor))


def _same(_: Case, R: Polygons) -> Polygons:
    return R


LAWS: dict[str, Law] = {
    "translate-P": Law(
        "s(P + t) + Q = (sP + Q) + st",
        lambda case: replace(case, P=_moved(case.P, FAR)),
        lambda base, R: mapped(
            R, shift=(Fraction(base.scale) * FAR[0], Fraction(base.scale) * FAR[1])
        ),
    ),
    "translate-Q": Law(
        "sP + (Q + t) = (sP + Q) + t",
        lambda case: replace(case, Q=_moved(case.Q, FAR)),
        lambda _, R: mapped(R, shift=FAR),
    ),
    "swap": Law(
        "sP + Q = Q + sP",
        lambda case: replace(case, P=case.Q, Q=case.P.scaled(case.scale), scale="1"),
        _same,
    ),
    "homogeneity": Law(
        "s(kP) + kQ = k(sP + Q)",
        lambda case: replace(case, P=_scaled(case.P, FACTOR), Q=_scaled(case.Q, FACTOR)),
        lambda _, R: mapped(R, FACTOR),
    ),
    "scale-split": Law(
        "(2s)(P/2) + Q = sP + Q",
        lambda case: replace(
            case, P=_scaled(case.P, Fraction(1, 2)), scale=str(2 * Fraction(case.scale))
        ),
        _same,
    ),
    "empty": Law(
        "sP + {} = {}", lambda case: replace(case, Q=EMPTY), lambda _, R: [], constant=True
    ),
    "point": Law(
        "sP + {q} = sP moved by q",
        lambda case: replace(case, Q=POINT),
        lambda base, R: mapped(_polygons(base.scaled_P_json), shift=(Fraction(-3), Fraction(5))),
        constant=True,
    ),
    "monotonicity": Law(
        "P in P' : sP + Q in sP' + Q",
        lambda case: replace(case, P=_set(without_holes(_polygons(case.P_json)))),
        _same,
        contains=True,
    ),
    "refinement": Law(
        "vertices amid edges change nothing",
        lambda case: replace(
            case, P=_set(refined(_polygons(case.P_json))), Q=_set(refined(_polygons(case.Q_json)))
        ),
        _same,
    ),
    "quarter-turn": Law(
        "the sum turns with the operands",
        lambda case: replace(case, P=_turned(case.P), Q=_turned(case.Q)),
        lambda _, R: mapped(R, quarter_turn=True),
    ),
    "hull": Law(
        "hull(sP + Q) = s hull(P) + hull(Q)",
        lambda case: replace(
            case, P=_set(hull_of(_polygons(case.P_json))), Q=_set(hull_of(_polygons(case.Q_json)))
        ),
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
