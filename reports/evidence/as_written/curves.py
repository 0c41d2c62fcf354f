"""Corners, arcs and lines of a sum with a disc, from its canonical form alone (docs/disc.md)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import gmpy2
from minkref.reports.evidence.as_written.units import Real, exact

Place = tuple[Real, Real]


@dataclass(frozen=True)
class Arc:
    """The circle about a vertex, run counter-clockwise."""

    x: Any
    y: Any


@dataclass(frozen=True)
class Line:
    """The points p with N · p = c + radius |N| for N = (dy, -dx), run along (dx, dy)."""

    dx: Any
    dy: Any
    c: Any


Curve = Arc | Line


@dataclass(frozen=True)
class Piece:
    """A part of a curve, from one corner to the next; a full circle has no ends."""

    curve: Curve
    start: Place | None
    end: Place | None


@dataclass(frozen=True)
class Grown:
    """A sum with a disc: each component's outer ring, then holes, as pieces."""

    squared: Any
    components: list[list[list[Piece]]]

    @property
    def radius(self) -> Real:
        return gmpy2.sqrt(gmpy2.mpfr(self.squared))

    @property
    def rings(self) -> list[list[Piece]]:
        return [ring for component in self.components for ring in component]


class NoCorner(ValueError):
    """Raised when one curve cannot continue into the other."""


def curve_of(row: Sequence[str]) -> Curve:
    kind, *numbers = row
    values = [exact(number) for number in numbers]
    return Arc(*values) if kind == "arc" else Line(*values)


def grown(document: dict[str, Any]) -> Grown:
    """The sum that a canonical form describes."""
    squared = exact(document["squared_radius"])
    components = [
        [
            _pieces([curve_of(row) for row in ring], squared)
            for ring in (one["outer"], *one["holes"])
        ]
        for one in document["components"]
    ]
    return Grown(squared, components)


def _pieces(curves: list[Curve], squared: Any) -> list[Piece]:
    if len(curves) == 1:
        return [Piece(curves[0], None, None)]
    corners = [corner(curves[k - 1], curves[k], squared) for k in range(len(curves))]
    ends = [*corners[1:], corners[0]]
    return [Piece(*one) for one in zip(curves, corners, ends, strict=True)]


def corner(a: Curve, b: Curve, squared: Any) -> Place:
    """The place where curve `a` enters the neighbourhood of curve `b`'s feature."""
    if isinstance(a, Line) and isinstance(b, Line):
        return _of_lines(a, b, squared)
    if isinstance(a, Arc) and isinstance(b, Arc):
        return _of_circles(a, b, squared)
    if isinstance(a, Line) and isinstance(b, Arc):
        return _of_line_and_circle(a, b, squared, enters=True)
    assert isinstance(a, Arc) and isinstance(b, Line)
    return _of_line_and_circle(b, a, squared, enters=False)


def _of_lines(a: Line, b: Line, squared: Any) -> Place:
    turn = a.dx * b.dy - a.dy * b.dx
    if turn == 0:
        raise NoCorner(f"{a} and {b} are parallel")
    far = [one.c + gmpy2.sqrt(gmpy2.mpfr(squared * (one.dx**2 + one.dy**2))) for one in (a, b)]
    # N_a · p = far_a and N_b · p = far_b, with N = (dy, -dx).
    return ((far[1] * a.dx - far[0] * b.dx) / turn, (far[1] * a.dy - far[0] * b.dy) / turn)


def _of_circles(a: Arc, b: Arc, squared: Any) -> Place:
    """`a` runs counter-clockwise into the disc about the centre of `b`: on the right of the way to
    it, as seen from the centre of `a`."""
    ux, uy = b.x - a.x, b.y - a.y
    apart = ux**2 + uy**2
    left = squared - apart / 4
    if apart == 0 or left < 0:
        raise NoCorner(f"{a} and {b} do not cross")
    across = gmpy2.sqrt(gmpy2.mpfr(left / apart))
    return (a.x + b.x) / 2 + across * uy, (a.y + b.y) / 2 - across * ux


def _of_line_and_circle(line: Line, arc: Arc, squared: Any, enters: bool) -> Place:
    """Where a line enters a disc (first crossing), or a circle enters the line's inner side (second
    crossing); a line through the centre's foot touches, and both crossings coincide."""
    norm = line.dx**2 + line.dy**2
    gap = line.c - (line.dy * arc.x - line.dx * arc.y)  # of the edge's line beyond the centre
    long, root = gmpy2.sqrt(gmpy2.mpfr(norm)), gmpy2.sqrt(gmpy2.mpfr(squared))
    ahead = gap / long + root  # of the moved line beyond the centre
    foot = (arc.x + ahead * line.dy / long, arc.y - ahead * line.dx / long)
    if gap == 0 or (gap < 0 and gap**2 == 4 * squared * norm):
        return foot
    # Equals radius² - ahead², without cancellation between large terms.
    left = -(gap / long) * (gap / long + 2 * root)
    if left < 0:
        raise NoCorner(f"{line} and {arc} do not cross")
    back = -gmpy2.sqrt(left) if enters else gmpy2.sqrt(left)
    return foot[0] + back * line.dx / long, foot[1] + back * line.dy / long
