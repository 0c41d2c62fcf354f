"""Small random paths among small random obstacles; a third of them degenerate."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from minkref.api import BadInput, PolygonSet
from minkref.fuzz.geometry.plane import Point, fraction_rings
from minkref.fuzz.plane.families.small_operands import as_set, random_rings

SIZE = 4
SCALES = tuple(map(Fraction, ("1", "2", "1/2", "3/2", "1/3", "7/5")))
Place = tuple[Fraction, Fraction]
KINDS = ("along an edge", "on a critical position", "single place", "corridor")


@dataclass(frozen=True)
class PathCase:
    """`kind`: the case's degeneracy, "general" if none is intended."""

    name: str
    part: PolygonSet
    obstacles: PolygonSet
    path: list[Place]
    kind: str


def path_case(seed: int, index: int) -> PathCase:
    """The same one for the same numbers."""
    dice = random.Random(f"{seed}:{index}")
    kind = KINDS[index // 3 % len(KINDS)] if index % 3 == 0 else "general"
    part = _valid(dice)
    if kind == "corridor":
        return _corridor(dice, f"{seed}:{index}", part)
    obstacles = _valid(dice, dice.randint(6, 10))
    r, o = _corners(part), _corners(obstacles)
    path = [_place(dice)]
    for _ in range(dice.randrange(4)):
        x, y = _place(dice)
        path.append((path[-1][0] + x / 2, path[-1][1] + y / 2))
    if kind == "along an edge":
        a, b = _edge(dice, obstacles)
        x, y = path[-1] if dice.random() < 0.5 else a
        path = [*path[:-1], (x, y), (x + b[0] - a[0], y + b[1] - a[1])]
    elif kind == "on a critical position":
        s, a, b = dice.choice(SCALES), dice.choice(r), dice.choice(o)
        path[dice.randrange(len(path))] = (b[0] - s * a[0], b[1] - s * a[1])
    elif kind == "single place":
        s, a, b = dice.choice(SCALES), dice.choice(r), dice.choice(o)
        path = [(b[0] - s * a[0], b[1] - s * a[1])]
    if dice.random() < 0.15:
        path.append(path[0])
    return PathCase(f"{seed}:{index}", part, obstacles, path, kind)


def case_in_a_hole(seed: int, index: int) -> PathCase:
    """A path in a frame's hole, like a part's path in a container."""
    dice = random.Random(f"hole {seed}:{index}")
    part = _valid(dice)
    while True:
        corners = sorted({(_far(dice), _far(dice)) for _ in range(dice.randint(4, 9))}, key=_angle)
        frame = [(-20, -20), (20, -20), (20, 20), (-20, 20)]
        try:
            obstacles = PolygonSet([[_texts(frame), _texts(corners[::-1])]])
            obstacles.validate("a drawn frame")
        except BadInput:
            continue
        break
    path = [(x / 4, y / 4) for x, y in (_place(dice) for _ in range(dice.randint(1, 4)))]
    return PathCase(f"hole {seed}:{index}", part, obstacles, path, "in a hole")


def case_in_a_corridor(seed: int, index: int) -> PathCase:
    """Between two walls as far apart as the part is high at one scale."""
    name = f"corridor {seed}:{index}"
    dice = random.Random(name)
    return _corridor(dice, name, _valid(dice))


def case_past_a_corner(seed: int, index: int) -> PathCase:
    """A long segment that passes a corner of the obstacles somewhere: the part collides on a short
    stretch."""
    dice = random.Random(f"corner {seed}:{index}")
    part, obstacles = _valid(dice), _valid(dice, 6)
    s, r, o = dice.choice(SCALES), dice.choice(_corners(part)), dice.choice(_corners(obstacles))
    dx, dy = dice.choice([(a, b) for a in range(-3, 4) for b in range(-3, 4) if a or b])
    aside = Fraction(dice.randint(-4, 4), 8)
    x, y = o[0] - s * r[0] - aside * dy, o[1] - s * r[1] + aside * dx
    before, after = dice.randint(5, 30), dice.randint(5, 30)
    path = [(x - before * dx, y - before * dy), (x + after * dx, y + after * dy)]
    return PathCase(f"corner {seed}:{index}", part, obstacles, path, "past a corner")


def _far(dice: random.Random) -> int:
    return dice.choice((-1, 1)) * dice.randint(3, 15)


def _angle(corner: tuple[int, int]) -> float:
    return math.atan2(corner[1], corner[0])


def _texts(ring: Sequence[tuple[int, int]]) -> list[tuple[str, str]]:
    return [(str(x), str(y)) for x, y in ring]


def _valid(dice: random.Random, far: int = 0) -> PolygonSet:
    """A polygon, moved by up to `far`."""
    while True:
        try:
            drawn = as_set(random_rings(dice, SIZE))
            drawn.validate("a drawn polygon")
        except BadInput:
            continue
        x, y = (str(dice.randint(-far, far)) for _ in range(2))
        return drawn.translated(x, y)


def _corridor(dice: random.Random, name: str, part: PolygonSet) -> PathCase:
    """Two walls, and a way along them: contact on both sides at one scale. For a part on one side
    of its origin, no neighbouring scale is valid."""
    part = part.translated("0", dice.choice(("0", "5", "-5")))
    ys = [y for _, y in _corners(part)]
    low, high, s = min(ys), max(ys), dice.choice(SCALES)
    a, b = dice.randint(2, 5), dice.randint(2, 5)
    length = Fraction(dice.randint(0, 6))
    walls = [
        [(-20, s * low - a), (20, s * low - a), (20, s * low), (-20, s * low)],
        [(-20, s * high), (20, s * high), (20, s * high + b), (-20, s * high + b)],
    ]
    obstacles = PolygonSet([[[(str(x), str(y)) for x, y in wall]] for wall in walls])
    start = Fraction(dice.randint(-3, 3))
    return PathCase(
        name, part, obstacles, [(start, Fraction(0)), (start + length, Fraction(0))], "corridor"
    )


def _corners(shape: PolygonSet) -> list[Place]:
    return [point for ring in fraction_rings(shape.to_json()) for point in ring]


def _edge(dice: random.Random, shape: PolygonSet) -> tuple[Place, Place]:
    ring = dice.choice(fraction_rings(shape.to_json()))
    k = dice.randrange(len(ring))
    return ring[k], ring[(k + 1) % len(ring)]


def _place(dice: random.Random) -> Place:
    parts = dice.choice((1, 1, 2, 3))
    reach = 8 * parts
    return (
        Fraction(dice.randint(-reach, reach), parts),
        Fraction(dice.randint(-reach, reach), parts),
    )


def texts(path: Sequence[Point]) -> list[tuple[str, str]]:
    return [(str(x), str(y)) for x, y in path]
