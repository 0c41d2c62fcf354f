"""The sum at, just below or just above a scale: components, holes, rings, area.

Holes are components of the open complement: the same boundary edges, reversed, bound it.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from .cover import Cover
from .frame import Frame
from .germ import Side, Track, side_of
from .outline import Outline, outline
from .walks import Component, Edge, Node, components, corners

Ring = list[tuple[Track, Track]]


@dataclass
class State:
    """`rings`: for each component of the interior its outer ring and its holes, in canonical form
    and order. `interior` and `complement` are the components of both open sets, in the order of
    their rings; the unbounded component of the complement is not among them. `area` is a0 + a1 (s -
    s0) + a2 (s - s0)^2.
    """

    side: Side
    outline: Outline
    rings: list[list[Ring]]
    interior: list[Component]
    complement: list[Component]
    area: tuple[Fraction, Fraction, Fraction]

    @property
    def shape(self) -> list[list[int]]:
        """The number of vertices of each ring: of each component first the outer one, then the
        holes."""
        return [[len(ring) for ring in part] for part in self.rings]

    @property
    def pinches(self) -> int:
        """How often the boundary touches itself."""
        return len(self.outline.edges) - len({edge.start for edge in self.outline.edges})

    def tracks(self, ring: list[Edge]) -> Ring:
        return [self.place(edge.start) for edge in corners(ring)]

    def place(self, node: Node) -> tuple[Track, Track]:
        x, y, den = self.outline.plane.points[node]
        return self.side.track(x, den), self.side.track(y, den)


def state(frame: Frame, scale: Fraction, side: int = 0, explicit: bool = False) -> State:
    """The sum at the scale (side 0), just below (-1) or just above it (1). Exact. `explicit`
    computes with `Germ` in place of packed integers, which gives the same and takes longer."""
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
    areas = [ring_area(ring) for part in result.rings for ring in part]
    if areas:
        a, b, c = (sum(column, Fraction(0)) for column in zip(*areas, strict=True))
        result.area = (a, b, c)
    return result


def ring_area(ring: Ring) -> tuple[Fraction, Fraction, Fraction]:
    """The signed area as a polynomial in s - s0; clockwise rings count below zero."""
    a = b = c = Fraction(0)
    for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1], strict=True):
        a += x0.value * y1.value - x1.value * y0.value
        b += x0.value * y1.slope + x0.slope * y1.value - x1.value * y0.slope - x1.slope * y0.value
        c += x0.slope * y1.slope - x1.slope * y0.slope
    return a / 2, b / 2, c / 2
