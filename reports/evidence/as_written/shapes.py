"""Plane shapes as people draw them: blocks with steps and slots, frames, cells; and their
places."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from fractions import Fraction

Number = int | Fraction
Point = tuple[Fraction, Fraction]
Rings = list[list[Point]]
Shape = tuple[Rings, Fraction]  # and a radius at which something happens

ORIGIN = Fraction(0)
PLACED = {
    "at home": (Fraction(1), ORIGIN, ORIGIN),
    "on a map": (Fraction(1), Fraction(500_000), Fraction(6_500_000)),
    "on a board in nanometres": (Fraction(10**6), Fraction(10**9), Fraction(3 * 10**9)),
    "huge": (Fraction(10**90), ORIGIN, ORIGIN),
    "tiny": (Fraction(1, 10**90), ORIGIN, ORIGIN),
}
LESS = {f"walls parallel up to 1e-{n}": Fraction(1, 10**n) for n in (8, 16, 30)}


def steps(draw: random.Random) -> Shape:
    """A block with steps and slots; a radius of some quarter units often closes one slot."""
    wide = draw.randint(2, 5)
    top = [draw.randint(1, 5) for _ in range(wide)]
    ring = [(0, 0), (wide, 0)]
    for k in reversed(range(wide)):
        ring += [(k + 1, top[k]), (k, top[k])]
    return [_corners(ring)], Fraction(draw.randint(1, 6), 4)


def slot(draw: random.Random) -> Shape:
    """A block with one slot, as wide as the disc."""
    wide = Fraction(draw.randint(1, 8), 4)
    left, deep = draw.randint(1, 3), draw.randint(1, 4)
    w, h = left + wide + draw.randint(1, 3), Fraction(deep + draw.randint(0, 2))
    floor = h - deep + Fraction(draw.randint(0, 3), 4)
    ring: list[tuple[Number, Number]] = [(0, -1), (w, -1), (w, h), (left + wide, h)]
    ring += [(left + wide, floor), (left, floor), (left, h), (0, h)]
    return [_corners(ring)], wide / 2


def flat(draw: random.Random) -> Shape:
    """A rectangle with an extra vertex on a side, straight before rounding."""
    w, h = draw.randint(3, 12), draw.randint(2, 8)
    at = Fraction(draw.randint(1, 7), 8)
    ring = [(Fraction(x), Fraction(y)) for x, y in ((0, 0), (w, 0), (w, h), (0, h))]
    k = draw.randrange(4)
    (ax, ay), (bx, by) = ring[k], ring[(k + 1) % 4]
    ring.insert(k + 1, (ax + at * (bx - ax), ay + at * (by - ay)))
    return [ring], Fraction(draw.randint(1, 12), 8)


def frame(draw: random.Random) -> Shape:
    """A frame around a rectangle, which closes or becomes narrow at the radius."""
    w, h = draw.randint(1, 5), draw.randint(1, 3)
    a, b = draw.randint(1, 2), draw.randint(1, 2)
    outer = _corners([(-a, -b), (w + a, -b), (w + a, h + b), (-a, h + b)])
    hole = _corners([(0, 0), (0, h), (w, h), (w, 0)])
    return [outer, hole], Fraction(min(w, h), 2) * Fraction(draw.randint(2, 4), 4)


SHAPES: dict[str, Callable[[random.Random], Shape]] = {
    "steps": steps, "slot": slot, "nearly straight vertex": flat, "frame": frame,
}  # fmt: skip


def tapered(draw: random.Random, less: Fraction) -> Shape:
    """A slot with almost parallel walls, off by a small number; the radius closes a part."""
    left, wide, deep = draw.randint(1, 3), draw.randint(1, 3), draw.randint(1, 5)
    k, m = draw.randint(1, 9), draw.randint(0, 9)
    w, h = left + wide + 1, deep + 1
    ring: list[tuple[Number, Number]] = [(0, 0), (w, 0), (w, h), (left + wide + k * less, h)]
    ring += [(left + wide, 1), (left, 1), (left - m * less, h), (0, h)]
    return [_corners(ring)], (wide + (k + m) * less * Fraction(draw.choice([0, 1, 2, 4]), 4)) / 2


def cells(draw: random.Random) -> tuple[list[Rings], Fraction]:
    """Separate grid cells, and a radius at which much happens."""
    grid = [(x, y) for x in range(0, 10, 2) for y in range(0, 10, 2)]
    chosen = draw.sample(grid, draw.randint(2, 5))
    polygons = [[_corners([(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)])] for x, y in chosen]
    return polygons, Fraction(draw.randint(1, 8), 2)


def _corners(ring: Sequence[tuple[Number, Number]]) -> list[Point]:
    """The ring without repeated or straight vertices."""
    points = [(Fraction(x), Fraction(y)) for x, y in ring]
    points = [p for k, p in enumerate(points) if p != points[k - 1]]
    n = len(points)
    return [p for k, p in enumerate(points) if _turn(points[k - 1], p, points[(k + 1) % n])]


def _turn(a: Point, b: Point, c: Point) -> Fraction:
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])


def moved(rings: Rings, scale: Fraction, x: Fraction, y: Fraction) -> Rings:
    return [[(scale * p + x, scale * q + y) for p, q in ring] for ring in rings]


def turned(rings: Rings, draw: random.Random, where: str) -> Rings:
    """Turns rings by any angle and then moves them, both in doubles, as people turn their parts."""
    angle = draw.uniform(-math.pi, math.pi)
    c, s = math.cos(angle), math.sin(angle)
    scale, x, y = map(float, PLACED[where])

    def place(p: Point) -> Point:
        a, b = float(p[0]), float(p[1])
        return Fraction(scale * (c * a - s * b) + x), Fraction(scale * (s * a + c * b) + y)

    return [[place(p) for p in ring] for ring in rings]
