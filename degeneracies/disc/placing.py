"""Rational directions, and changes of coordinates that keep equal distances equal."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import pi, tan
from random import Random

from minkref.degeneracies.disc.draft import DiscDraft, Spot
from minkref.degeneracies.plane.shapes import turned_left
from minkref.fuzz.geometry.plane import Point, Ring, mapped

TRIPLES = ((3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25), (20, 21, 29), (1, 0, 1), (1, 0, 1))
FACTORS = tuple(Fraction(n, d) for n, d in ((1, 1), (1, 2), (2, 3), (7, 5), (3, 1), (1, 9)))
SHARP = 12  # upper bound on denominators of tangents of half angles


def unit(angle: float, sharp: int = SHARP) -> Spot:
    """Returns a rational unit vector near an angle's direction, from the tangent of the half
    angle."""
    turns, rest = divmod(angle + pi / 4, pi / 2)
    t = Fraction(round(tan((rest - pi / 4) / 2) * sharp), sharp)
    x, y = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    for _ in range(int(turns) % 4):
        x, y = -y, x
    return x, y


def ways_around(dice: Random, count: int, part: float = 1.0) -> list[Spot]:
    """So many directions, counter-clockwise, over a part of a turn, about evenly."""
    step = 2 * pi * part / count
    first = dice.random() * 2 * pi
    return [unit(first + k * step + (dice.random() - 0.5) * step / 4) for k in range(count)]


def frame_at(way: Spot, ring: Sequence[Point]) -> Ring:
    """Converts points from coordinates along a direction and to its left; counter-clockwise."""
    x, y = way
    return turned_left([(a * x - b * y, a * y + b * x) for a, b in ring])


def placed(dice: Random, draft: DiscDraft, far: int = 12) -> DiscDraft:
    """Turned by a rational rotation, grown, and moved."""
    a, b, c = dice.choice(TRIPLES)
    x, y = Fraction(a, c), Fraction(b, c)
    factor = dice.choice(FACTORS)
    dx, dy = (dice.randint(-far, far) for _ in range(2))

    def change(p: Point) -> Spot:
        return factor * (x * p[0] - y * p[1]) + dx, factor * (y * p[0] + x * p[1]) + dy

    places = tuple(change(place) for place in draft.places)
    square = draft.squared_radius * factor**2
    return DiscDraft(mapped(draft.P, change), square, places, draft.were_near)
