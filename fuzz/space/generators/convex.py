"""Convex polyhedra: hulls of grid points, rational spheres, boxes."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.generators.circle import on_sphere
from minkref.fuzz.space.hull import convex_hull


def random_hull(dice: random.Random, count: int, grid: int) -> Polyhedron:
    """The hull of `count` points, at least four, with integer coordinates from 0 to `grid`."""
    while True:
        points = [_whole(*(dice.randint(0, grid) for _ in range(3))) for _ in range(count)]
        try:
            return convex_hull(points)
        except ValueError:
            continue


def sphere(dice: random.Random, count: int, radius: Fraction) -> Polyhedron:
    """The hull of `count` points on a sphere about the origin, and its two poles."""
    points: list[Point] = [(Fraction(0), Fraction(0), Fraction(1))]
    points.append((Fraction(0), Fraction(0), Fraction(-1)))
    while len(points) < count + 2:
        u, v = (Fraction(dice.randint(-24, 24), dice.randint(4, 12)) for _ in range(2))
        point = on_sphere(u, v)
        if point not in points:
            points.append(point)
    try:
        return convex_hull((radius * x, radius * y, radius * z) for x, y, z in points)
    except ValueError:
        return sphere(dice, count, radius)


def box(low: Point, high: Point) -> Polyhedron:
    return convex_hull(
        (x, y, z)
        for x in _ends(low, high, 0)
        for y in _ends(low, high, 1)
        for z in _ends(low, high, 2)
    )


def cube(low: Point, side: Fraction) -> Polyhedron:
    return box(low, (low[0] + side, low[1] + side, low[2] + side))


def _ends(low: Point, high: Point, axis: int) -> tuple[Fraction, Fraction]:
    return low[axis], high[axis]


def _whole(x: int, y: int, z: int) -> Point:
    return (Fraction(x), Fraction(y), Fraction(z))
