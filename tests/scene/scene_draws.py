"""Small scenes on a lattice: robots, shapes, copies."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from minkref import Copy, PolygonSet, Scene


def box(x0: int, y0: int, x1: int, y1: int) -> PolygonSet:
    return PolygonSet([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def frame(outer: int, inner: int) -> PolygonSet:
    """A square with a square hole, both about the origin; `outer`, `inner`: half sides."""
    rings = [
        [(-half, -half), (half, -half), (half, half), (-half, half)] for half in (outer, inner)
    ]
    return PolygonSet(rings)


POINT = PolygonSet((0, 0))
UNIT = box(0, 0, 1, 1)
SHAPES = {
    "unit": UNIT,
    "flat box": box(-1, 0, 1, 1),
    "triangle": PolygonSet([(0, 0), (2, 0), (0, 1)]),
    "dart": PolygonSet([(0, 0), (2, -1), (1, 0), (2, 1)]),
    "frame": frame(2, 1),
    "corners that touch": PolygonSet([[[(0, 0), (1, 0), (0, 1)]], [[(1, 0), (2, 0), (2, 1)]]]),
    "two boxes": PolygonSet(
        [[[(0, 0), (1, 0), (1, 1), (0, 1)]], [[(2, 0), (3, 0), (3, 2), (2, 2)]]]
    ),
    "segment": PolygonSet("LINESTRING (0 0, 2 1)"),
    "point": POINT,
}
ROBOTS = {
    "unit": UNIT,
    "triangle": PolygonSet([(0, 0), (1, 0), (0, 1)]),
    "dart": PolygonSet([(0, 0), (1, -1), (0, 2), (-1, -1)]),
    "frame": frame(2, 1),
    "corners that touch": PolygonSet([[[(0, 0), (1, 0), (0, 1)]], [[(1, 0), (2, 0), (2, 1)]]]),
    "segment": PolygonSet("LINESTRING (0 0, 1 0)"),
    "point": PolygonSet((1, 0)),
}
FLAT = ("segment", "point")
SCALES = tuple(Fraction(n, d) for n, d in ((1, 2), (1, 1), (1, 1), (3, 2), (2, 1)))


def turned(robot: PolygonSet) -> PolygonSet:
    """Turn the robot by 180 degrees."""
    return PolygonSet(
        [[[(-x, -y) for x, y in ring] for ring in polygon] for polygon in robot.rings()]
    )


@dataclass(frozen=True)
class Draw:
    """A scene's parts. Failing tests print `told`."""

    told: str
    robot: PolygonSet
    shapes: dict[str, PolygonSet]
    copies: list[Copy]

    def scene(self, passages: bool = False) -> Scene:
        return Scene(self.robot, self.shapes, self.copies, passages=passages)


def scenes(
    seed: int, count: int, most: int = 5, robots: tuple[str, ...] = tuple(ROBOTS)
) -> Iterator[Draw]:
    """Draw scenes with up to `most` copies; each robot comes in turn. Places are halves, so that
    sums touch, abut and overlap along edges."""
    for index in range(count):
        dice = random.Random(f"{seed}, {index}")
        name = robots[index % len(robots)]
        usable = [shape for shape in SHAPES if name not in FLAT or shape not in FLAT]
        chosen = dice.sample(usable, dice.randint(1, 3))
        copies = [
            Copy(
                dice.choice(chosen),
                dice.choice(SCALES),
                (Fraction(dice.randint(-4, 8), 2), Fraction(dice.randint(-4, 8), 2)),
            )
            for _ in range(dice.randint(1, most))
        ]
        told = f"seed {seed}, scene {index}: robot {name}, {copies}"
        yield Draw(told, ROBOTS[name], {shape: SHAPES[shape] for shape in chosen}, copies)
