"""Checks a witness in plain Python fractions, from the definition of the sum alone.

A point x lies in sP + Q iff sP meets x - Q. Shares nothing with the code that found the witness.
"""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.geometry.plane import (
    Point,
    Shape,
    contains,
    edges,
    meet,
    read_shape,
    scale_factors,
    segments_meet,
)
from minkref.fuzz.plane.square import clear_of_square, square_inside
from minkref.fuzz.verdicts.verdict import Witness


def holds(P_json: str, Q_json: str, scale: str, witness: Witness) -> bool:
    """True iff the witness proves its statement. O(mn) exact segment tests for `outside`. With a
    tolerance, the whole square lies inside or outside; False also if too many segments cross the
    square and the check gives up."""
    s = scale_factors(scale)
    P = read_shape(P_json, s)
    x = (Fraction(witness.point[0]), Fraction(witness.point[1]))
    half = Fraction(witness.tolerance)
    if witness.in_truth:
        if witness.p is None or witness.q is None:
            return False
        p = (s[0] * Fraction(witness.p[0]), s[1] * Fraction(witness.p[1]))
        q = (Fraction(witness.q[0]), Fraction(witness.q[1]))
        Q = read_shape(Q_json)
        if (p[0] + q[0], p[1] + q[1]) != x:
            return False
        within = on_boundary if witness.boundary else contains
        if not (within(P, p) and within(Q, q)):
            return False
        return not half or square_inside(P, Q, x, half, witness.boundary)
    reflected = read_shape(Q_json, Fraction(-1), x)
    if half:
        return clear_of_square(P, reflected, half, witness.boundary)
    return not (boundaries_meet if witness.boundary else meet)(P, reflected)


def on_boundary(polygons: Shape, point: Point) -> bool:
    return boundaries_meet(polygons, [[[point]]])


def boundaries_meet(first: Shape, second: Shape) -> bool:
    others = edges(second)
    return any(segments_meet(a, b, c, d) for a, b in edges(first) for c, d in others)
