"""Pairs of sets and scales whose sums have corners that no decimal and no double is."""

from __future__ import annotations

import random
from dataclasses import dataclass
from fractions import Fraction

from minkref.reports.evidence.written.inputs_disc import (
    LESS,
    PLACED,
    SHAPES,
    Drawn,
    Rings,
    _rounded,
    moved,
    tapered,
    turned,
)

KINDS = ("turned", "straight", "thirds", *LESS)


@dataclass(frozen=True)
class Pair:
    kind: str
    P: str
    Q: str
    scale: str


def pair(seed: int, index: int) -> Pair:
    draw = random.Random(f"plane {seed}:{index}")
    kind, where = draw.choice(KINDS), draw.choice(list(PLACED))
    P, Q = _one(draw, kind, where), _one(draw, draw.choice(["triangle", kind]), "at home")
    scale, _, _ = PLACED[where]
    Q = moved(Q, scale, Fraction(0), Fraction(0))
    told = Fraction(draw.randint(1, 40), draw.choice([1, 3, 7, 10, 16, 97]))
    return Pair(f"{kind}, {where}", Drawn("", [P], "").text, Drawn("", [Q], "").text, str(told))


def _one(draw: random.Random, kind: str, where: str) -> Rings:
    scale, x, y = PLACED[where]
    if kind in LESS:
        return moved(tapered(draw, LESS[kind])[0], scale, x, y)
    if kind == "triangle":
        return [_triangle(draw)]
    shape, _ = SHAPES[draw.choice(list(SHAPES))](draw)
    if kind == "thirds":
        part = Fraction(1, draw.choice([3, 7, 9, 11, 13]))
        shape = [[(p + part * q, q - part * part * p) for p, q in ring] for ring in shape]
    if kind != "turned":
        return moved(shape, scale, x, y)
    far = moved(turned(shape, draw), scale, Fraction(0), Fraction(0))
    return [[_rounded(p, x, y) for p in ring] for ring in far]


def _triangle(draw: random.Random) -> list[tuple[Fraction, Fraction]]:
    while True:
        ring = [
            (Fraction(draw.randint(-9, 9), 8), Fraction(draw.randint(-9, 9), 8)) for _ in range(3)
        ]
        (ax, ay), (bx, by), (cx, cy) = ring
        turn = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if turn:
            return ring if turn > 0 else ring[::-1]
