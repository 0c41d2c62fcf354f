"""The sum sP + Q from its definition: the union of the sums of all pairs of convex pieces."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from .canonical import digest
from .exact import InputError, Point
from .frame import Frame, frame_of
from .operand import Operand, Polygon
from .state import State, state
from .tight import pieces


@dataclass(frozen=True)
class Sum:
    """A sum in canonical form. `holes` counts bounded components of the complement, not rings."""

    polygons: list[Polygon]
    components: int
    holes: int
    area: Fraction
    digest: str
    tight: list[list[Point]]


def checked_frame(P: Operand, Q: Operand, scale: Fraction) -> Frame:
    if scale <= 0:
        raise InputError(f"a scale is positive, and {scale} is not")
    if P.ends and Q.ends:
        raise InputError("only one of the two operands may be a point or a segment")
    return frame_of(P, Q)


def minkowski_sum(P: Operand, Q: Operand, scale: Fraction = Fraction(1)) -> Sum:
    """Compute sP + Q with its tight passages. Exact. InputError if the scale is not positive, both
    operands are flat, or an operand's rings cross. Cost: about (boundary edges of P times vertices
    of Q, and vice versa) times the pairs of convex pieces that each line passes."""
    return sum_of(state(checked_frame(P, Q, scale), scale))


def sum_of(at: State) -> Sum:
    """Convert the state at the scale itself to a sum with rational coordinates."""
    parts = [[[(x.value, y.value) for x, y in ring] for ring in part] for part in at.rings]
    polygons = [Polygon(part[0], part[1:]) for part in parts]
    tight = [[(x.value, y.value) for x, y in map(at.place, p)] for p in pieces(at.outline)]
    return Sum(polygons, len(at.interior), len(at.complement), at.area[0], digest(polygons), tight)
