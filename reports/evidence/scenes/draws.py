"""Random scenes from the families for sums; every third scene degenerate."""

from __future__ import annotations

import random
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from minkref import Copy, PolygonSet, Scene
from minkref.fuzz.plane.families.catalogue import FAMILIES

SEED = 811
#: Whole coordinates, halves as places: sums abut, touch and run along each other.
DEGENERATE = ("lattice", "cells", "fit", "collinear", "touching")
GENERAL = ("random", "holes", "star", "comb", "rational", "nested", "leaning", "convex")
MOST_COPIES = 9
SCALES = tuple(Fraction(n, 2) for n in (1, 2, 2, 3, 4))


@dataclass(frozen=True)
class DrawnScene:
    """`kind`: the operands' family; `name` makes the scene again."""

    name: str
    kind: str
    robot: PolygonSet
    shapes: tuple[PolygonSet, ...]
    copies: tuple[Copy, ...]

    def scene(self, passages: bool = False) -> Scene:
        return Scene(self.robot, list(self.shapes), list(self.copies), passages=passages)

    @cached_property
    def is_degenerate(self) -> bool:
        return self.kind in DEGENERATE


def drawn(index: int) -> DrawnScene:
    """Scene number `index`; every third is degenerate."""
    families = DEGENERATE if index % 3 == 0 else GENERAL
    kind = families[index // 3 % len(families)]
    dice = random.Random(f"minkref scenes {SEED} {index}")
    while True:
        pairs = [FAMILIES[kind].pair(SEED, dice.randrange(40)) for _ in range(2)]
        robot, *shapes = (
            PolygonSet.from_json(text) for text in (pairs[0].Q, pairs[0].P, pairs[1].P)
        )
        if not any(one.is_empty for one in (robot, *shapes)) and (
            robot.is_region or all(shape.is_region for shape in shapes)
        ):
            break
    copies = tuple(_copy(dice, kind in DEGENERATE) for _ in range(dice.randint(2, MOST_COPIES)))
    return DrawnScene(f"scene {index} of {kind}", kind, robot, tuple(shapes), copies)


def _copy(dice: random.Random, is_degenerate: bool) -> Copy:
    if is_degenerate:
        place = (Fraction(dice.randint(-24, 24), 2), Fraction(dice.randint(-24, 24), 2))
        return Copy(dice.randrange(2), dice.choice(SCALES), place)
    x, y = (Fraction(dice.randint(-2000, 2000), dice.choice((100, 70, 99))) for _ in "xy")
    return Copy(dice.randrange(2), Fraction(dice.randint(20, 300), 100), (x, y))
