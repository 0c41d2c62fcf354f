"""Tells how sP and x - Q meet, by pairs of convex pieces. A common point gives p and q with s p + q
= x."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import lcm
from typing import Literal

from .convex import Common, Corners, boxes_that_meet, centre, clipped, sides_of
from .exact import InputError, Point, Vector
from .operand import Operand
from .pieces import Shape, common_denominator, shape_of

Contact = Literal["disjoint", "touching", "overlapping"]


@dataclass(frozen=True)
class Meeting:
    """A meeting. `overlapping`: the relative interiors share a point, so the sum of the interiors
    contains x; `touching`: only the closed sets share a point. Unless disjoint, `p` from P and `q`
    from Q satisfy s p + q = x."""

    contact: Contact
    p: Point | None
    q: Point | None

    @property
    def in_sum(self) -> bool:
        return self.contact != "disjoint"


@dataclass
class Pieces:
    """An operand cut into pieces once, for many questions."""

    shape: Shape

    @classmethod
    def of(cls, operand: Operand) -> Pieces:
        return cls(shape_of(operand, common_denominator(operand)))


def witness(P: Operand | Pieces, Q: Operand | Pieces, scale: Fraction, x: Point) -> Meeting:
    """Tell whether sP and x - Q are disjoint, touch or overlap. Exact. Cost: cutting operands into
    pieces (quadratic at worst), sorting the pieces, and pairs of pieces whose boxes meet."""
    if scale <= 0:
        raise InputError(f"a scale is positive, and {scale} is not")
    P = P if isinstance(P, Pieces) else Pieces.of(P)
    Q = Q if isinstance(Q, Pieces) else Pieces.of(Q)
    # Both sets as integers over one unit.
    unit = lcm(P.shape.unit * scale.denominator, Q.shape.unit, x[0].denominator, x[1].denominator)
    of_p, of_q = int(scale * unit / P.shape.unit), unit // Q.shape.unit
    at = (int(x[0] * unit), int(x[1] * unit))
    ours = [[(of_p * a, of_p * b) for a, b in piece.points] for piece in P.shape.pieces]
    theirs = [[(at[0] - of_q * a, at[1] - of_q * b) for a, b in p.points] for p in Q.shape.pieces]
    contact: Contact = "disjoint"
    meeting: tuple[Fraction, Fraction] | None = None
    for a, b in boxes_that_meet(ours, theirs):
        common = clipped(a, b)
        if not common:
            continue
        inside = relative_interior_meets(a, b, common)
        if meeting is None or inside:
            meeting = centre(common)
            contact = "overlapping" if inside else "touching"
        if inside:
            break
    if contact == "touching" and (P.shape.is_flat or Q.shape.is_flat):
        # A polygon set's interior also holds the open diagonals.
        through = along_diagonals(P.shape, Q.shape, of_p, of_q, at)
        if through is not None:
            contact, meeting = "overlapping", through
    if meeting is None:
        return Meeting(contact, None, None)
    z = (meeting[0] / unit, meeting[1] / unit)
    return Meeting(contact, (z[0] / scale, z[1] / scale), (x[0] - z[0], x[1] - z[1]))


def relative_interior_meets(a: Corners, b: Corners, common: Common) -> bool:
    """Tell whether the open pieces meet: both then contain the centre of their intersection in
    their interior. A segment's ends do not count; a single point does."""
    x, y = centre(common)
    for piece in (a, b):
        if len(piece) >= 3:
            for (x0, y0), (x1, y1) in sides_of(piece):
                if (x1 - x0) * (y - y0) <= (y1 - y0) * (x - x0):
                    return False
        elif len(piece) == 2 and any(x == a0 and y == b0 for a0, b0 in piece):
            return False
    return True


def along_diagonals(
    P: Shape, Q: Shape, of_p: int, of_q: int, at: Vector
) -> tuple[Fraction, Fraction] | None:
    """Find a point shared by one operand's open diagonal and the relative interior of the other,
    flat operand."""

    def ours(p: Vector) -> Vector:
        return of_p * p[0], of_p * p[1]

    def theirs(q: Vector) -> Vector:
        return at[0] - of_q * q[0], at[1] - of_q * q[1]

    flat, other = (P, Q) if P.is_flat else (Q, P)
    place, across = (ours, theirs) if P.is_flat else (theirs, ours)
    ends = [place(p) for piece in flat.pieces for p in piece.points]
    for a, b in other.diagonals:
        point = crossing(ends, across(a), across(b))
        if point is not None:
            return point
    return None


def crossing(ends: Corners, a: Vector, b: Vector) -> tuple[Fraction, Fraction] | None:
    """Find a common point of the open segment a b and a point or an open segment; None without a
    common point."""
    ab = (b[0] - a[0], b[1] - a[1])
    norm = ab[0] ** 2 + ab[1] ** 2
    levels = [ab[0] * (y - a[1]) - ab[1] * (x - a[0]) for x, y in ends]
    along = [Fraction(ab[0] * (x - a[0]) + ab[1] * (y - a[1]), norm) for x, y in ends]
    if any(levels):
        if len(ends) == 1 or levels[0] * levels[1] >= 0:
            return None
        t = along[0] + (along[1] - along[0]) * Fraction(levels[0], levels[0] - levels[1])
    elif len(ends) == 1:
        t = along[0]
    else:
        t = (max(Fraction(0), min(along)) + min(Fraction(1), max(along))) / 2
        if not min(along) < t < max(along):
            return None
    return (a[0] + t * ab[0], a[1] + t * ab[1]) if 0 < t < 1 else None
