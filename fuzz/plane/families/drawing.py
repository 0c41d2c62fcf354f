"""Shared by the families: exact rings, their sizes by the index of a pair, and how two drawn
operands become a valid pair."""

from __future__ import annotations

import functools
import random
from collections.abc import Callable
from fractions import Fraction

from minkref import _core
from minkref.exact import set_json
from minkref.fuzz.geometry.plane import Ring, Shape, box, doubled_area, mapped, read_shape, scaled
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.random_pairs import Pair

Draw = Callable[[random.Random, int], tuple[Shape, Shape]]

FEWEST, MOST = 12, 60  # vertices of a pair, about: at the beginning, and later
GROWTH = 480
SCALES = ("1/2", "2/3", "7/5", "3/2", "2", "3")
PATIENCE = 200


def vertices_at(index: int, dice: random.Random) -> int:
    """About how many vertices the pair of this index has."""
    limit = FEWEST + min(index, GROWTH) * (MOST - FEWEST) // GROWTH
    return dice.randint(8, limit)


def family(name: str) -> Callable[[Draw], Callable[[int, int], Pair]]:
    """Turns a function that draws two operands into a function that makes the family's pairs, by
    seed and index."""

    def pairs(draw: Draw) -> Callable[[int, int], Pair]:
        @functools.wraps(draw)
        def pair(seed: int, index: int) -> Pair:
            return _drawn_pair(name, seed, index, draw)

        return pair

    return pairs


def _drawn_pair(family: str, seed: int, index: int, draw: Draw) -> Pair:
    """Returns a pair from `draw`, perhaps turned, mirrored and swapped. If the scale is not 1, the
    first operand is divided by it: fits stay fits."""
    dice = Dice(f"minkref {family} {seed} {index}")
    for _ in range(PATIENCE):
        size = vertices_at(index, dice)
        operands = list(draw(dice, size))
        turns, mirrored = dice.randrange(4), dice.random() < 0.3
        if dice.random() < 0.3:
            operands.reverse()
        scale = dice.choice(SCALES) if index > 60 and dice.random() < 0.25 else "1"
        P, Q = (placed(shape, turns, mirrored) for shape in operands)
        if scale != "1":
            P = scaled(P, 1 / Fraction(scale))
        texts = [shape_text(shape) for shape in (P, Q)]
        if all(is_valid(text) for text in texts):
            return Pair(seed, index, size, texts[0], texts[1], scale)
    raise RuntimeError(f"{family}:{seed}:{index} draws nothing valid")


def is_valid(text: str) -> bool:
    try:
        _core.PolygonSet.from_json(text).validate("operand")
    except _core.BadInput:
        return False
    return True


def shape_text(shape: Shape) -> str:
    """JSON text: outer rings counter-clockwise, holes clockwise."""
    return set_json(
        (
            polygon[0] if doubled_area(polygon[0]) >= 0 else polygon[0][::-1],
            [hole if doubled_area(hole) < 0 else hole[::-1] for hole in polygon[1:]],
        )
        for polygon in shape
    )


def reflected(polygons: _core.PolygonSet) -> _core.PolygonSet:
    """-R of a set R: the places at which s R, a part, meets an obstacle O are O + s (-R)."""
    shape = scaled(read_shape(polygons.to_json()), -1)
    return _core.PolygonSet.from_json(shape_text(shape))


def placed(shape: Shape, turns: int, mirrored: bool) -> Shape:
    """Turned about the origin by right angles, then mirrored at the diagonal."""
    for _ in range(turns):
        shape = mapped(shape, lambda p: (-p[1], p[0]))
    return mapped(shape, lambda p: (p[1], p[0])) if mirrored else shape


def around(corners: int, radius: int) -> Ring:
    """Points near a circle about the origin, counter-clockwise, on the whole numbers."""
    ring: Ring = []
    for k in range(corners):
        quarter, rest = divmod(4 * k, corners)
        t = Fraction(rest, corners) * Fraction(9, 10) + Fraction(rest, corners) ** 2 / 10
        x, y = round(radius * (1 - t * t) / (1 + t * t)), round(radius * 2 * t / (1 + t * t))
        for _ in range(quarter):
            x, y = -y, x
        ring.append((x, y))
    return ring


def convex(dice: random.Random, corners: int, reach: int) -> Ring:
    """A convex ring with up to `corners` vertices: random edges in the order of their
    directions."""
    xs = _steps(dice, corners, reach)
    ys = _steps(dice, corners, reach)
    steps: dict[tuple[int, Fraction], tuple[int, int]] = {}
    for dx, dy in zip(xs, ys, strict=True):
        if dx or dy:
            known = steps.get(_direction(dx, dy), (0, 0))
            steps[_direction(dx, dy)] = (known[0] + dx, known[1] + dy)
    ring: Ring = []
    x = y = 0
    for _, (dx, dy) in sorted(steps.items()):
        ring.append((x, y))
        x, y = x + dx, y + dy
    left = min((p[0] for p in ring), default=0)
    low = min((p[1] for p in ring), default=0)
    ring = [(p[0] - left, p[1] - low) for p in ring]
    return ring if len(ring) > 2 else box(0, 0, reach, reach)[:3]


def _steps(dice: random.Random, count: int, reach: int) -> list[int]:
    """Steps there and back along [0, reach]."""
    marks = sorted(dice.randint(0, reach) for _ in range(count))
    up, down = [marks[0]], [marks[0]]
    for mark in marks[1:-1]:
        (up if dice.random() < 0.5 else down).append(mark)
    path = [*up, marks[-1], *down[:0:-1]]
    steps = [path[(k + 1) % len(path)] - path[k] for k in range(len(path))]
    dice.shuffle(steps)
    return steps


def _direction(dx: int, dy: int) -> tuple[int, Fraction]:
    """Grows with the angle from 0 to a full turn."""
    half = 0 if dy > 0 or (dy == 0 and dx > 0) else 1
    dx, dy = (dx, dy) if half == 0 else (-dx, -dy)
    return (half, Fraction(-dx, abs(dx) + dy))
