"""Seeded random pairs of polygons with holes on small integer grids.

`random_pair(seed, index)` depends on its two arguments only. Early indices are small: the grid
grows from 4 x 4 to 12 x 12 over the first `GROWTH` pairs and is drawn from all these sizes after
that, so that runs of any length meet small inputs first. Every third pair has no holes. Coordinates
are integers; the reference's own `validate` checks every operand.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass

from minkref import _core
from minkref.exact import set_json
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.integer_rings import (
    Ring,
    counter_clockwise,
    inside,
    is_simple,
    on_grid_cells,
    rings_cross,
    rings_meet,
    scattered,
    untangled,
)

SMALLEST_GRID = 4
LARGEST_GRID = 12
MOST_VERTICES = 12
MOST_HOLES = 3
GROWTH = 1800
OTHER_SCALES = ("1/2", "2/3", "3/2", "2", "3")


@dataclass(frozen=True)
class Pair:
    """Two operands (JSON texts of polygon sets) and the scale of the first."""

    seed: int
    index: int
    grid: int
    P: str
    Q: str
    scale: str

    @property
    def name(self) -> str:
        return f"random:{self.seed}:{self.index}"


def grid_of(index: int, dice: random.Random) -> int:
    """Returns the grid's side for pair `index`: grows first, later drawn from all sizes."""
    if index < GROWTH:
        sizes = LARGEST_GRID - SMALLEST_GRID + 1
        return SMALLEST_GRID + index * sizes // GROWTH
    return dice.randint(SMALLEST_GRID, LARGEST_GRID)


def random_pair(seed: int, index: int) -> Pair:
    """Pair `index` of the sequence `seed`. Some 0.5 to 1 ms."""
    dice = Dice(f"minkref pair {seed} {index}")
    grid = grid_of(index, dice)
    holes = index % 3 != 0
    P = random_operand(dice, grid, MOST_HOLES if holes else 0)
    Q = random_operand(dice, grid, MOST_HOLES if holes and dice.random() < 0.4 else 0, small=True)
    scale = "1"
    if index >= GROWTH and index % 4 == 3:
        scale = dice.choice(OTHER_SCALES)
    if dice.random() < 0.25:
        P, Q = Q, P
    return Pair(seed, index, grid, P, Q, scale)


def random_operand(dice: random.Random, grid: int, most_holes: int, small: bool = False) -> str:
    """A polygon with up to `most_holes` holes inside a random window of the grid, as JSON text."""
    touching = dice.random() < 0.2  # holes may touch the outer ring and each other at points
    patience = 4  # with outer rings that leave no room for a hole
    while True:
        side = _side(dice, grid) if small else grid
        x, y = dice.randint(0, grid - side), dice.randint(0, grid - side)
        roomy = most_holes > 0 and dice.random() < 0.5
        outer = (_cut_box if roomy else dice.choice(_OUTER))(dice, side)
        if outer is None:
            continue
        outer = counter_clockwise([(a + x, b + y) for a, b in outer])
        holes = random_holes(dice, outer, most_holes, touching)
        if most_holes and not holes and patience:
            patience -= 1
            continue
        text = set_json([(outer, [hole[::-1] for hole in holes])])
        try:
            _core.PolygonSet.from_json(text).validate("random operand")
        except _core.BadInput:
            continue
        return text


def _side(dice: random.Random, grid: int) -> int:
    """Draws the window's side for a second operand: often so small that holes of the first
    survive."""
    kind = dice.random()
    if kind < 0.5:
        return dice.randint(1, max(1, grid // 4))
    return dice.randint(2, grid) if kind < 0.85 else grid


def random_holes(dice: random.Random, outer: Ring, most: int, touching: bool) -> list[Ring]:
    """Simple rings inside `outer` (counter-clockwise) with disjoint interiors, some of them as
    large as fits; apart from all others, or else perhaps `touching` them at points."""
    meet = rings_cross if touching else rings_meet
    holes: list[Ring] = []
    if most == 0:
        return holes
    wanted = dice.randint(1, most)
    left, right = min(p[0] for p in outer), max(p[0] for p in outer)
    low, high = min(p[1] for p in outer), max(p[1] for p in outer)
    for attempt in range(6 * wanted):
        if len(holes) == wanted:
            break
        width, height = right - left - 2, high - low - 2
        x, y = left + 1, low + 1
        if attempt > 2 or dice.random() < 0.3:
            width = dice.randint(1, max(1, (right - left) // 2))
            height = dice.randint(1, max(1, (high - low) // 2))
            x, y = dice.randint(left, right - width), dice.randint(low, high - height)
        if min(width, height) < 1:
            continue
        points = [(a + x, b + y) for a, b in scattered(dice, dice.randint(3, 6), width, height)]
        if len(points) < 3 or not inside(points, outer):
            continue
        ring = untangled(points)
        if ring is None:
            continue
        hole = counter_clockwise(ring)
        if meet(hole, outer):
            continue
        if any(meet(hole, other) or inside(hole, other) or inside(other, hole) for other in holes):
            continue
        holes.append(hole)
    return holes


def _untangled_outer(dice: random.Random, side: int) -> Ring | None:
    return untangled(scattered(dice, dice.randint(3, MOST_VERTICES), side, side))


def _cell_outer(dice: random.Random, side: int) -> Ring | None:
    return on_grid_cells(dice, side, MOST_VERTICES)


def _cut_box(dice: random.Random, side: int) -> Ring | None:
    """A box with corners cut off and sides dented: roomy, so that holes find a place in it."""
    width, height = dice.randint(max(1, side // 2), side), dice.randint(max(1, side // 2), side)
    corners = [(0, 0), (width, 0), (width, height), (0, height)]
    ring: Ring = []
    for k, (x, y) in enumerate(corners):
        into = (corners[(k + 1) % 4][0] - x, corners[(k + 1) % 4][1] - y)
        back = (corners[k - 1][0] - x, corners[k - 1][1] - y)
        if dice.random() < 0.4:
            ring.append(_towards((x, y), back, dice.randint(1, max(1, side // 3))))
            ring.append(_towards((x, y), into, dice.randint(1, max(1, side // 3))))
        else:
            ring.append((x, y))
        if dice.random() < 0.35:
            along = dice.randint(1, max(1, side - 1))
            dent = _towards((x, y), into, along)
            ring.append(_towards(dent, back, dice.randint(1, max(1, side // 3))))
    return ring if len(ring) <= MOST_VERTICES and is_simple(ring) else None


def _towards(start: tuple[int, int], direction: tuple[int, int], length: int) -> tuple[int, int]:
    step = ((direction[0] > 0) - (direction[0] < 0), (direction[1] > 0) - (direction[1] < 0))
    return (start[0] + length * step[0], start[1] + length * step[1])


_OUTER: tuple[Callable[[random.Random, int], Ring | None], ...] = (
    _untangled_outer,
    _cell_outer,
    _cut_box,
)
