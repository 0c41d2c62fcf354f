"""Cuts and pieces of the reference before the judge of features, who looks at all walls."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction

from minkref import _core
from minkref.disc.decomposition import decompose
from minkref.fuzz.geometry.plane import Shape
from minkref.oracle.features import Judge
from minkref.oracle.features.cuts import cuts, is_convex, pieces
from minkref.oracle.features.outline import Point, cross


def cut_faults(
    shape: Shape, judge: Judge, P: _core.PolygonSet, dice: random.Random, counts: Counter[str]
) -> list[str]:
    """Differences at alpha 0 without a least persistence, and with one; at a larger alpha; and in a
    range."""
    given = [[[(Fraction(x), Fraction(y)) for x, y in r] for r in p] for p in shape]
    alpha = Fraction(dice.randint(1, 12), 4)
    faults = []
    for start, tau, end in (
        (Fraction(0), Fraction(0), None),
        (Fraction(0), Fraction(dice.randint(1, 8), 4), None),
        (alpha, Fraction(0), None),
        (alpha, Fraction(dice.randint(0, 4), 4), alpha + Fraction(dice.randint(1, 9), 4)),
    ):
        told = decompose(P, alpha=start, persistence=tau, alpha_to=end)
        names = [judge.wedge_name(notch.wedge) for notch in judge.notches(start, tau, end)]
        own = cuts(given, [(Fraction(x), Fraction(y)) for _, x, y, *_ in names])
        found = pieces(given, own)
        counts["cuts"] += len(own)
        counts["pieces"] += len(found)
        where = f"at alpha {start}, persistence {tau}, up to {end}"
        if own != [(cut.start, cut.end) for cut in told.cuts]:
            faults.append(f"cuts {where}")
        elif sorted(map(_doubled_area, found)) != sorted(
            sum((_doubled_area(polygon) for polygon in piece.region.rings()), Fraction(0))
            for piece in told.pieces
        ):
            faults.append(f"pieces {where}")
        if start == tau == 0 and not all(map(is_convex, found)):
            faults.append("pieces that are not convex")
    return faults


def _doubled_area(rings: list[list[Point]]) -> Fraction:
    sides = (side for ring in rings for side in zip(ring, [*ring[1:], *ring[:1]], strict=True))
    return sum((cross(p, q) for p, q in sides), Fraction(0))
