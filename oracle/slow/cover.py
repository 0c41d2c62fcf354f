"""All sums of a piece from P and a piece from Q, beside or at a scale, and their edges' lines.

The sum of two pieces is stored as half-planes cross(f, x) >= o. Its edges lie on lines cross(d, x)
= offset; a place on a line has u = dot(d, x), so the point equals (u d.x - offset d.y, u d.y +
offset d.x) / dot(d, d).

Edges that come only from an inner diagonal are left out: an open diagonal lies in its operand's
interior, so its sum with anything lies in the sum of the interiors, and bounds nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from .exact import Vector, cross, dot
from .frame import Frame
from .germ import Number, Side

Place = tuple[Number, Number, int]  # key, and u as numerator and denominator


@dataclass
class Line:
    """One line's edges of convex sums as closed intervals for u: `along` d, with the sum to the
    left, and `against` d; and open intervals `inside` a convex sum."""

    d: Vector
    offset: Number
    along: list[tuple[Place, Place]] = field(default_factory=list)
    against: list[tuple[Place, Place]] = field(default_factory=list)
    inside: list[tuple[Place, Place]] = field(default_factory=list)


class Cover:
    """The convex sums of all pairs of pieces. Cost of `lines`: boundary directions times pairs,
    plus lines times pairs passed."""

    def __init__(self, frame: Frame, side: Side, all_edges: bool = False) -> None:
        self.frame = frame
        self.side = side
        self.all_edges = all_edges
        self.directions = frame.boundary
        if all_edges:
            self.directions = sorted({d for d in frame.directions if d > (0, 0)})
            self.directions += [
                (-x, -y)
                for x, y in frame.directions
                if (-x, -y) > (0, 0) and (-x, -y) not in self.directions
            ]
        # cross(f, d) of any two directions is below 2 longest^2: see germ.py for the shift.
        self.shift = 2 * (2 * frame.longest**2).bit_length()
        index = {d: i for i, d in enumerate(frame.directions)}
        of_p, of_q = side.of_p, side.of_q
        low_p = [[of_p * f[0] for f in frame.faces(d)[0]] for d in frame.directions]
        low_q = [[of_q * f[0] for f in frame.faces(d)[1]] for d in frame.directions]
        self.half_planes: list[list[tuple[int, Number]]] = []
        for i, t in enumerate(frame.P.pieces):
            for j, u in enumerate(frame.Q.pieces):
                sides = [index[d] for d in {**t.edges, **u.edges}]
                self.half_planes.append([(k, low_p[k][i] + low_q[k][j]) for k in sides])
        # Open segments: d, cross(d, x), and the ends by dot(d, x).
        self.passages = [
            (d, *(of_p * a + of_q * b for a, b in zip(p, q, strict=True)))
            for d, p, q in frame.flat_passages()
        ]

    def in_passage(self, x: Number, y: Number, den: int) -> bool:
        """Tell whether the point (x, y) / den lies on a parallel diagonal plus the segment."""
        return any(
            y * d[0] - x * d[1] == offset * den and start * den < x * d[0] + y * d[1] < end * den
            for d, offset, start, end in self.passages
        )

    def lines(self) -> Iterator[Line]:
        """Yield each line with an edge that may belong to the boundary or a tight passage."""
        for d in self.directions:
            lines: dict[Number, Line] = {}
            lows, highs = self.edges(d, lines)
            turns = [cross(f, d) for f in self.frame.directions]
            dots = [dot(f, d) for f in self.frame.directions]
            for line in lines.values():
                self.pass_through(line, lows, highs, turns, dots)
                for way, offset, start, end in self.passages:
                    if way == d and offset == line.offset:
                        line.inside.append((self.whole(start), self.whole(end)))
                yield line

    def whole(self, u: Number) -> Place:
        return (u << self.shift, u, 1)

    def edges(self, d: Vector, lines: dict[Number, Line]) -> tuple[list[Number], list[Number]]:
        """Fill in the edges along and against d; return each pair's range of cross(d, x)."""
        of_p, of_q = self.side.of_p, self.side.of_q
        lows: list[Number] = []
        highs: list[Number] = []
        for sign, ranges in ((1, lows), (-1, highs)):
            way = (sign * d[0], sign * d[1])
            faces_p, faces_q = self.frame.faces(way)
            scaled_p = [(sign * of_p * a, of_p * b, of_p * c) for a, b, c in faces_p]
            scaled_q = [(sign * of_q * a, of_q * b, of_q * c) for a, b, c in faces_q]
            kinds_q = [piece.edges.get(way) for piece in self.frame.Q.pieces]
            for t, (p_offset, p_low, p_high) in zip(self.frame.P.pieces, scaled_p, strict=True):
                kind_p = t.edges.get(way)
                for kind_q, (q_offset, q_low, q_high) in zip(kinds_q, scaled_q, strict=True):
                    offset = p_offset + q_offset
                    ranges.append(offset)
                    if kind_p is None and kind_q is None:
                        continue
                    if not self.all_edges and (kind_p is False or kind_q is False):
                        continue
                    line = lines.get(offset)
                    if line is None:
                        line = lines[offset] = Line(d, offset)
                    if sign > 0:
                        ends = (self.whole(p_low + q_low), self.whole(p_high + q_high))
                        line.along.append(ends)
                    else:
                        ends = (self.whole(-p_high - q_high), self.whole(-p_low - q_low))
                        line.against.append(ends)
        return lows, highs

    def pass_through(
        self, line: Line, lows: list[Number], highs: list[Number], turns: list[int], dots: list[int]
    ) -> None:
        """Fill in the open intervals where the line passes through a pair's interior."""
        d, offset = line.d, line.offset
        dd = dot(d, d)
        shift = self.shift
        ends = line.along + line.against
        first = min(low for low, _ in ends)[0]
        last = max(high for _, high in ends)[0]
        for half_planes, low, high in zip(self.half_planes, lows, highs, strict=True):
            if not low < offset < high:
                continue
            lower: Place | None = None
            upper: Place | None = None
            for k, bound in half_planes:
                turn = turns[k]
                if turn > 0:
                    u = bound * dd - offset * dots[k]
                    key = (u << shift) // turn
                    if lower is None or key > lower[0]:
                        if key > last or (upper is not None and key >= upper[0]):
                            break
                        lower = (key, u, turn)
                elif turn < 0:
                    u = offset * dots[k] - bound * dd
                    key = (u << shift) // -turn
                    if upper is None or key < upper[0]:
                        if key < first or (lower is not None and key <= lower[0]):
                            break
                        upper = (key, u, -turn)
            else:
                assert lower is not None and upper is not None
                line.inside.append((lower, upper))
