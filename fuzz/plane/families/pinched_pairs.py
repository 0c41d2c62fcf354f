"""Small regions on the lattice whose rings touch, at vertices or within edges, once or several
times, beside a segment, a point or another region."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref.fuzz.geometry.plane import Point, Ring, Shape, box, doubled_area
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import PATIENCE, is_valid, shape_text
from minkref.fuzz.plane.families.random_pairs import Pair

LOW, HIGH = -3, 5
MOST_VERTICES = 16


def pinched_pair(seed: int, index: int) -> Pair:
    """A pair at scale 1; coordinates are from -3 to 5, whole but for middles of edges. Every second
    pair has a segment, and every tenth a point."""
    dice = Dice(f"minkref pinched {seed} {index}")
    pinched = pinched_shape(dice)
    other: Shape
    if index % 10 == 9:
        other = [[[_node(dice)]]]
    elif index % 2 == 0:
        other = [[_segment(dice, pinched)]]
    else:
        other = pinched_shape(dice) if dice.random() < 0.5 else _start(dice)
    P, Q = (shape_text(shape) for shape in (pinched, other))
    if dice.random() < 0.5:
        P, Q = Q, P
    return Pair(seed, index, HIGH - LOW, P, Q, "1")


def pinched_shape(dice: random.Random) -> Shape:
    """A region with one to four touches."""
    while True:
        shape, touches = _start(dice), 0
        wanted = dice.randint(1, 4)
        for _ in range(12 * wanted):
            fuller = _with_one_more(dice, shape)
            if sum(len(ring) for part in fuller for ring in part) > MOST_VERTICES:
                continue
            if is_valid(shape_text(fuller)):
                shape, touches = fuller, touches + 1
            if touches == wanted:
                return shape
        if touches:
            return shape


def _start(dice: random.Random) -> Shape:
    for _ in range(PATIENCE):
        if dice.random() < 0.3:
            x, y = dice.randint(LOW, HIGH - 2), dice.randint(LOW, HIGH - 2)
            ring = box(x, y, dice.randint(2, HIGH - x), dice.randint(2, HIGH - y))
        else:
            ring = [_node(dice) for _ in range(dice.randint(3, 6))]
        if Fraction(doubled_area(ring)) ** 2 > 12**2 and is_valid(shape_text([[ring]])):
            return [[ring]]
    return [[box(LOW, LOW, HIGH - LOW, HIGH - LOW)]]


def _with_one_more(dice: random.Random, shape: Shape) -> Shape:
    """A ring more, which comes to one to three points of the boundary: a hole, or a part."""
    contacts = [_on_boundary(dice, shape) for _ in range(dice.choice((1, 1, 2, 3)))]
    corners = dice.choice((3, 3, 4))
    ring: Ring = (contacts + [_node(dice) for _ in range(corners)])[:corners]
    dice.shuffle(ring)
    if doubled_area(ring) == 0:
        return [*shape, [ring]]  # will be refused
    k = dice.randrange(len(shape))
    if dice.random() < 0.7:
        return [*shape[:k], [*shape[k], ring], *shape[k + 1 :]]
    return [*shape, [ring]]


def _on_boundary(dice: random.Random, shape: Shape) -> Point:
    """A vertex, or a point inside an edge: the midpoint or a lattice point."""
    ring = dice.choice(dice.choice(shape))
    k = dice.randrange(len(ring))
    a, b, c, d = (Fraction(n) for n in (*ring[k - 1], *ring[k]))
    if dice.random() < 0.4:
        return a, b
    steps = int(max(abs(c - a), abs(d - b)))
    shares = [Fraction(n, steps) for n in range(1, steps)]
    within = [(a + (c - a) * share, b + (d - b) * share) for share in shares]
    whole = [p for p in within if p[0].denominator == p[1].denominator == 1]
    return dice.choice(whole) if whole else ((a + c) / 2, (b + d) / 2)


def _segment(dice: random.Random, other: Shape) -> Ring:
    """Half the time along an edge of the other operand or between two of its vertices."""
    x, y = _node(dice)
    while True:
        kind = dice.random()
        ring = dice.choice(dice.choice(other))
        k = dice.randrange(len(ring))
        if kind < 0.3:
            (a, b), (c, d) = ring[k - 1], ring[k]
        elif kind < 0.5:
            (a, b), (c, d) = ring[k], dice.choice(dice.choice(dice.choice(other)))
        elif kind < 0.7:
            (a, b), (c, d) = (0, 0), dice.choice(((1, 0), (0, 1), (1, 1), (1, -1)))
        else:
            (a, b), (c, d) = _node(dice), _node(dice)
        share = dice.choice((1, 1, 1, -1, Fraction(1, 2)))
        if (a, b) != (c, d):
            return [(x, y), (x + (c - a) * share, y + (d - b) * share)]


def _node(dice: random.Random) -> Point:
    return dice.randint(LOW, HIGH), dice.randint(LOW, HIGH)
