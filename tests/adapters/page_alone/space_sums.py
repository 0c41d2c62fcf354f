"""Sums in space, as shells that may lie side by side or overlap."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import product

from face_pieces import convex_faces
from minkref import _core
from space_blocks import sum_of_blocks, sum_of_prisms
from space_sets import Point, Shell, body_of, hull, is_convex, moved, parts_of, plus


def sums(first: Iterable[Point], second: Iterable[Point]) -> Shell | None:
    return hull(plus(a, b) for a, b in product(first, list(second)))


def sum_in_space(P: Shell, Q: Shell) -> list[Shell]:
    """Shells whose points of positive winding number are P + Q, without parts of zero volume."""
    if not P[0] or not Q[0]:
        return []
    for one, other in ((P, Q), (Q, P)):
        if not one[1] and len(one[0]) == 1:
            return [moved(other, one[0][0])] if other[1] else []
    if not P[1] or (Q[1] and is_convex(P)):
        P, Q = Q, P
    if not P[1]:
        return []
    if not Q[1] or is_convex(Q):
        if is_convex(P):
            found = sum_of_bodies(P, Q) if Q[1] else None
            found = found or sums(P[0], Q[0])
            return [found] if found else []
        rest = Q[0] if not Q[1] else [Q[0][k] for k in sorted({k for f in Q[1] for k in f})]
        pieces = [sums(face, rest) for face in convex_faces(P)]
        return [moved(P, rest[0]), *(piece for piece in pieces if piece)]
    for route in (sum_of_blocks, sum_of_prisms):
        blocks = route(P, Q)
        if blocks is not None:
            return blocks
    pieces = [sums(a, b) for a in convex_faces(P) for b in convex_faces(Q)]
    whole = [moved(P, Q[0][part[0]]) for part in parts_of(Q)]
    whole += [moved(Q, P[0][part[0]]) for part in parts_of(P)]
    return [*whole, *(piece for piece in pieces if piece)]


def sum_of_bodies(P: Shell, Q: Shell) -> Shell:
    """The reference's sum of convex bodies."""
    found = _core.convex_sum(body_of(P), body_of(Q), ("1", "1", "1")).surface
    return [tuple(Fraction(c) for c in p) for p in found.points()], found.rings()
