"""The sum at, just below or just above a scale: components, holes, rings, area.

Holes are components of the open complement, bounded by the same edges, reversed.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import lcm

from .cover import Cover
from .frame import Frame
from .germ import Side, Track, side_of
from .outline import Outline, outline
from .plane import Edge, Node, Plane
from .walks import Component, components, corners

Ring = list[tuple[Track, Track]]


@dataclass
class State:
    """A state of the sum. `rings` lists for each component of the interior the outer ring and the
    holes, in canonical form and order. `interior` and `complement` list the components of both open
    sets in ring order, without the unbounded component. `area` means a0 + a1 (s - s0) + a2 (s -
    s0)^2.
    """

    side: Side
    outline: Outline
    rings: list[list[Ring]]
    interior: list[Component]
    complement: list[Component]
    area: tuple[Fraction, Fraction, Fraction]

    @property
    def shape(self) -> list[list[int]]:
        """List the vertex count of each ring: for each component the outer ring, then the holes."""
        return [[len(ring) for ring in part] for part in self.rings]

    @property
    def pinches(self) -> int:
        """Count how often the boundary touches itself."""
        return len(self.outline.edges) - len({edge.start for edge in self.outline.edges})

    def tracks(self, ring: list[Edge]) -> Ring:
        return [self.place(edge.start) for edge in corners(ring)]

    def place(self, node: Node) -> tuple[Track, Track]:
        x, y, den = self.outline.plane.points[node]
        return self.side.track(x, den), self.side.track(y, den)


def state(frame: Frame, scale: Fraction, side: int = 0, explicit: bool = False) -> State:
    """Compute the sum at the scale (side 0), just below (-1) or just above (1). Exact. `explicit`
    uses `Germ` instead of packed integers, with the same result and more time."""
    bits = frame.bits(scale.denominator)
    where = side_of(scale, side, frame.P.unit, bits, explicit)
    return state_of(where, outline(Cover(frame, where)))


def state_of(side: Side, found: Outline) -> State:
    interior, lone = components(found.plane, found.edges)
    assert not lone  # the sum is bounded
    complement, _ = components(found.plane, [edge.reversed() for edge in found.edges])

    def order(ring: list[Edge]) -> list[Node]:
        return [edge.start for edge in corners(ring)]

    for part in interior:
        part.holes.sort(key=order)
    interior.sort(key=lambda part: order(part.outer))
    complement.sort(key=lambda part: order(part.outer))
    result = State(side, found, [], interior, complement, (Fraction(0), Fraction(0), Fraction(0)))
    result.rings = [[result.tracks(ring) for ring in (p.outer, *p.holes)] for p in interior]
    rings = [ring for part in interior for ring in (part.outer, *part.holes)]
    result.area = area(side, found.plane, rings)
    return result


def area(side: Side, plane: Plane, rings: list[list[Edge]]) -> tuple[Fraction, Fraction, Fraction]:
    """Compute the area as a polynomial in s - s0, summed in integers; clockwise rings count
    negatively."""
    unit = lcm(1, *(plane.points[edge.start][2] for ring in rings for edge in ring))
    a = b = c = 0
    for ring in rings:
        corners_of = []
        for edge in ring:
            x, y, den = plane.points[edge.start]
            times = unit // den
            corners_of.append([part * times for n in (x, y) for part in side.coefficients(n)])
        x0, u0, y0, v0 = corners_of[-1]
        for x1, u1, y1, v1 in corners_of:
            a += x0 * y1 - x1 * y0
            b += x0 * v1 + u0 * y1 - x1 * v0 - u1 * y0
            c += u0 * v1 - u1 * v0
            x0, u0, y0, v0 = x1, u1, y1, v1
    # Just below the scale, e equals s0 - s.
    whole = 2 * (unit * side.unit) ** 2
    return Fraction(a, whole), Fraction(side.side * b, whole), Fraction(c, whole)
