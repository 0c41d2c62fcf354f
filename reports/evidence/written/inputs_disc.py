"""Sets and radii for sums with a disc: turned shapes in doubles, walls almost parallel, far away."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

Point = tuple[Fraction, Fraction]
Rings = list[list[Point]]


@dataclass(frozen=True)
class Drawn:
    """A set as text, its rings, and a disc as `disc:` has it."""

    kind: str
    polygons: list[Rings]
    radius: str

    @property
    def rings(self) -> Rings:
        return [ring for polygon in self.polygons for ring in polygon]

    @property
    def text(self) -> str:
        ring = self.rings[0]
        if len(ring) < 3:
            told_points = ", ".join(f"{x} {y}" for x, y in ring)
            return f"{'POINT' if len(ring) == 1 else 'LINESTRING'} ({told_points})"
        told = ["(" + ", ".join(map(_ring, polygon)) + ")" for polygon in self.polygons]
        return f"MULTIPOLYGON ({', '.join(told)})"


def _ring(ring: list[Point]) -> str:
    return "(" + ", ".join(f"{x} {y}" for x, y in (*ring, ring[0])) + ")"


Shape = tuple[list[list[tuple[Fraction, Fraction]]], Fraction]


def rectilinear(draw: random.Random) -> Shape:
    """A block with steps and slots, and a radius of a quarter of a unit, that often closes one."""
    wide = draw.randint(2, 5)
    top = [draw.randint(1, 5) for _ in range(wide)]
    ring: list[tuple[int, int]] = [(0, 0), (wide, 0)]
    for k in reversed(range(wide)):
        ring += [(k + 1, top[k]), (k, top[k])]
    return [_clean(ring)], Fraction(draw.randint(1, 6), 4)


def slotted(draw: random.Random) -> Shape:
    """A block with one slot, as wide as the disc or nearly so."""
    wide = Fraction(draw.randint(1, 8), 4)
    left, deep = draw.randint(1, 3), draw.randint(1, 4)
    w, h = left + wide + draw.randint(1, 3), Fraction(deep + draw.randint(0, 2))
    floor = h - deep + Fraction(draw.randint(0, 3), 4)
    ring = [
        (0, -1),
        (w, -1),
        (w, h),
        (left + wide, h),
        (left + wide, floor),
        (left, floor),
        (left, h),
        (0, h),
    ]
    return [_clean(ring)], wide / 2


def flat(draw: random.Random) -> Shape:
    """A rectangle with a vertex in the middle of a side, straight until it is rounded."""
    w, h = draw.randint(3, 12), draw.randint(2, 8)
    at = Fraction(draw.randint(1, 7), 8)
    ring = [(0, 0), (w, 0), (w, h), (0, h)]
    k = draw.randrange(4)
    (ax, ay), (bx, by) = ring[k], ring[(k + 1) % 4]
    ring.insert(k + 1, (ax + at * (bx - ax), ay + at * (by - ay)))  # type: ignore[arg-type]
    return [_clean(ring, straight=True)], Fraction(draw.randint(1, 12), 8)


def framed(draw: random.Random) -> Shape:
    """A frame around a rectangle, which closes up or nearly so."""
    w, h = draw.randint(1, 5), draw.randint(1, 3)
    a, b = draw.randint(1, 2), draw.randint(1, 2)
    outer = _clean([(-a, -b), (w + a, -b), (w + a, h + b), (-a, h + b)])
    hole = _clean([(0, 0), (0, h), (w, h), (w, 0)])
    return [outer, hole], Fraction(min(w, h), 2) * draw.choice([Fraction(1, 2), Fraction(3, 4), 1])


def _clean(
    ring: list[tuple[object, object]] | list[tuple[int, int]], straight: bool = False
) -> list[Point]:
    points = [(Fraction(x), Fraction(y)) for x, y in ring]  # type: ignore[arg-type]
    points = [p for k, p in enumerate(points) if p != points[k - 1]]
    if straight:
        return points
    return [
        p for k, p in enumerate(points) if _turn(points[k - 1], p, points[(k + 1) % len(points)])
    ]


def _turn(a: Point, b: Point, c: Point) -> Fraction:
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])


SHAPES: dict[str, Callable[[random.Random], Shape]] = {
    "steps": rectilinear, "slot": slotted, "nearly straight vertex": flat, "frame": framed,
}  # fmt: skip


def turned(rings: Rings, draw: random.Random) -> Rings:
    """By any angle, in doubles, as people turn their parts."""
    angle = draw.uniform(-math.pi, math.pi)
    c, s = math.cos(angle), math.sin(angle)
    return [
        [
            (Fraction(c * float(x) - s * float(y)), Fraction(s * float(x) + c * float(y)))
            for x, y in ring
        ]
        for ring in rings
    ]


def tapered(draw: random.Random, less: Fraction) -> tuple[Rings, Fraction]:
    """A slot whose walls are parallel up to a small number; the radius closes it somewhere."""
    left, wide, deep = draw.randint(1, 3), draw.randint(1, 3), draw.randint(1, 5)
    k, m = draw.randint(1, 9), draw.randint(0, 9)
    h = Fraction(deep + 1)
    ring = [
        (0, 0), (left + wide + 1, 0), (left + wide + 1, h), (left + wide + k * less, h),
        (left + wide, 1), (left, 1), (left - m * less, h), (0, h),
    ]  # fmt: skip
    between = draw.choice([Fraction(0), Fraction(1, 4), Fraction(1, 2), Fraction(1)])
    radius = (wide + (k + m) * less * between) / 2
    return [_clean(ring)], radius


def moved(rings: Rings, scale: Fraction, x: Fraction, y: Fraction) -> Rings:
    return [[(scale * p + x, scale * q + y) for p, q in ring] for ring in rings]


def boxes(draw: random.Random) -> tuple[list[Rings], Fraction]:
    """Cells of a grid that do not touch, and a radius at which much happens."""
    cells = [(x, y) for x in range(0, 10, 2) for y in range(0, 10, 2)]
    chosen = draw.sample(cells, draw.randint(2, 5))
    polygons = [
        [[(Fraction(x + u), Fraction(y + v)) for u, v in ((0, 0), (1, 0), (1, 1), (0, 1))]]
        for x, y in chosen
    ]
    return polygons, Fraction(draw.randint(1, 8), 2)


PLACED = {
    "at home": (Fraction(1), Fraction(0), Fraction(0)),
    "on a map": (Fraction(1), Fraction(500_000), Fraction(6_500_000)),
    "on a board in nanometres": (Fraction(10**6), Fraction(10**9), Fraction(3 * 10**9)),
    "huge": (Fraction(10**90), Fraction(0), Fraction(0)),
    "tiny": (Fraction(1, 10**90), Fraction(0), Fraction(0)),
}
LESS = {f"walls parallel up to 1e-{n}": Fraction(1, 10**n) for n in (8, 16, 30)}
OTHERS = (*LESS, *(f"straight, {where}" for where in PLACED), "cells of a grid", "point or segment")


def drawn(seed: int, index: int) -> Drawn:
    """Turned shapes in doubles for even numbers, others for odd ones; which, is drawn."""
    draw = random.Random(f"{seed}:{index}")
    if index % 2 == 0:
        return _turned(draw)
    kind = draw.choice(OTHERS)
    if kind in LESS:
        rings, radius = tapered(draw, LESS[kind])
        return Drawn(kind, [rings], f"disc:{radius}")
    if kind == "cells of a grid":
        polygons, radius = boxes(draw)
        return Drawn(kind, polygons, draw.choice([f"disc:{radius}", f"disc:sqrt:{2 * radius}"]))
    if kind == "point or segment":
        points = [
            (Fraction(draw.randint(-99, 99), 10), Fraction(draw.randint(-99, 99), 7))
            for _ in range(2)
        ]
        return Drawn(kind, [[points[: draw.randint(1, 2)]]], f"disc:{draw.randint(1, 30)}/7")
    shape, radius = SHAPES[draw.choice(list(SHAPES))](draw)
    scale, x, y = PLACED[kind.removeprefix("straight, ")]
    return Drawn(kind, [moved(shape, scale, x, y)], f"disc:{radius * scale}")


def _turned(draw: random.Random) -> Drawn:
    name = draw.choice(list(SHAPES))
    shape, radius = SHAPES[name](draw)
    where = draw.choice(["at home", "at home", "at home", *PLACED])
    scale, x, y = PLACED[where]
    rings = [
        [_rounded(p, x, y) for p in ring]
        for ring in moved(turned(shape, draw), scale, Fraction(0), Fraction(0))
    ]
    told = draw.choice([f"disc:{radius * scale}"] * 4 + [f"disc:sqrt:{radius**2 * scale**2 * 2}"])
    return Drawn(f"turned {name}, {where}", [rings], told)


def _rounded(p: Point, x: Fraction, y: Fraction) -> Point:
    return Fraction(float(p[0] + x)), Fraction(float(p[1] + y))
