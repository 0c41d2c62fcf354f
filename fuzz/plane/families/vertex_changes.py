"""Changes of single vertices and coordinates. Each takes the shape, the other operand and the
factor between their sizes, and gives a new shape, valid or not."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction

from minkref.fuzz.geometry.plane import Point, Ring, Shape, mapped

Change = Callable[[random.Random, Shape, Shape, Fraction], Shape]
STEPS = (
    Fraction(1),
    Fraction(1),
    Fraction(1, 2),
    Fraction(1, 3),
    Fraction(1, 2**10),
    Fraction(1, 2**20),
)
FACTORS = tuple(Fraction(n, d) for n, d in ((2, 1), (1, 2), (3, 1), (1, 3), (1024, 1), (1, 1024)))


def some_ring(dice: random.Random, shape: Shape) -> Ring | None:
    rings = [ring for polygon in shape for ring in polygon]
    return dice.choice(rings) if rings else None


def move_vertex(dice: random.Random, shape: Shape, other: Shape, size: Fraction) -> Shape:
    """A vertex by a step along the axes or a diagonal."""
    ring = some_ring(dice, shape)
    if ring:
        k, step = dice.randrange(len(ring)), dice.choice(STEPS)
        dx, dy = dice.choice(((1, 0), (0, 1), (1, 1), (1, -1), (-1, 0), (0, -1)))
        ring[k] = (ring[k][0] + dx * step, ring[k][1] + dy * step)
    return shape


def align_vertex(dice: random.Random, shape: Shape, other: Shape, size: Fraction) -> Shape:
    """Gives a vertex the x or y of another vertex, from either operand."""
    ring = some_ring(dice, shape)
    source = some_ring(dice, dice.choice((shape, shape, other)))
    if ring and source:
        k, p = dice.randrange(len(ring)), dice.choice(source)
        ring[k] = (p[0], ring[k][1]) if dice.random() < 0.5 else (ring[k][0], p[1])
    return shape


def make_parallel(dice: random.Random, shape: Shape, other: Shape, size: Fraction) -> Shape:
    """Turns an edge about its start into a direction of the other operand; sometimes also takes
    over that edge's length."""
    ring, source = some_ring(dice, shape), some_ring(dice, other)
    if not ring or not source or min(len(ring), len(source)) < 2:
        return shape
    k, j = dice.randrange(len(ring)), dice.randrange(len(source))
    (ax, ay), (bx, by) = ring[k - 1], ring[k]
    dx, dy = source[j][0] - source[j - 1][0], source[j][1] - source[j - 1][1]
    reach = max(Fraction(dx), Fraction(dy), Fraction(-dx), Fraction(-dy))
    length = max(Fraction(bx - ax), Fraction(by - ay), Fraction(ax - bx), Fraction(ay - by)) / reach
    if (bx - ax) * dx + (by - ay) * dy < 0:
        length = -length
    if dice.random() < 0.4:
        length = 1 / size if length > 0 else -1 / size
    ring[k] = (ax + length * dx, ay + length * dy)
    return shape


def insert_vertex(dice: random.Random, shape: Shape, other: Shape, size: Fraction) -> Shape:
    """A vertex on an edge, or next to it."""
    ring = some_ring(dice, shape)
    if ring and len(ring) > 2:
        k = dice.randrange(len(ring))
        (ax, ay), (bx, by) = ring[k - 1], ring[k]
        t = Fraction(dice.randint(1, 6), 7)
        off = dice.choice(
            (Fraction(0), Fraction(1, 2**20), Fraction(-1, 2**20), Fraction(1, 2**40))
        )
        ring.insert(k, (ax + t * (bx - ax) - off * (by - ay), ay + t * (by - ay) + off * (bx - ax)))
    return shape


def remove_vertex(dice: random.Random, shape: Shape, other: Shape, size: Fraction) -> Shape:
    ring = some_ring(dice, shape)
    if ring and len(ring) > 3:
        del ring[dice.randrange(len(ring))]
    return shape


def scale_coordinate(dice: random.Random, shape: Shape, other: Shape, size: Fraction) -> Shape:
    """All x, all y or both by a factor."""
    fx, fy = dice.choice(FACTORS), dice.choice(FACTORS)
    kind = dice.randrange(3)

    def change(p: Point) -> Point:
        return (p[0] * fx if kind != 1 else p[0], p[1] * fy if kind == 1 else p[1])

    if kind == 2:
        return mapped(shape, lambda p: (p[0] * fx, p[1] * fx))
    return mapped(shape, change)


VERTEX_CHANGES: tuple[Change, ...] = (
    move_vertex,
    move_vertex,
    align_vertex,
    make_parallel,
    insert_vertex,
    remove_vertex,
    scale_coordinate,
)
