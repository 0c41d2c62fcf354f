"""Random assemblies possibly holding a part, with ways out; half degenerate."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from minkref.api import PolygonSet
from minkref.fuzz.motion.path_cases import Place, path_case

KINDS = (
    "a door",
    "fit and way end together",
    "a path",
    "valid alone",
    "a bent door",
    "along a wall",
    "two doors",
    "single place",
)
#: Kinds in which contacts coincide, or a range is a single scale.
DEGENERATE = frozenset(KINDS[1::2])
LARGE = Fraction(40)


@dataclass(frozen=True)
class HeldCase:
    name: str
    part: PolygonSet
    obstacles: PolygonSet
    way: list[Place]
    kind: str

    @property
    def is_degenerate(self) -> bool:
        return self.kind in DEGENERATE


def held_case(seed: int, index: int) -> HeldCase:
    """The same one for the same numbers. Kinds take turns."""
    dice = random.Random(f"held {seed}:{index}")
    kind = KINDS[index % len(KINDS)]
    part, obstacles, way = DRAWS[kind](dice, index)
    return HeldCase(f"{seed}:{index}", part, obstacles, way, kind)


Drawn = tuple[PolygonSet, PolygonSet, list[Place]]


AROUND = ((1, 0), (2, 1), (1, 1), (0, 1), (-1, 2), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -2))


def _part(dice: random.Random) -> PolygonSet:
    """A polygon around its origin, star-shaped, four to ten corners; one in four beside it."""
    ring = [
        (dice.randint(2, 5) * x, dice.randint(2, 5) * y)
        for x, y in AROUND
        if 0 in (x, y) or dice.random() < 0.5
    ]
    part = PolygonSet(_sorted(ring)).scaled("1/6")
    return part.translated("1", "0") if dice.random() < 0.25 else part


def _sorted(ring: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Counter-clockwise around the origin, one corner for a direction."""
    by_angle = {round(math.atan2(y, x), 9): (x, y) for x, y in ring}
    return [by_angle[angle] for angle in sorted(by_angle)]


def _room(dice: random.Random, low: int, high: int, bend: int = 0) -> PolygonSet:
    """[0, 12] x [0, 12] within [-2, 14] x [-2, 14], with a door in the right wall."""
    return PolygonSet(
        [
            (-2, -2), (14, -2), (14, low - bend), (12, low), (12, 0), (0, 0), (0, 12), (12, 12),
            (12, high), (14, high + bend), (14, 14), (-2, 14),
        ]
    )  # fmt: skip


def _through(dice: random.Random, low: int, high: int) -> list[Place]:
    """A way from inside the room through the door, not always through its middle."""
    height = low + Fraction(dice.randint(1, 2 * (high - low) - 1), 2)
    start = Fraction(dice.randint(4, 20), 2), Fraction(dice.randint(4, 20), 2)
    return [start, (start[0], height), (LARGE, height)]


def _door(dice: random.Random, _: int) -> Drawn:
    low, high = sorted(dice.sample(range(1, 12), 2))
    return _part(dice), _room(dice, low, high), _through(dice, low, high)


def _bent_door(dice: random.Random, _: int) -> Drawn:
    low, high = sorted(dice.sample(range(2, 11), 2))
    bend = dice.choice((-1, 1))
    if high - low < 3:  # a door that narrows to nothing is none
        bend = 1
    return _part(dice), _room(dice, low, high, bend), _through(dice, low, high)


def _two_doors(dice: random.Random, _: int) -> Drawn:
    """Two walls, one after the other, with doors at different heights."""
    low = dice.randint(2, 6)
    high = low + dice.randint(2, 4)
    pillars = [
        [[(4, -9), (5, -9), (5, low), (4, low)]],
        [[(4, high), (5, high), (5, 20), (4, 20)]],
        [[(9, -9), (10, -9), (10, low + 1), (9, low + 1)]],
        [[(9, high + 2), (10, high + 2), (10, 20), (9, 20)]],
        [[(-9, -9), (-8, -9), (-8, 20), (-9, 20)]],
    ]
    middle = Fraction(low + high, 2)
    way = [(Fraction(0), middle), (Fraction(7), middle), (Fraction(7), middle + 1)]
    return _part(dice), PolygonSet(pillars), [*way, (LARGE, middle + 1)]


def _together(dice: random.Random, _: int) -> Drawn:
    """A channel open at one end: what stops the part at its place also stops it on the way."""
    part = _part(dice)
    low, high = -dice.randint(1, 4), dice.randint(1, 4)
    walls = [
        [[(-9, low - 2), (20, low - 2), (20, low), (-9, low)]],
        [[(-9, high), (20, high), (20, high + 2), (-9, high + 2)]],
    ]
    zero = Fraction(0)
    return part, PolygonSet(walls), [(zero, zero), (LARGE, zero)]


def _alone(dice: random.Random, _: int) -> Drawn:
    """A part beside its origin, and two walls on the way. The first is left behind at the scale at
    which the second is met: there the way is valid at that scale alone, with contact allowed."""
    near, width = dice.randint(1, 3), dice.randint(1, 3)
    far = near + width
    scale = Fraction(dice.randint(2, 9), dice.randint(1, 3))
    height = dice.randint(1, 3)
    part = PolygonSet([(near, 0), (far, 0), (far, height), (near, height)])
    deep = Fraction(dice.randint(1, 7), 8) * scale * near  # where the first wall begins
    walls = [
        [(deep, -height), (near * scale, -height), (near * scale, 9), (deep, 9)],
        [
            (far * scale, -height), (far * scale + 5, -height), (far * scale + 5, 9),
            (far * scale, 9),
        ],
    ]  # fmt: skip
    start = (Fraction(0), Fraction(-height) - 100 * scale)
    return part, PolygonSet([[wall] for wall in walls]), [start, (Fraction(0), Fraction(0))]


def _along(dice: random.Random, _: int) -> Drawn:
    """The part leaves along the floor of the room, in contact with it at one scale."""
    part = _part(dice)
    high = dice.randint(2, 4)
    depth = Fraction(dice.randint(2, 2 * high - 1), 2)
    room = PolygonSet(
        [(-2, -2), (20, -2), (20, 0), (0, 0), (0, 12), (12, 12), (12, high), (14, high), (14, 14),
         (-2, 14)]
    )  # fmt: skip
    x = Fraction(dice.randint(4, 20), 2)
    return part, room, [(x, depth), (LARGE, depth)]


def _single(dice: random.Random, _: int) -> Drawn:
    part, room, way = _door(dice, 0)
    return part, room, way[: dice.randint(1, 1)] * dice.randint(1, 2)


def _path(dice: random.Random, index: int) -> Drawn:
    case = path_case(dice.randrange(1000), index)
    return case.part, case.obstacles, case.path


DRAWS: dict[str, Callable[[random.Random, int], Drawn]] = dict(
    zip(KINDS, (_door, _together, _path, _alone, _bent_door, _along, _two_doors, _single),
        strict=True)
)  # fmt: skip
