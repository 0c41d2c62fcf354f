"""Rings that touch at points: chains of holes, polygons corner to corner, and unions of grid
cells."""

from __future__ import annotations

import json
import random
from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.plane import Point, Polygon, Ring, Shape, box
from minkref.fuzz.plane.families.drawing import convex, family, shape_text


@family("touching")
def touching_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """A chain of diamonds, a pinwheel of holes, or polygons corner to corner; Q small against them,
    or the same kind of shape. Or boxes spaced so that their sums with Q touch."""
    if dice.random() < 0.25:
        return _apart(dice, max(2, size // 4 - 1))
    P = touching_shape(dice, max(8, size - 4))
    kind = dice.random()
    if kind < 0.3:
        return P, [[box(0, 0, *(Fraction(dice.randint(1, 4), 4) for _ in range(2)))]]
    if kind < 0.7:
        share = dice.choice((Fraction(1, 8), Fraction(1, 4), Fraction(1, 2)))
        Q = convex(dice, 4, 4)
        return P, [[[(x * share, y * share) for x, y in Q]]]
    return touching_shape(dice, max(8, size // 2)), touching_shape(dice, max(8, size // 2))


def touching_shape(dice: random.Random, size: int) -> Shape:
    kind = dice.random()
    if kind < 0.4:
        return [_chain(dice, max(1, (size - 4) // 4))]
    if kind < 0.7:
        return [_pinwheel(dice, max(2, (size - 4) // 3))]
    return _corner_to_corner(dice, max(2, size // 4))


def _apart(dice: random.Random, count: int) -> tuple[Shape, Shape]:
    """Lattice cells with gaps as wide as Q: the sum unites cells, which share sides and corners."""
    width, height = Fraction(dice.randint(1, 6), 2), Fraction(dice.randint(1, 6), 2)
    side = 2 if count < 3 else 3 if count < 8 else 4
    places = [(x, y) for x in range(side) for y in range(side)]
    chosen = sorted(dice.sample(places, min(count, len(places) - 1)))
    P: Shape = [[box(x * (1 + width), y * (1 + height), 1, 1)] for x, y in chosen]
    return P, [[box(0, 0, width, height)]]


def _chain(dice: random.Random, count: int) -> Polygon:
    """A box with a row of diamonds, tip to tip; they touch the box at one end, or above."""
    at_left = 0 if count == 1 else dice.randint(0, 1)
    height = dice.randint(2, 4)
    above = 0 if dice.random() < 0.3 else 1
    holes: Polygon = []
    x = at_left
    for _ in range(count):
        half = dice.randint(1, 3)
        up = dice.randint(1, height)
        holes.append(
            [(x, 0), (x + half, -dice.randint(1, height)), (x + 2 * half, 0), (x + half, up)]
        )
        x += 2 * half
    right = 1 if at_left == 0 else dice.randint(0, 1)
    return [box(0, -height - 1, x + right, 2 * height + 1 + above), *holes]


def _pinwheel(dice: random.Random, count: int) -> Polygon:
    """Triangular holes with a common corner, perhaps on the box's side."""
    count = min(count, 12)
    reach = 2 * count + 1
    holes: Polygon = []
    for k in range(count):
        holes.append([(0, 0), (4 * k + 1 - 2 * count, reach), (4 * k + 3 - 2 * count, reach)])
    below = dice.choice((0, 1, 2))
    frame = box(-2 * count - 1, -below, 4 * count + 2, reach + below + 1)
    factor = Fraction(4, reach)
    return [[(x * factor, y * factor) for x, y in ring] for ring in (frame, *holes)]


def _corner_to_corner(dice: random.Random, count: int) -> Shape:
    """Boxes, each from the upper right corner of the one before; some lean."""
    shape: Shape = []
    x = y = 0
    for _ in range(count):
        width, height = dice.randint(1, 4), dice.randint(1, 4)
        ring: Ring = box(x, y, width, height)
        if dice.random() < 0.4:
            del ring[dice.choice((1, 3))]
        shape.append([ring])
        x, y = x + width, y + height
    return shape


@family("cells")
def cells_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """Unions of random grid cells, with arbitrary holes and corners."""
    side = 3 if size < 14 else 4 if size < 28 else 5
    P = cells(dice, side, dice.choice((0.6, 0.75, 0.85)))
    kind = dice.random()
    if kind < 0.5:
        return P, [[box(0, 0, Fraction(dice.randint(1, 4), 3), Fraction(dice.randint(1, 4), 3))]]
    Q = cells(dice, 2 if size < 30 else 3, 0.6)
    share = dice.choice((1, Fraction(1, 2), Fraction(1, 3), Fraction(1, 5)))
    return P, [[[(x * share, y * share) for x, y in ring] for ring in polygon] for polygon in Q]


def cells(dice: random.Random, side: int, share: float) -> Shape:
    """Unites this share of the cells, in canonical form."""
    squares: Shape = [
        [box(x, y, 1, 1)] for x in range(side) for y in range(side) if dice.random() < share
    ]
    union = _core.canonicalize(
        _core.PolygonSet.from_json(shape_text(squares or [[box(0, 0, 1, 1)]]))
    )
    return [
        [[_point(p) for p in ring] for ring in (polygon["outer"], *polygon["holes"])]
        for polygon in json.loads(union[0].canonical_json())["polygons"]
    ]


def _point(texts: list[str]) -> Point:
    return (int(texts[0]), int(texts[1]))
