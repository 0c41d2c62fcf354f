"""Moving segments in the plane, and their places at one scale. docs/definitions.md, Convolution."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .rational import Rational, rationals, text

Point = tuple[Rational, Rational]
Segment = tuple[Point, Point]
KINDS = ("S", "T")


@dataclass(frozen=True, slots=True)
class MovingSegment:
    """A segment that depends on the scale s > 0.

    `kind` S: the points s (p0 + t (p1 - p0)) + q, `data` is p0, p1, q. `kind` T: the points s p +
    q0 + t (q1 - q0), `data` is p, q0, q1. 0 <= t <= 1; six coordinates, x before y. Raises
    ValueError for another kind, another coordinate count, or a parent edge with length zero."""

    kind: str
    data: tuple[Rational, ...]

    def __post_init__(self) -> None:
        if self.kind not in KINDS or len(self.data) != 6:
            raise ValueError("a moving segment has the kind S or T and six coordinates")
        if not any(self.direction()):
            raise ValueError("the parent edge of a moving segment has length zero")

    def direction(self) -> Point:
        """The parent edge's direction, the same at all s."""
        x = self.data if self.kind == "S" else self.data[2:]
        return x[2] - x[0], x[3] - x[1]

    def at(self, s: Rational) -> Segment:
        """Return both ends at scale s, for t = 0 and t = 1. Exact."""
        a, b, c, d, e, f = self.data
        if self.kind == "S":
            return (s * a + e, s * b + f), (s * c + e, s * d + f)
        return (s * a + c, s * b + d), (s * a + e, s * b + f)


def s_edge(p0: Any, p1: Any, q: Any) -> MovingSegment:
    """Make the S-edge from P's edge p0 p1 and Q's vertex q."""
    return MovingSegment("S", rationals((*p0, *p1, *q)))


def t_edge(p: Any, q0: Any, q1: Any) -> MovingSegment:
    """Make the T-edge from Q's edge q0 q1 and P's vertex p."""
    return MovingSegment("T", rationals((*p, *q0, *q1)))


def cross(u: Point, v: Point) -> Rational:
    return u[0] * v[1] - u[1] * v[0]


def parallel(first: MovingSegment, second: MovingSegment) -> bool:
    """Tell whether the parents have equal or opposite directions, and so at every scale."""
    return cross(first.direction(), second.direction()) == 0


def point_text(point: Point) -> list[str]:
    return [text(point[0]), text(point[1])]
