"""The check of a witness in plain Python fractions, from the definition of the sum alone.

A point x lies in sP + Q iff sP meets x - Q. It shares nothing with the code that found the witness.
"""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.verdicts.plain_plane import (
    Point,
    Rings,
    contains,
    edges,
    meet,
    rings_of,
    segments_meet,
)
from minkref.fuzz.verdicts.square import clear_of_square, square_inside
from minkref.fuzz.verdicts.verdict import Witness

ORIGIN = (Fraction(0), Fraction(0))


def holds(P_json: str, Q_json: str, scale: str, witness: Witness) -> bool:
    """True iff the witness proves what it says. O(mn) exact segment tests where it says
    `outside`. With a tolerance its square is inside or outside as a whole; False too where the
    square is crossed by so many segments that the check gives up."""
    s = Fraction(scale)
    P = rings_of(P_json, s, ORIGIN)
    x = (Fraction(witness.point[0]), Fraction(witness.point[1]))
    half = Fraction(witness.tolerance)
    if witness.in_truth:
        if witness.p is None or witness.q is None:
            return False
        p = (s * Fraction(witness.p[0]), s * Fraction(witness.p[1]))
        q = (Fraction(witness.q[0]), Fraction(witness.q[1]))
        Q = rings_of(Q_json, Fraction(1), ORIGIN)
        if (p[0] + q[0], p[1] + q[1]) != x:
            return False
        within = on_boundary if witness.boundary else contains
        if not (within(P, p) and within(Q, q)):
            return False
        return not half or square_inside(P, Q, x, half, witness.boundary)
    reflected = rings_of(Q_json, Fraction(-1), x)
    if half:
        return clear_of_square(P, reflected, half, witness.boundary)
    return not (boundaries_meet if witness.boundary else meet)(P, reflected)


def on_boundary(polygons: Rings, point: Point) -> bool:
    return boundaries_meet(polygons, [[[point]]])


def boundaries_meet(first: Rings, second: Rings) -> bool:
    others = edges(second)
    return any(segments_meet(a, b, c, d) for a, b in edges(first) for c, d in others)
