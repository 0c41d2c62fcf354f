"""Connected polycubes with a 2-manifold as surface."""

from __future__ import annotations

import random
from itertools import product

from minkref.fuzz.space.cells import Cell, is_manifold, parts

STEPS = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))


def random_polycube(dice: random.Random, count: int) -> frozenset[Cell]:
    """Grows cell by cell, rejecting cells that would make the surface no manifold. Returns `count`
    cells, or fewer if growth got stuck."""
    cells: set[Cell] = {(0, 0, 0)}
    for _ in range(20 * count):
        if len(cells) == count:
            break
        x, y, z = dice.choice(sorted(cells))
        dx, dy, dz = dice.choice(STEPS)
        grown = cells | {(x + dx, y + dy, z + dz)}
        if is_manifold(grown):
            cells = grown
    return frozenset(cells)


def bodies_apart(dice: random.Random, count: int, most: int) -> frozenset[Cell]:
    """Polycubes with up to `most` cells in a row along an axis, one to three cells apart."""
    axis, end, cells = dice.randrange(3), 0, set[Cell]()
    for _ in range(count):
        body = random_polycube(dice, dice.randint(1, most))
        low, high = (extreme(cell[axis] for cell in body) for extreme in (min, max))
        step = [0, 0, 0]
        step[axis] = end - low
        cells |= {(x + step[0], y + step[1], z + step[2]) for x, y, z in body}
        end += high - low + 1 + dice.randint(1, 3)
    return frozenset(cells)


def hollow_box(dice: random.Random, most: int) -> frozenset[Cell]:
    """A box with walls one cell thick, perhaps with a window of one cell."""
    sides = [dice.randint(3, max(3, most)) for _ in range(3)]
    cells = {
        cell
        for cell in product(range(sides[0]), range(sides[1]), range(sides[2]))
        if any(cell[k] in (0, sides[k] - 1) for k in range(3))
    }
    if dice.random() < 0.5:
        axis = dice.randrange(3)
        cells.discard(
            (
                0 if axis == 0 else dice.randint(1, sides[0] - 2),
                0 if axis == 1 else dice.randint(1, sides[1] - 2),
                0 if axis == 2 else dice.randint(1, sides[2] - 2),
            )
        )
    return frozenset(cells)


def frame(dice: random.Random, most: int) -> frozenset[Cell]:
    """A square-section ring: a plate with a hole through it."""
    a, b, h = dice.randint(3, max(3, most)), dice.randint(3, max(3, most)), dice.randint(1, 2)
    return frozenset(
        (x, y, z)
        for x, y, z in product(range(a), range(b), range(h))
        if x in (0, a - 1) or y in (0, b - 1)
    )


def l_prism(arm: int, width: int, height: int, corner: Cell = (0, 0, 0)) -> frozenset[Cell]:
    """Two arms of this length and width along x and y, from a common corner."""
    i, j, k = corner
    return frozenset(
        (x + i, y + j, z + k)
        for x, y, z in product(range(arm), range(arm), range(height))
        if x < width or y < width
    )


def is_connected(cells: frozenset[Cell]) -> bool:
    return len(parts(cells)) == 1
