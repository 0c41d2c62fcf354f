"""Single rings of a marked form: combs, stars, spirals."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref.fuzz.geometry.plane import Point, Ring, Shape, box
from minkref.fuzz.plane.families.drawing import around, convex, family


@family("comb")
def comb_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """A comb, and one that interlocks with it, exactly or nearly; or a box as wide as a gap."""
    kind = dice.random()
    count = max(2, size // (8 if kind < 0.6 else 4) - 1)
    widths = [Fraction(dice.randint(1, 6), dice.randint(1, 3)) for _ in range(count)]
    gaps = [Fraction(dice.randint(1, 6), dice.randint(1, 3)) for _ in range(count - 1)]
    P = comb(dice, widths, gaps)
    slack = dice.choice((0, 0, Fraction(-1, 7), Fraction(1, 7), Fraction(1, 2)))
    if kind < 0.4 and count > 2:
        inner = [max(Fraction(1, 9), gap - slack) for gap in gaps]
        rest = [
            width + (gap - made) for width, gap, made in zip(widths[1:], gaps, inner, strict=False)
        ]
        return [[P]], [[[(-x, -y) for x, y in comb(dice, inner, rest[: len(inner) - 1])]]]
    if kind < 0.6:
        return [[P]], [[comb(dice, widths[: max(2, count // 2)], gaps[: max(1, count // 2 - 1)])]]
    width = max(Fraction(1, 9), dice.choice(gaps) - slack)
    return [[P]], [[box(-1, 0, width, Fraction(dice.randint(1, 5), 2))]]


def comb(dice: random.Random, widths: list[Fraction], gaps: list[Fraction]) -> Ring:
    """Teeth with these widths and gaps, on a back of height 1."""
    ring: Ring = [(0, 0)]
    total = sum(widths, Fraction(0)) + sum(gaps, Fraction(0))
    ring.append((total, 0))
    x = total
    even = dice.random() < 0.5
    top = Fraction(dice.randint(2, 6))
    for k in range(len(widths) - 1, -1, -1):
        height = top if even else Fraction(dice.randint(3, 12), 2)
        ring += [(x, height), (x - widths[k], height)]
        x -= widths[k]
        if k:
            ring += [(x, 1), (x - gaps[k - 1], 1)]
            x -= gaps[k - 1]
    return ring


@family("star")
def star_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    kind = dice.random()
    tips = max(3, size // (4 if kind < 0.5 else 2) - 1)
    P = star(dice, tips)
    if kind < 0.5:
        return [[P]], [[star(dice, max(3, size // 2 - tips))]]
    if kind < 0.75:
        return [[P]], [[convex(dice, 5, dice.randint(1, 12))]]
    return [[P]], [[box(0, 0, dice.randint(1, 9), dice.randint(1, 9))]]


def star(dice: random.Random, tips: int) -> Ring:
    """Points near two circles in turn; the inner one may be very small."""
    radius = max(20, 3 * tips)
    share = dice.choice((2, 3, 5, 8))
    ring = around(2 * tips, radius)
    return [
        p if k % 2 == 0 else (Fraction(p[0], share), Fraction(p[1], share))
        for k, p in enumerate(ring)
    ]


@family("spiral")
def spiral_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """A wall in a spiral; against it a box near the width of the way, a spiral or a triangle."""
    kind = dice.random()
    legs = max(3, size // (4 if kind < 0.4 else 2) - 2)
    pitch = dice.randint(2, 5)
    wall = Fraction(dice.randint(1, 3), dice.choice((2, 4)))
    wall = min(wall, Fraction(pitch, 2))
    P = spiral(legs, pitch, wall)
    if kind < 0.4:
        return [[P]], [[spiral(max(3, size // 2 - legs - 2), pitch, wall)]]
    way = pitch - wall
    side = max(Fraction(1, 9), way + dice.choice((0, 0, Fraction(-1, 8), Fraction(1, 8), -way / 2)))
    if kind < 0.8:
        return [[P]], [[box(0, 0, side, side)]]
    return [[P]], [[[(0, 0), (side, 0), (side / 2, side)]]]


def spiral(legs: int, pitch: int, wall: Fraction) -> Ring:
    """A rectangular spiral: its middle line made as thick as `wall`."""
    ways = ((1, 0), (0, 1), (-1, 0), (0, -1))
    line: list[Point] = [(0, 0)]
    for k in range(legs):
        dx, dy = ways[k % 4]
        length = pitch * (k // 2 + 1)
        line.append((line[-1][0] + dx * length, line[-1][1] + dy * length))
    half = wall / 2
    left: Ring = []
    right: Ring = []
    for k, (x, y) in enumerate(line):
        sides = [ways[j % 4] for j in (k - 1, k) if 0 <= j < legs]
        nx, ny = -sum(way[1] for way in sides), sum(way[0] for way in sides)
        left.append((x + half * nx, y + half * ny))
        right.append((x - half * nx, y - half * ny))
    return left + right[::-1]
