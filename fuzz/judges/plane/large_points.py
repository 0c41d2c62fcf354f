"""Single points of a sum of any size, by the reference and by the slow engine."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.plane import written_rings
from minkref.fuzz.judges.plane.slow_operands import slow_operands, slow_scale
from minkref.fuzz.plane.case import Case
from minkref.oracle import slow
from minkref.oracle.slow.witness import Pieces

WORDS = {"disjoint": "empty", "touching": "touching", "overlapping": "overlapping"}


def decided_otherwise(case: Case, count: int, seed: int) -> list[str]:
    """Points that the reference and the slow engine decide differently, among `count` vertices of
    the sum's boundary, middles of its edges, and points a little left and right of the middles."""
    P, Q = map(Pieces.of, slow_operands(case))
    scale = slow_scale(case)
    different = []
    for x, y in points(case, count, seed):
        ours = _core.decide(case.P, case.Q, case.scale, str(x), str(y))["contact"]
        theirs = WORDS[slow.witness(P, Q, scale, (x, y)).contact]
        if ours != theirs:
            different.append(f"({x}, {y}): the reference says {ours}, the slow engine {theirs}")
    return different


def points(case: Case, count: int, seed: int) -> list[tuple[Fraction, Fraction]]:
    dice = random.Random(seed)
    region = _core.minkowski_sum(case.P, case.Q, case.scale).region
    rings = written_rings(region.canonical_json())
    found = []
    for i in range(count):
        ring = dice.choice(rings)
        k = dice.randrange(len(ring))
        (ax, ay), (bx, by) = (
            (Fraction(x), Fraction(y)) for x, y in (ring[k], ring[(k + 1) % len(ring)])
        )
        aside = (0, 0, Fraction(1, 10**6), -Fraction(1, 10**6))[i % 4]
        t = 0 if i % 4 == 0 else Fraction(1, 2)
        x, y = ax + t * (bx - ax), ay + t * (by - ay)
        found.append((x - aside * (by - ay), y + aside * (bx - ax)))
    return found
