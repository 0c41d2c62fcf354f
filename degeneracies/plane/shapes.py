"""Tools of the generators: exact rings, counter-clockwise, and changes that keep degeneracies:
a linear map of both operands, translations, a factor between P and the scale."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from random import Random

from minkref.degeneracies.plane.draft import Draft
from minkref.fuzz.geometry.plane import (
    Point,
    Polygon,
    Ring,
    Shape,
    box,
    doubled_area,
    extent,
    mapped,
    moved,
    scaled,
)

Matrix = tuple[int, int, int, int]
MAPS: tuple[Matrix, ...] = (
    (1, 0, 0, 1), (0, -1, 1, 0), (-1, 0, 0, -1), (0, 1, -1, 0), (1, 1, 0, 1), (1, 0, 1, 1),
    (2, 1, 1, 1), (1, -1, 1, 1), (3, -1, 1, 2), (2, 0, 0, 1), (1, 2, -2, 1), (3, 4, -4, 3),
)  # fmt: skip
FACTORS = tuple(Fraction(n, d) for n, d in ((1, 1), (1, 2), (2, 3), (7, 5), (3, 1), (5, 7), (1, 9)))


def turned(ring: Ring) -> Ring:
    """Clockwise, as a hole runs; the first vertex stays."""
    return ring if doubled_area(ring) < 0 else [ring[0], *ring[:0:-1]]


def turned_left(ring: Ring) -> Ring:
    """Counter-clockwise, as outer rings run; the first vertex stays."""
    return ring if doubled_area(ring) > 0 else [ring[0], *ring[:0:-1]]


def framed(holes: Sequence[Ring], margin: int = 2) -> Polygon:
    """A box around holes."""
    x, y, width, height = extent([p for hole in holes for p in hole])
    x0, y0 = x - margin, y - margin
    return [box(x0, y0, width + 2 * margin, height + 2 * margin), *(turned(hole) for hole in holes)]


def corridor(line: Sequence[tuple[int, int]], width: Fraction | int) -> Ring:
    """The points within half the width, in the maximum norm, of a line with upright and level legs,
    where only neighbours touch: the corridor for a square of this width."""
    half = Fraction(width) / 2
    left: Ring = []
    right: Ring = []
    steps = [
        ((b[0] > a[0]) - (b[0] < a[0]), (b[1] > a[1]) - (b[1] < a[1]))
        for a, b in itertools.pairwise(line)
    ]
    before, after = [steps[0], *steps], [*steps, steps[-1]]
    for k, ((x, y), u, v) in enumerate(zip(line, before, after, strict=True)):
        along = (-u[0] if k == 0 else u[0] if k == len(line) - 1 else 0,
                 -u[1] if k == 0 else u[1] if k == len(line) - 1 else 0)  # fmt: skip
        ways = {u, v}
        nx, ny = sum(-way[1] for way in ways), sum(way[0] for way in ways)
        left.append((x + half * (nx + along[0]), y + half * (ny + along[1])))
        right.append((x + half * (along[0] - nx), y + half * (along[1] - ny)))
    ring = [*right, *reversed(left)]
    return ring if doubled_area(ring) > 0 else ring[::-1]


def reflected(ring: Ring) -> Ring:
    return [(-x, -y) for x, y in ring]


def number(dice: Random, low: int, high: int, denominators: Sequence[int] = (1, 2, 3)) -> Fraction:
    return Fraction(dice.randint(low, high), dice.choice(denominators))


def left_of(dice: Random, a: Point, b: Point, reach: int) -> Point:
    """A lattice point to the left of a line."""
    while True:
        p = dice.randint(-reach, reach), dice.randint(-reach, reach)
        if (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0:
            return p


def changed(dice: Random, draft: Draft, far: int = 12) -> Draft:
    """The same in other coordinates: all predicates keep their signs, and scales their order."""
    a, b, c, d = dice.choice(MAPS)

    def linear(shape: Shape) -> Shape:
        return mapped(shape, lambda p: (a * p[0] + b * p[1], c * p[0] + d * p[1]))

    factor = dice.choice(FACTORS)
    P, Q = scaled(linear(draft.P), 1 / factor), linear(draft.Q)
    P, Q = (moved(shape, *(dice.randint(-far, far) for _ in range(2))) for shape in (P, Q))
    return replace(draft, P=P, Q=Q, scale=draft.scale * factor)
