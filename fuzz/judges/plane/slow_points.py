"""The decision of single points against the slow engine's."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.plane import written_rings
from minkref.fuzz.judges.plane.slow_operands import slow_operands, slow_scale
from minkref.fuzz.judges.ruling import Ruling, dice_of
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.verdicts.verdict import Reason, Witness
from minkref.oracle import slow
from minkref.oracle.slow.witness import Pieces

POINTS = 8
WORDS = {"disjoint": "empty", "touching": "touching", "overlapping": "overlapping"}
Point = tuple[Fraction, Fraction]


def judge(case: Case) -> Ruling:
    """Judges random points and points on the sum's boundary: whether sP and x - Q are disjoint,
    touch or overlap; if they meet, plain fractions check p and q."""
    ruling = Ruling()
    P, Q = map(Pieces.of, slow_operands(case))
    for x in points_of(case):
        text = str(x[0]), str(x[1])
        ours = _core.decide(case.P, case.Q, case.scale, *text)
        theirs = slow.witness(P, Q, slow_scale(case), x)
        ruling.compare(
            f"how sP and x - Q meet at x = ({', '.join(text)})",
            ours["contact"], WORDS[theirs.contact],
            Reason.EXTRA if ours["contact"] != "empty" else Reason.MISSING,
        )  # fmt: skip
        if ours["contact"] != "empty":
            claim = Witness(text, True, tuple(ours["p"]), tuple(ours["q"]))
            ruling.compare(
                f"that p and q prove ({', '.join(text)})",
                True, holds(case.P_json, case.Q_json, case.scale, claim), Reason.EXTRA,
            )  # fmt: skip
    return ruling


def points_of(case: Case) -> list[Point]:
    dice = dice_of(case)
    region = _core.minkowski_sum(case.P, case.Q, case.scale).region
    rings = written_rings(region.canonical_json())
    corners = [(Fraction(x), Fraction(y)) for ring in rings for x, y in ring]
    if not corners:
        return []
    return [_point(dice, corners) for _ in range(POINTS)]


def _point(dice: random.Random, corners: list[Point]) -> Point:
    """A corner, half-way between two, or anywhere near."""
    a, b = dice.choice(corners), dice.choice(corners)
    kind = dice.randrange(3)
    if kind == 0:
        return a
    middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
    if kind == 1:
        return middle
    return middle[0] + Fraction(dice.randint(-9, 9), 7), middle[1] + Fraction(
        dice.randint(-9, 9), 7
    )
