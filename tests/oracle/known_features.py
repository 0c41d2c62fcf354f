"""Sets with features known by hand, and a judge's findings in short form."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from minkref.oracle.features import Judge
from minkref.oracle.features.tree import Node

Ring = list[tuple[Any, Any]]
Shape = list[list[Ring]]
Bars = list[tuple[Fraction | None, Fraction | None]]


def box(x: Any, y: Any, wide: Any, high: Any) -> Ring:
    return [(x, y), (x + wide, y), (x + wide, y + high), (x, y + high)]


def slot(width: Fraction, depth: Fraction) -> Shape:
    """A block, slotted from above, the mouth's middle at the origin."""
    half = width / 2
    return [[[(-half - 3, -depth - 2), (half + 3, -depth - 2), (half + 3, 0), (half, 0),
              (half, -depth), (-half, -depth), (-half, 0), (-half - 3, 0)]]]  # fmt: skip


def holed(hole: Ring, reach: int = 20) -> Shape:
    return [[box(-reach, -reach, 2 * reach, 2 * reach), hole]]


def tangent_hole() -> Ring:
    """Eight tangents to the unit circle at rational points, clockwise."""
    way = [(4, 3), (3, 4), (-3, 4), (-4, 3), (-4, -3), (-3, -4), (3, -4), (4, -3)]
    sides = [(Fraction(x, 5), Fraction(y, 5)) for x, y in way]
    ring = []
    for (a, b), (c, d) in zip(sides, [*sides[1:], sides[0]], strict=True):
        turn = a * d - b * c
        ring.append(((d - b) / turn, (a - c) / turn))
    return ring[::-1]


def squares(judge: Judge, levels: list[tuple[int, int]]) -> Bars:
    """Rational squared radii; None: infinity, or irrational."""

    def told(level: int) -> Fraction | None:
        square = judge.squared_radius(level)
        return None if square is None else square.rational

    return [(told(low), told(high)) for low, high in levels]


def bars(shape: Shape) -> Bars:
    judge = Judge(shape)
    return squares(judge, judge.bars())


def only_root(judge: Judge) -> Node:
    [root] = judge.tree.roots
    return root
