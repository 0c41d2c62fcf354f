"""Random paths for a polyhedron among others, in space; a third degenerate."""

from __future__ import annotations

import random
from dataclasses import dataclass
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, middle
from minkref.fuzz.space.general_pairs import general_pair
from minkref.fuzz.space.generators.machined import plate

KINDS = (
    "along an edge",
    "on a critical position",
    "single place",
    "along an axis in contact",
    "corridor",
)
WIDE = 20


@dataclass(frozen=True)
class SpacePathCase:
    """`kind`: the path's degeneracy, "general" if none is intended. Parts and obstacles are a pair
    from `general_pairs.py`, half already degenerate by themselves."""

    name: str
    part: Polyhedron
    obstacles: Polyhedron
    path: list[Point]
    kind: str

    @property
    def is_thin(self) -> bool:
        return self.part.is_thin or self.obstacles.is_thin


def space_path_case(seed: int, index: int) -> SpacePathCase:
    """The same one for the same numbers."""
    pair = general_pair(seed, index)
    dice = random.Random(f"minkref path {pair.name}")
    kind = dice.choice(KINDS) if dice.random() < 1 / 3 else "general"  # families take turns
    part, obstacles = pair.P, pair.Q
    if kind == "corridor":
        return _corridor(dice, pair.name, part, pair.scale)
    if dice.random() < 0.7:  # about the origin, or beside it
        vertices = dice.sample(part.vertices, min(2, len(part.vertices)))
        centre = middle(vertices)
        part = part.translated((-centre[0], -centre[1], -centre[2]))
    path = [_place(dice, obstacles) for _ in range(dice.randint(1, 3))]
    a, b = dice.choice(part.vertices), dice.choice(obstacles.vertices)
    contact = _plus(b, a, -pair.scale)
    if kind == "along an edge":
        start, end = _edge(dice, obstacles)
        from_there = path[-1] if dice.random() < 0.5 else start
        path = [*path[:-1], from_there, _plus(_plus(from_there, end), start, Fraction(-1))]
    elif kind == "on a critical position":
        path[dice.randrange(len(path))] = contact
    elif kind == "single place":
        path = [contact]
    elif kind == "along an axis in contact":
        way = _along(dice.randrange(3), Fraction(dice.choice((-4, -2, 1, 3))))
        path = [_plus(contact, way, Fraction(-1)), contact]
    if dice.random() < 0.15:
        path.append(path[0])
    return SpacePathCase(pair.name, part, obstacles, path, kind)


def _corridor(dice: random.Random, name: str, part: Polyhedron, scale: Fraction) -> SpacePathCase:
    """Two walls, and a way along them: contact on both sides at one scale. For a part on one side
    of its origin, no neighbouring scale is valid."""
    axis = dice.randrange(3)
    part = part.translated(_along(axis, Fraction(dice.choice((0, 9, -9)))))
    heights = [scale * vertex[axis] for vertex in part.vertices]
    low, high = min(heights), max(heights)
    walls = _wall(axis, low - dice.randint(2, 5), low)
    if dice.random() < 0.9:
        walls = walls.with_faces_of(_wall(axis, high, high + dice.randint(2, 5)))
    start = _along((axis + 1) % 3, Fraction(dice.randint(-3, 3)))
    way = _along((axis + dice.randint(1, 2)) % 3, Fraction(dice.randint(0, 6)))
    return SpacePathCase(name, part, walls, [start, _plus(start, way)], "corridor")


def _along(axis: int, length: Fraction) -> Point:
    x, y, z = (length if k == axis else Fraction(0) for k in range(3))
    return x, y, z


def _wall(axis: int, low: Fraction, high: Fraction) -> Polyhedron:
    sizes = [Fraction(2 * WIDE)] * 3
    sizes[axis] = high - low
    corner = [Fraction(-WIDE)] * 3
    corner[axis] = low
    unit = plate(1, 1, 1)
    return unit.scaled((sizes[0], sizes[1], sizes[2])).translated((corner[0], corner[1], corner[2]))


def _plus(a: Point, b: Point, factor: Fraction = Fraction(1)) -> Point:
    return a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]


def _edge(dice: random.Random, body: Polyhedron) -> tuple[Point, Point]:
    if not body.faces:
        return body.vertices[0], body.vertices[-1]
    face = dice.choice(body.faces)
    k = dice.randrange(len(face))
    return body.vertices[face[k - 1]], body.vertices[face[k]]


def _place(dice: random.Random, near: Polyhedron) -> Point:
    """A point within some units of a vertex."""
    parts = dice.choice((1, 1, 2, 3))
    reach = 6 * parts
    x, y, z = (Fraction(dice.randint(-reach, reach), parts) for _ in range(3))
    return _plus((x, y, z), dice.choice(near.vertices))
