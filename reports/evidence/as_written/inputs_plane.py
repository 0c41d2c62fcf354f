"""Pairs of sets and scales whose sums have corners beyond decimals and doubles."""

from __future__ import annotations

import random
from dataclasses import dataclass
from fractions import Fraction

from minkref.reports.evidence.as_written.inputs_disc import Drawn
from minkref.reports.evidence.as_written.shapes import (
    LESS,
    ORIGIN,
    PLACED,
    SHAPES,
    Point,
    Rings,
    moved,
    tapered,
    turned,
)

KINDS = ("turned", "straight", "thirds", *LESS)


@dataclass(frozen=True)
class Pair:
    """Two sets as WKT and a scale."""

    kind: str
    P: str
    Q: str
    scale: str


def kinds() -> set[str]:
    """All kinds that a seed may draw."""
    return {f"{kind}, {where}" for kind in KINDS for where in PLACED}


def pair(seed: int, index: int) -> Pair:
    draw = random.Random(f"plane {seed}:{index}")
    kind, where = draw.choice(KINDS), draw.choice(list(PLACED))
    P = _one(draw, kind, where)
    Q = _one(draw, draw.choice(["triangle", kind]), "at home")
    Q = moved(Q, PLACED[where][0], ORIGIN, ORIGIN)
    scale = Fraction(draw.randint(1, 40), draw.choice([1, 3, 7, 10, 16, 97]))
    first, second = (Drawn("", [rings], "").text for rings in (P, Q))
    return Pair(f"{kind}, {where}", first, second, str(scale))


def _one(draw: random.Random, kind: str, where: str) -> Rings:
    if kind == "triangle":
        return [_triangle(draw)]
    if kind in LESS:
        return moved(tapered(draw, LESS[kind])[0], *PLACED[where])
    shape, _ = SHAPES[draw.choice(list(SHAPES))](draw)
    if kind == "turned":
        return turned(shape, draw, where)
    if kind == "thirds":
        part = Fraction(1, draw.choice([3, 7, 9, 11, 13]))
        shape = [[(p + part * q, q - part * part * p) for p, q in ring] for ring in shape]
    return moved(shape, *PLACED[where])


def _triangle(draw: random.Random) -> list[Point]:
    while True:
        ring = [(Fraction(draw.randint(-9, 9), 8), Fraction(draw.randint(-9, 9), 8)) for _ in "abc"]
        (ax, ay), (bx, by), (cx, cy) = ring
        turn = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if turn:
            return ring if turn > 0 else ring[::-1]
