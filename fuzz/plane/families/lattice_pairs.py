"""Pairs on a few points of the lattice, where much happens at once: several parts, holes that touch
their outer ring, parts that touch, sides of the axes; a segment or a point as either operand."""

from __future__ import annotations

import random

from minkref.fuzz.geometry.plane import Shape
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import SCALES, is_valid, shape_text
from minkref.fuzz.plane.families.integer_rings import (
    Node,
    Ring,
    counter_clockwise,
    is_simple,
    on_grid_cells,
    scattered,
    untangled,
)
from minkref.fuzz.plane.families.random_pairs import Pair, random_holes

LOW, HIGH = -3, 5
FEWEST, MOST = 8, 16  # the most vertices of an operand, at the beginning and later
GROWTH = 160


def lattice_pair(seed: int, index: int) -> Pair:
    """A pair with whole coordinates from -3 to 5 in both operands, whatever the scale."""
    dice = Dice(f"minkref lattice {seed} {index}")
    small = dice.random() < 0.4
    most = FEWEST + min(index, GROWTH) * (MOST - FEWEST) // GROWTH
    P, Q = (lattice_operand(dice, small, most) for _ in range(2))
    if dice.random() < 0.2:
        P, Q = _thin(dice), Q
        if dice.random() < 0.5:
            P, Q = Q, P
    scale = dice.choice(SCALES) if index > 60 and dice.random() < 0.25 else "1"
    return Pair(seed, index, HIGH - LOW, P, Q, scale)


def lattice_operand(dice: random.Random, small: bool, most: int) -> str:
    """A region as JSON text. Small regions have up to three triangles, boxes and so on with few
    directions: two of them have many parallel edges."""
    while True:
        outers: list[Ring] = []
        shape: Shape = []
        for _ in range(dice.choice((2, 2, 3) if small else (1, 1, 2, 2, 3))):
            outers.append(
                _moved(dice, _outer(dice, small), [node for ring in outers for node in ring])
            )
            holes: list[Ring] = []
            if not small and dice.random() < 0.5:
                holes = random_holes(dice, outers[-1], 2, touching=dice.random() < 0.6)
            shape.append([[*ring] for ring in (outers[-1], *holes)])
        if sum(len(ring) for part in shape for ring in part) > most:
            continue
        text = shape_text(shape)
        if is_valid(text):
            return text


def _outer(dice: random.Random, small: bool) -> Ring:
    """Counter-clockwise, its least coordinates zero at the least."""
    while True:
        side = dice.choice((1, 1, 2) if small else (2, 3, 4, 6, 8))
        kind = dice.random()
        ring: Ring | None
        if kind < 0.4:
            ring = [(dice.randint(0, side), dice.randint(0, side)) for _ in range(3)]
        elif kind < 0.65:
            x, y = dice.randint(1, side), dice.randint(1, side)
            ring = [(0, 0), (x, 0), (x, y), (0, y)]
        elif kind < 0.75:
            ring = on_grid_cells(dice, side, 8)
        else:
            ring = untangled(scattered(dice, dice.randint(4, 7), side, side))
        if ring is not None and is_simple(ring):
            return counter_clockwise(ring)


def _moved(dice: random.Random, ring: Ring, vertices: list[Node]) -> Ring:
    """Moves the ring anywhere within the bounds; or a vertex of the ring to a given vertex."""
    if vertices and dice.random() < 0.6:
        (a, b), (c, d) = dice.choice(ring), dice.choice(vertices)
        moved = [(x + c - a, y + d - b) for x, y in ring]
        if all(LOW <= n <= HIGH for node in moved for n in node):
            return moved
    least = [min(node[axis] for node in ring) for axis in (0, 1)]
    most = [max(node[axis] for node in ring) for axis in (0, 1)]
    dx, dy = (dice.randint(LOW - least[axis], HIGH - most[axis]) for axis in (0, 1))
    return [(x + dx, y + dy) for x, y in ring]


def _thin(dice: random.Random) -> str:
    """A segment, or one time in five a point."""
    a, b, c, d = (dice.randint(LOW, HIGH) for _ in range(4))
    if dice.random() < 0.3:
        c, d = dice.choice(((a, d), (c, b)))
    is_point = dice.random() < 0.2 or (a, b) == (c, d)
    return shape_text([[[(a, b)] if is_point else [(a, b), (c, d)]]])
