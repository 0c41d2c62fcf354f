"""Two operands as convex pieces at all scales: directions, and supports along each direction.

For a direction d (integer, primitive) a convex piece has a least value of cross(d, x), a face of
points with this value (a vertex, or an edge along d with the piece to its left), and the face's
ends along d. All add under Minkowski sums, with P's numbers times the scale, so no code ever makes
a vertex of a convex sum.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import lcm

from .exact import Vector, cross, dot, primitive
from .germ import bits_needed
from .operand import Operand
from .pieces import Piece, Shape, common_denominator, shape_of

Face = tuple[int, int, int]  # cross(d, x), and the range of dot(d, x), on the face


def face(piece: Piece, d: Vector) -> Face:
    dx, dy = d
    offsets = [dx * y - dy * x for x, y in piece.points]
    least = min(offsets)
    along = [
        dx * p[0] + dy * p[1]
        for p, offset in zip(piece.points, offsets, strict=True)
        if offset == least
    ]
    return least, min(along), max(along)


def upward(d: Vector) -> Vector:
    """Return d or -d, whichever points to the right, or upwards."""
    return d if d > (0, 0) else (-d[0], -d[1])


@dataclass
class Frame:
    """P and Q as pieces over one unit, the directions of their edges, and supports by direction."""

    P: Shape
    Q: Shape
    directions: list[Vector] = field(init=False)
    boundary: list[Vector] = field(init=False)  # of boundary edges, turned upward
    longest: int = field(init=False)
    supports_p: dict[Vector, list[Face]] = field(default_factory=dict)
    supports_q: dict[Vector, list[Face]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        ways: dict[Vector, bool] = {}
        for piece in (*self.P.pieces, *self.Q.pieces):
            for d, is_boundary in piece.edges.items():
                ways[d] = ways.get(d, False) or is_boundary
        self.directions = sorted(ways)
        self.boundary = sorted({upward(d) for d, is_boundary in ways.items() if is_boundary})
        self.longest = max((max(abs(d[0]), abs(d[1])) for d in ways), default=1)

    def faces(self, d: Vector) -> tuple[list[Face], list[Face]]:
        """Return the faces along d of all pieces in P and in Q."""
        if d not in self.supports_p:
            self.supports_p[d] = [face(piece, d) for piece in self.P.pieces]
            self.supports_q[d] = [face(piece, d) for piece in self.Q.pieces]
        return self.supports_p[d], self.supports_q[d]

    def bits(self, denominator: int) -> int:
        size = max(self.P.size(), self.Q.size())
        return bits_needed(size, denominator, self.longest)

    def flat_passages(self) -> list[tuple[Vector, Face, Face]]:
        """List d, P's face and Q's face for each diagonal of an operand that the other operand, a
        point or a parallel segment, moves along. The open diagonal plus the point or segment
        belongs to the sum of the relative interiors, but lies inside no sum of a piece."""
        flat, other = (self.P, self.Q) if self.P.is_flat else (self.Q, self.P)
        found = []
        for piece in flat.pieces if flat.is_flat else []:
            for a, b in other.diagonals:
                d = upward(primitive(b[0] - a[0], b[1] - a[1]))
                if piece.edges and d not in piece.edges:
                    continue
                ends = sorted((dot(d, a), dot(d, b)))
                own, theirs = face(piece, d), (cross(d, a), ends[0], ends[1])
                found.append((d, own, theirs) if flat is self.P else (d, theirs, own))
        return found


def frame_of(P: Operand, Q: Operand) -> Frame:
    unit = lcm(common_denominator(P), common_denominator(Q))
    return Frame(shape_of(P, unit), shape_of(Q, unit))
