"""Valid operands to damage, on small whole numbers, and the coordinates for writing them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random

from minkref.degeneracies.plane.shapes import MAPS, framed, turned
from minkref.fuzz.geometry.plane import Point, Polygon, Ring, Shape, box, moved
from minkref.fuzz.geometry.plane import extent as extent_of
from minkref.fuzz.plane.families.drawing import convex
from minkref.fuzz.plane.families.hard_numbers import polygon

DECIMAL_FACTORS = tuple(Fraction(n, d) for n, d in (
    (1, 1), (1, 1), (1, 2), (3, 4), (10, 1), (7, 5), (1, 1000),
))  # fmt: skip
OTHER_FACTORS = tuple(Fraction(n, d) for n, d in ((1, 1), (1, 3), (5, 7), (22, 7), (1, 99)))
SIZES = tuple(Fraction(1, 2**k) for k in (5, 8, 12, 16, 20, 24))


def region(dice: Random, parts: int = 0) -> Shape:
    """One polygon or several (`parts`: so many), with holes or not; some touch at vertices."""
    parts = parts or dice.choice((1, 1, 1, 2, 3))
    shape: Shape = []
    x = y = 0
    for _ in range(parts):
        part = one_polygon(dice)
        left, low, width, height = (int(n) for n in extent_of(part[0]))
        shape += moved([part], x - left, y - low)
        x += width + dice.randint(1, 5)
        if dice.random() < 0.2:
            y += height
    for rings in shape:
        for ring in rings:
            k = dice.randrange(len(ring))
            ring[:] = [*ring[k:], *ring[:k]]
    return shape


def one_polygon(dice: Random) -> Polygon:
    """The outer ring counter-clockwise, holes clockwise."""
    outer, *holes = _drawn(dice)
    return [turned(outer)[::-1], *(turned(hole) for hole in holes)]


def _drawn(dice: Random) -> Polygon:
    kind = dice.random()
    if kind < 0.3:
        return [convex(dice, dice.randint(4, 9), 14)]
    if kind < 0.6:
        return polygon(dice, dice.randint(4, 14))
    if kind < 0.75:
        return framed([convex(dice, dice.randint(3, 6), 8)])
    if kind < 0.85:
        return touching(dice)
    holes: list[Ring] = []
    for k in range(dice.randint(2, 4)):
        holes += moved([[convex(dice, dice.randint(3, 5), 5)]], 7 * k, dice.randint(0, 2))[0]
    return framed(holes)


def touching(dice: Random) -> Polygon:
    """A box with two holes that touch each other, and perhaps the box."""
    width, high = dice.randint(3, 6), dice.randint(2, 5)
    first, second = box(0, 0, width, high), box(width, high, 3, 3)
    margin = dice.choice((0, 1))
    outer: Ring = [(-1, -1), (width + 4, -1), (width + 4, high + 4), (-1, high + 4)]
    if not margin:
        outer.insert(3, (width, high + 4))
        second = [(width, high), (width + 3, high + 1), (width, high + 4)]
    return [outer, turned(first), turned(second)]


def thin(dice: Random) -> Shape:
    """A point or a segment."""
    a: Point = (dice.randint(-9, 9), dice.randint(-9, 9))
    b: Point = (int(a[0]) + dice.randint(1, 9), dice.randint(-9, 9))
    return [[[a]]] if dice.random() < 0.5 else [[[a, b]]]


def coordinates(dice: Random, decimal: bool) -> Callable[[Point], Point]:
    """A linear map with positive determinant and a translation. `decimal`: finite decimals stay
    finite."""
    a, b, c, d = dice.choice(MAPS)
    factor = dice.choice(DECIMAL_FACTORS if decimal else DECIMAL_FACTORS + OTHER_FACTORS)
    dx, dy = (dice.randint(-40, 40) for _ in range(2))

    def change(p: Point) -> Point:
        return (factor * (a * p[0] + b * p[1]) + dx, factor * (c * p[0] + d * p[1]) + dy)

    return change


@dataclass(frozen=True)
class Spot:
    """A place within an edge with room around: no other edge comes near. The spot's coordinates run
    along the edge and into the set, from -3 to 3."""

    polygon: int
    ring: int
    edge: int  # from this vertex of the ring
    at: Point
    along: Point

    def point(self, x: int | Fraction, y: int | Fraction) -> Point:
        (px, py), (dx, dy) = self.at, self.along
        return (px + x * dx - y * dy, py + x * dy + y * dx)

    def points(self, *places: tuple[int | Fraction, int | Fraction]) -> Ring:
        return [self.point(x, y) for x, y in places]


def spot(dice: Random, shape: Shape, outer: bool = False) -> Spot:
    """On any ring, or on an outer one."""
    while True:
        p = dice.randrange(len(shape))
        r = 0 if outer else dice.randrange(len(shape[p]))
        ring = shape[p][r]
        k = dice.randrange(len(ring))
        a, b = ring[k], ring[(k + 1) % len(ring)]
        t = dice.choice((Fraction(1, 2), Fraction(1, 4), Fraction(3, 4), Fraction(2, 5)))
        at = (a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t)
        for size in SIZES:
            along = ((b[0] - a[0]) * size, (b[1] - a[1]) * size)
            found = Spot(p, r, k, at, along)
            corners = found.points((-4, -4), (4, -4), (4, 4), (-4, 4))
            others = [edge for edge in edges(shape) if edge != (a, b)]
            if all(apart(corners, *edge) for edge in others):
                return found


def edges(shape: Shape) -> list[tuple[Point, Point]]:
    return [
        (a, b)
        for rings in shape
        for ring in rings
        for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)
    ]


def apart(corners: Sequence[Point], a: Point, b: Point) -> bool:
    """Whether a line along the segment or along an axis parts it from the corners: if so they do
    not meet."""
    for i in (0, 1):
        low, high = min(p[i] for p in corners), max(p[i] for p in corners)
        if max(a[i], b[i]) < low or min(a[i], b[i]) > high:
            return True
    sides = [(b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) for p in corners]
    return min(sides) > 0 or max(sides) < 0
