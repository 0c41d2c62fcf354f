"""Grid cells, as parts of a set or as holes in a frame, that touch at corners, beside segments and
each other: rings with parallel sides, paired in every way that the definitions allow."""

from __future__ import annotations

import itertools
import random
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from minkref.fuzz.geometry.plane import Point, Ring, Shape, contains, doubled_area, mapped
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import is_valid, shape_text
from minkref.fuzz.plane.families.random_pairs import Pair

Cell = tuple[int, int]
# Each pair of opposite directions once: along the sides, along the diagonals, and in between.
DIRECTIONS = ((1, 0), (0, 1), (1, 1), (1, -1), (2, 1), (1, 2), (2, -1), (1, -2))
WINDOWS = ((None, None), ("1", "2"), ("2", "4"), ("1/2", "1"), ("1/3", "3/2"))
LARGEST_GRID = 5
Window = tuple[str | None, str | None]


@dataclass(frozen=True)
class Touching:
    """Two operands; `name` says which."""

    name: str
    P: str
    Q: str


def beside_segments(side: int) -> Iterator[Touching]:
    """All sets of `touching_sets` with a segment in each direction, both ways about, and with a
    point."""
    for number, shape in enumerate(touching_sets(side)):
        cells = shape_text(shape)
        yield Touching(f"{side} x {side} cells {number}, point", shape_text([[[(0, 0)]]]), cells)
        for way in DIRECTIONS:
            segment = shape_text([[[(0, 0), way]]])
            yield Touching(f"{side} x {side} cells {number}, {way}, P", segment, cells)
            yield Touching(f"{side} x {side} cells {number}, {way}, Q", cells, segment)


def touching_sets(side: int) -> Iterator[Shape]:
    """Yields all sets of cells from a square grid with two cells touching at a corner, up to turns
    and mirror images; the cells as parts, and as holes; the rings paired in each valid way."""
    places = _grid(0, side)
    for share in range(2, len(places)):
        for chosen in itertools.combinations(places, share):
            if chosen != min(_images(chosen, side)):
                continue
            for as_holes in (False, True):
                yield from paired(frozenset(chosen), side, as_holes)


def paired(cells: frozenset[Cell], side: int, as_holes: bool) -> Iterator[Shape]:
    """Yields the set with its rings paired in each valid way; nothing if no cells touch."""
    solid = _framed(cells, side) if as_holes else cells
    touches = _touches(solid)
    if not touches:
        return
    for left in itertools.product((True, False), repeat=len(touches)):
        shape = _traced(solid, dict(zip(touches, left, strict=True)))
        if shape is not None and is_valid(shape_text(shape)):
            yield shape


def random_cells(seed: int, index: int) -> Pair:
    """Cells of a grid of two to five to a side, sheared as often as not, beside a random segment;
    every third pair beside other touching cells."""
    dice = Dice(f"minkref touching cells {seed} {index}")
    first = _drawn(dice, dice.randint(2, LARGEST_GRID))
    second: Shape
    if index % 3 == 2:
        second = _drawn(dice, dice.randint(2, 3))
    else:
        second = [[[_node(dice), _node(dice)]]]
        while second[0][0][0] == second[0][0][1]:
            second = [[[_node(dice), _node(dice)]]]
    P, Q = (shape_text(shape) for shape in (first, second))
    if dice.random() < 0.5:
        P, Q = Q, P
    return Pair(seed, index, LARGEST_GRID, P, Q, "1")


