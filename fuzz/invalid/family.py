"""Pairs with one invalid operand, and its fault. Nothing is validated."""

from __future__ import annotations

import json
import random

from minkref.fuzz.geometry.plane import Ring, Shape, box, moved, scaled
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import convex, shape_text
from minkref.fuzz.plane.families.hard_numbers import polygon

KINDS = (
    "self-intersecting",
    "overlapping-rings",
    "crossing-polygons",
    "hole-outside",
    "nested-twice",
    "repeated-vertex",
    "spike",
    "zero-area",
    "too-few-vertices",
    "ring-twice",
)


def invalid_pair(seed: int, index: int) -> tuple[str, str, str]:
    """Returns (kind, P, Q): the kinds in turn; P is invalid, or Q in odd rounds."""
    dice = Dice(f"minkref invalid {seed} {index}")
    kind = KINDS[index % len(KINDS)]
    shape = scaled(_drawn(dice, kind), dice.randint(1, 4))
    shape = moved(shape, dice.randint(-9, 9), dice.randint(-9, 9))
    wrong = _as_drawn(shape) if kind in ("zero-area", "too-few-vertices") else shape_text(shape)
    right = shape_text([polygon(dice, dice.randint(3, 12))])
    return (kind, right, wrong) if index // len(KINDS) % 2 else (kind, wrong, right)


def _as_drawn(shape: Shape) -> str:
    return json.dumps(
        {
            "polygons": [
                {
                    "outer": [[str(x), str(y)] for x, y in each[0]],
                    "holes": [[[str(x), str(y)] for x, y in hole] for hole in each[1:]],
                }
                for each in shape
            ]
        },
        separators=(",", ":"),
    )


def _drawn(dice: random.Random, kind: str) -> Shape:
    ring = convex(dice, dice.randint(5, 9), 12)
    frame = box(-2, -2, 16, 16)
    if kind == "self-intersecting":
        width, height, deep = dice.randint(2, 9), dice.randint(2, 9), dice.randint(1, 9)
        return [[[(0, 0), (width, 0), (dice.randint(0, width), -deep), (0, height)]]]
    if kind == "overlapping-rings":
        return [[frame, box(0, 0, 6, 6), box(dice.randint(1, 5), dice.randint(1, 5), 6, 6)]]
    if kind == "crossing-polygons":
        return [[frame], [box(dice.randint(3, 12), dice.randint(3, 12), 20, 20)]]
    if kind == "hole-outside":
        return [[frame, box(dice.randint(15, 40), 0, 3, 3)]]
    if kind == "nested-twice":
        return [[frame, box(0, 0, 10, 10), box(1, 1, dice.randint(1, 8), 3)]]
    if kind == "repeated-vertex":
        k = dice.randrange(len(ring))
        return [[[*ring[:k], ring[k], *ring[k:]]]]
    if kind == "spike":
        return [[_with_spike(dice, frame)]]
    if kind == "zero-area":
        dx, dy = dice.randint(1, 5), dice.randint(-5, 5)
        return [[[(k * dx, k * dy) for k in (0, 2, dice.choice((1, 3, 4)))]]]
    if kind == "too-few-vertices":
        few: Ring = [(1, 1), (dice.randint(2, 9), 3)]
        return [[frame, few[: dice.randint(1, 2)]]]
    return [[ring], [ring]]


def _with_spike(dice: random.Random, ring: Ring) -> Ring:
    """A side with an excursion to a point and back."""
    (x, y), out = ring[1], dice.randint(1, 9)
    return [ring[0], (x, y), (x + out, y - out), (x, y), *ring[2:]]
