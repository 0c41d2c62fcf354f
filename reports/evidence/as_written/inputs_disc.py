"""Sets and radii for sums with a disc: turned in doubles, with walls almost parallel, far away."""

from __future__ import annotations

import random
from dataclasses import dataclass
from fractions import Fraction

from minkref.reports.evidence.as_written.shapes import (
    LESS,
    PLACED,
    SHAPES,
    Point,
    Rings,
    cells,
    moved,
    tapered,
    turned,
)

CELLS, THIN = "cells of a grid", "point or segment"
OTHERS = (*LESS, *(f"straight, {where}" for where in PLACED), CELLS, THIN)


@dataclass(frozen=True)
class Drawn:
    """A set, and a disc as `disc:` has it."""

    kind: str
    polygons: list[Rings]
    radius: str

    @property
    def rings(self) -> Rings:
        return [ring for polygon in self.polygons for ring in polygon]

    @property
    def text(self) -> str:
        """The set as WKT, with fractions."""
        first = self.rings[0]
        if len(first) < 3:
            return f"{'POINT' if len(first) == 1 else 'LINESTRING'} ({_points(first)})"
        rings = [[f"({_points([*ring, ring[0]])})" for ring in one] for one in self.polygons]
        return f"MULTIPOLYGON ({', '.join('(' + ', '.join(one) + ')' for one in rings)})"


def _points(points: list[Point]) -> str:
    return ", ".join(f"{x} {y}" for x, y in points)


def kinds() -> set[str]:
    """All kinds that a seed may draw."""
    return {*OTHERS, *(f"turned {name}, {where}" for name in SHAPES for where in PLACED)}


def drawn(seed: int, index: int) -> Drawn:
    """Turned shapes with double coordinates for even numbers, other random shapes for odd
    numbers."""
    draw = random.Random(f"{seed}:{index}")
    if index % 2 == 0:
        return _turned(draw)
    kind = draw.choice(OTHERS)
    if kind in LESS:
        rings, radius = tapered(draw, LESS[kind])
        return Drawn(kind, [rings], f"disc:{radius}")
    if kind == CELLS:
        polygons, radius = cells(draw)
        return Drawn(kind, polygons, draw.choice([f"disc:{radius}", f"disc:sqrt:{2 * radius}"]))
    if kind == THIN:
        ends = [tuple(Fraction(draw.randint(-99, 99), n) for n in (10, 7)) for _ in range(2)]
        points = [(x, y) for x, y in ends[: draw.randint(1, 2)]]
        return Drawn(kind, [[points]], f"disc:{draw.randint(1, 30)}/7")
    shape, radius = SHAPES[draw.choice(list(SHAPES))](draw)
    scale, x, y = PLACED[kind.removeprefix("straight, ")]
    return Drawn(kind, [moved(shape, scale, x, y)], f"disc:{radius * scale}")


def _turned(draw: random.Random) -> Drawn:
    name = draw.choice(list(SHAPES))
    shape, radius = SHAPES[name](draw)
    where = draw.choice(["at home", "at home", "at home", *PLACED])
    radius *= PLACED[where][0]
    told = draw.choice([f"disc:{radius}"] * 4 + [f"disc:sqrt:{2 * radius**2}"])
    return Drawn(f"turned {name}, {where}", [turned(shape, draw, where)], told)
