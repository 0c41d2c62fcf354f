"""Sets for judges of features: ties in one half, small shifts of all vertices in the second."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from fractions import Fraction

from minkref import _core
from minkref.fuzz.features import place_draws
from minkref.fuzz.geometry.plane import Number, Point, Ring, Shape, box, mapped, moved, read_shape
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.families.drawing import is_valid, shape_text

MOST = 40  # vertices
GENERATED = ("random", "holes", "collinear", "touching", "cells", "nested", "comb", "star",
             "rational", "lattice", "spiral")  # fmt: skip
SHIFTS = 10_000  # of a unit, the denominator of shifts
TANGENTS = ((4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3), (-5, 0), (-4, -3), (-3, -4), (0, -5),
            (3, -4), (4, -3), (5, 0))  # fmt: skip
Dice = random.Random


def slots(dice: Dice) -> Shape:
    """A block with slots from above, deep and shallow, some alike."""
    x, top = 0, 9
    ring: Ring = []
    alike = dice.randint(1, 4), dice.randint(1, 6)
    for _ in range(dice.randint(1, 4)):
        x += dice.randint(1, 3)
        wide, deep = alike if dice.random() < 0.5 else (dice.randint(1, 5), dice.randint(1, 7))
        ring += [(x, top), (x, top - deep), (x + wide, top - deep), (x + wide, top)]
        x += wide
    x += dice.randint(1, 3)
    return [[[(0, 0), (x, 0), (x, top), *reversed(ring), (0, top)]]]


def bays(dice: Dice) -> Shape:
    """A bay shaped like a T or L, its mouth narrow or wide."""
    half, deep = dice.randint(1, 3), dice.randint(1, 4)
    left, right = (dice.choice((0, dice.randint(1, 4))) for _ in range(2))
    high = dice.randint(1, 4)
    foot = [(half, 0), (half, -deep), (half + right, -deep), (half + right, -deep - high),
            (-half - left, -deep - high), (-half - left, -deep), (-half, -deep),
            (-half, 0)]  # fmt: skip
    wide = half + max(left, right) + dice.randint(1, 3)
    low = -deep - high - dice.randint(1, 3)
    return [[[(-wide, low), (wide, low), (wide, 0), *_once(foot), (-wide, 0)]]]


def streets(dice: Dice) -> Shape:
    """Blocks about a crossing shaped like a T, streets of few widths."""
    a, b = dice.randint(1, 3), dice.randint(1, 3)
    long = dice.randint(2, 6)
    return [
        [box(-long - 1, a, 2 * long + 3, dice.randint(1, 2))],
        [box(-long - b, -long - a, long, long)],
        [box(b, -long - a, long + dice.randint(0, 2), long)],
    ]


def round_holes(dice: Dice) -> Shape:
    """Holes with sides tangent to a circle, one inner node each; and a rectangle."""
    holes: list[Ring] = []
    for k in range(dice.randint(1, 2)):
        while True:
            sides = sorted(dice.sample(range(12), dice.choice((3, 4, 6, 8))))
            turns = [(b - a) % 12 for a, b in zip(sides, [*sides[1:], sides[0]], strict=True)]
            if max(turns) < 6:
                break
        scale = dice.randint(1, 3)
        hole = _tangent_ring([TANGENTS[s] for s in sides], Fraction(scale, 5))
        holes.append(moved([[hole]], 40 * k, dice.randint(-2, 2))[0][0])
    holes.append(box(-4, 30, dice.randint(2, 9), dice.randint(2, 9)))
    return [[box(-35, -35, 110, 90), *(hole[::-1] for hole in holes)]]


def corridors(dice: Dice) -> Shape:
    """Blocks in a row, walls parallel, widths often equal; some shifted, some leaning."""
    y: Number = 0
    lean = dice.choice((0, 0, 1))
    found: Shape = []
    width = dice.randint(1, 3)
    for _ in range(dice.randint(2, 4)):
        x, wide, high = dice.randint(-3, 3), dice.randint(3, 8), dice.randint(1, 3)
        block = box(x, y, wide, high)
        found.append([[(p + lean * q, q) for p, q in block]])
        y += high + (width if dice.random() < 0.7 else dice.randint(1, 4))
    return found


def tips(dice: Dice) -> Shape:
    """Tips, pointed or flat, that face each other."""
    found: Shape = []
    x: Number = 0
    for _ in range(dice.randint(2, 3)):
        near, far = (Fraction(dice.randint(0, 2), 2) for _ in range(2))
        high, wide = dice.randint(2, 4), dice.randint(2, 4)
        y = dice.choice((0, 0, 0, dice.randint(-1, 1)))
        left = [(x, y + near), (x, y - near)]
        right = [(x + 2 * wide, y - far), (x + 2 * wide, y + far)]
        middle = x + wide
        found.append([_once([*left, (middle, y - high), *right, (middle, y + high)])])
        x += 2 * wide + dice.randint(1, 3)
    return found


def islands(dice: Dice) -> Shape:
    """Frames in frames about an island, walls in the middle or not."""
    found: Shape = []
    size = dice.choice((14, 18, 22))
    x = y = 0
    while size > 4 and len(found) < 3:
        wall = dice.randint(1, 2)
        if size - 2 * wall < 3 or dice.random() < 0.2:
            found.append([box(x, y, size, size)])
            break
        found.append([box(x, y, size, size), box(x + wall, y + wall, size - 2 * wall,
                                                 size - 2 * wall)[::-1]])  # fmt: skip
        step = wall + dice.randint(1, 2)
        x, y = x + step, y + (step if dice.random() < 0.7 else wall + 1)
        size -= 2 * (wall + 2)
    return found


def rows(dice: Dice) -> Shape:
    """Blocks in a row, so that many points of the hull are collinear; straight vertices."""
    x, found = 0, []
    for _ in range(dice.randint(2, 4)):
        wide, high = dice.randint(1, 3), dice.choice((2, 2, 2, 1))
        ring = box(x, 0, wide, high)
        if dice.random() < 0.5:
            ring = [(x, 0), (x + Fraction(wide, 2), 0), *ring[1:]]
        found.append([ring])
        x += wide + dice.choice((1, 1, 2, 3))
    return found


def generated(dice: Dice) -> Shape:
    """First operands of generated pairs."""
    family = dice.choice(GENERATED)
    return read_shape(FAMILIES[family].pair(dice.randrange(1000), dice.randrange(600)).P)


def placed(dice: Dice) -> Shape:
    """Sets drawn for the judge of places."""
    return place_draws.KINDS[dice.choice(list(place_draws.KINDS))](dice)


KINDS: dict[str, Callable[[Dice], Shape]] = {
    each.__name__: each
    for each in (
        slots,
        bays,
        streets,
        round_holes,
        corridors,
        tips,
        islands,
        rows,
        generated,
        placed,
    )
}


def drawn_set(seed: int, number: int, most: int = MOST) -> tuple[str, Shape]:
    """A valid set of the kind for this number; in the second ten of twenty its vertices are
    shifted. Equal numbers give equal sets."""
    kind = list(KINDS)[number % len(KINDS)]
    is_shifted = number // len(KINDS) % 2 == 1
    dice = Dice(f"minkref features {seed}:{number}")
    while True:
        shape = KINDS[kind](dice)
        if is_shifted:
            shape = shifted(dice, shape)
        count = sum(len(ring) for polygon in shape for ring in polygon)
        if 3 <= count <= most and is_valid(shape_text(shape)):
            return f"{kind} {'shifted ' if is_shifted else ''}{seed}:{number}", shape


def set_of(shape: Shape) -> _core.PolygonSet:
    return _core.PolygonSet.from_json(shape_text(shape))


def shifted(dice: Dice, shape: Shape) -> Shape:
    """Moves each vertex a little, equal vertices alike."""
    shifts: dict[Point, Point] = {}

    def shift(p: Point) -> Point:
        if p not in shifts:
            x, y = (Fraction(dice.randint(-999, 999), SHIFTS) for _ in range(2))
            shifts[p] = p[0] + x, p[1] + y
        return shifts[p]

    return mapped(shape, shift)


def _once(points: Sequence[Point]) -> Ring:
    return [p for p, q in zip(points, [*points[1:], points[0]], strict=True) if p != q]


def _tangent_ring(ways: list[tuple[int, int]], scale: Fraction) -> Ring:
    """The polygon about a circle of radius 5 scale, tangent where the ways lead."""
    ring: Ring = []
    for (a, b), (c, d) in zip(ways, [*ways[1:], ways[0]], strict=True):
        turn = Fraction(a * d - b * c)
        ring.append((25 * (d - b) * scale / turn, 25 * (a - c) * scale / turn))
    return ring