def window_of(index: int) -> Window:
    """Each in turn, whatever the index modulo 2, 3, 10 or 17 stands for."""
    return WINDOWS[(index + index // 10) % len(WINDOWS)]


def _drawn(dice: random.Random, side: int) -> Shape:
    shear = dice.choice((0, 0, 1, -1, Fraction(1, 2)))
    while True:
        cells = frozenset(cell for cell in _grid(0, side) if dice.random() < 0.5)
        as_holes = dice.random() < 0.5
        solid = _framed(cells, side) if as_holes else cells
        touches = _touches(solid)
        if not touches:
            continue
        shape = _traced(solid, {touch: dice.random() < 0.5 for touch in touches})
        if shape is not None and is_valid(shape_text(shape)):
            return mapped(shape, lambda p: (p[0] + shear * p[1], p[1]))


def _node(dice: random.Random) -> Point:
    return dice.randint(-2, 3), dice.randint(-2, 3)


def _grid(low: int, high: int) -> list[Cell]:
    return [(x, y) for x in range(low, high) for y in range(low, high)]


def _images(cells: tuple[Cell, ...], side: int) -> Iterator[tuple[Cell, ...]]:
    last = side - 1
    for _ in range(4):
        cells = tuple(sorted((last - y, x) for x, y in cells))
        yield cells
        yield tuple(sorted((y, x) for x, y in cells))


def _framed(cells: frozenset[Cell], side: int) -> frozenset[Cell]:
    """A square with room around the cells, without the cells."""
    return frozenset(_grid(-1, side + 1)) - cells


def _touches(solid: frozenset[Cell]) -> list[Point]:
    """Returns corners at which two cells of the set touch, with no side between cells of the
    set."""
    corners = {(x + i, y + j) for x, y in solid for i in (0, 1) for j in (0, 1)}
    found: list[Point] = []
    for x, y in sorted(corners):
        around = [(x + i, y + j) in solid for i, j in ((0, 0), (-1, 0), (-1, -1), (0, -1))]
        if around in ([True, False, True, False], [False, True, False, True]):
            found.append((x, y))
    return found


def _traced(solid: frozenset[Cell], turns_left: dict[Point, bool]) -> Shape | None:
    """The set with the rings that turn so at the touches; None where a ring passes a point
    twice."""
    leaving: dict[Point, list[Point]] = {}
    for x, y in sorted(solid):
        corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
        for k, (dx, dy) in enumerate(((0, -1), (1, 0), (0, 1), (-1, 0))):
            if (x + dx, y + dy) not in solid:
                leaving.setdefault(corners[k], []).append(corners[(k + 1) % 4])
    rings: list[Ring] = []
    while leaving:
        start = min(leaving)
        ring: Ring = [start]
        at, to = start, leaving[start][0]
        while True:
            leaving[at].remove(to)
            if not leaving[at]:
                del leaving[at]
            if to == start:
                if start in turns_left and _next(at, to, ring[1:2], turns_left) != ring[1]:
                    return None
                break
            if to in ring:
                return None
            ring.append(to)
            at, to = to, _next(at, to, leaving[to], turns_left)
        after = ring[1:] + ring[:1]
        rings.append([p for k, p in enumerate(ring) if _bends(ring[k - 1], p, after[k])])
    outer = sorted((r for r in rings if doubled_area(r) > 0), key=doubled_area)
    shape: Shape = [[ring] for ring in outer]
    for hole in rings:
        if doubled_area(hole) > 0:
            continue
        inside = _beside(hole)
        next(part for part in shape if contains([part[:1]], inside)).append(hole)
    return shape


def _next(at: Point, to: Point, ways: list[Point], turns_left: dict[Point, bool]) -> Point:
    if to not in turns_left:
        return ways[0]
    x, y = to[0] - at[0], to[1] - at[1]
    left = (to[0] - y, to[1] + x)
    right = (to[0] + y, to[1] - x)
    return left if turns_left[to] else right


def _bends(a: Point, b: Point, c: Point) -> bool:
    return (b[0] - a[0]) * (c[1] - b[1]) != (b[1] - a[1]) * (c[0] - b[0])


def _beside(ring: Ring) -> Point:
    """Returns the middle of the cell on the left of a ring's first unit step."""
    (ax, ay), (bx, by) = ring[0], ring[1]
    x, y = (bx > ax) - (bx < ax), (by > ay) - (by < ay)
    return ax + Fraction(x - y, 2), ay + Fraction(y + x, 2)
