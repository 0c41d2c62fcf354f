"""Sets, paths and places for judges of discs that move, many degenerate: slots and corridors of one
width, places at vertices and in the middle between edges, paths that touch."""

from __future__ import annotations

import random
from dataclasses import dataclass
from fractions import Fraction

import minkref
from minkref.api import PolygonSet
from minkref.fuzz.features.feature_draws import drawn_set, set_of
from minkref.fuzz.geometry.plane import Ring, box, fraction_rings, read_shape
from minkref.fuzz.motion.path_cases import Place
from minkref.oracle.distances import is_inside, path_distance

MOST = 40  # vertices
TRIES = 30  # of a place or a path
ROOMY = 6  # places of which the one with most room is taken


@dataclass(frozen=True)
class DiscCase:
    name: str
    set: PolygonSet
    rings: list[list[Place]]
    path: list[Place]
    inside: tuple[Place, Place]  # places, mostly inside of the set
    outside: tuple[Place, Place]  # mostly outside


def disc_case(seed: int, index: int) -> DiscCase:
    """The same one for the same numbers: rooms with doors, or a set of other kinds."""
    dice = random.Random(f"discs {seed}:{index}")
    centres: list[Place] = []
    if index % 2 == 0:
        name, (drawn, centres) = f"rooms {seed}:{index}", rooms(dice)
    else:
        name, shape = drawn_set(seed, index, MOST)
        drawn = set_of(shape)
    rings = rings_of(drawn)
    path = [_place(dice, rings) for _ in range(dice.randint(1, 4))]
    for _ in range(dice.choice((0, TRIES, TRIES))):  # paths that meet nothing tell more
        if path_distance(rings, path) > 0:
            break
        path = [_place(dice, rings) for _ in range(dice.randint(1, 3))]
    inside, outside = (
        (_place_on(dice, rings, side), _place_on(dice, rings, side)) for side in (True, False)
    )
    if centres and dice.random() < 0.7:
        first, second = dice.choice(centres), dice.choice(centres)
        if is_inside(rings, first):
            inside = first, second
        else:
            outside = first, second
    return DiscCase(name, drawn, rings, path, inside, outside)


def rings_of(shape: PolygonSet) -> list[list[Place]]:
    """All rings, in fractions."""
    return [
        [(Fraction(x), Fraction(y)) for x, y in ring] for ring in fraction_rings(shape.to_json())
    ]


def rooms(dice: random.Random) -> tuple[PolygonSet, list[Place]]:
    """Rooms in a row or in two, with doors of few widths between them; or the block that has them
    as holes, perhaps with a door to the outside. Walls lean, or stand. And a place about the middle
    of each room."""
    wide, high = dice.randint(2, 4), dice.randint(1, 2)
    boxes = [box(8 * x, 8 * y, 6, 6) for x in range(wide) for y in range(high)]
    widths = dice.choice(((1, 2), (2, 2), (1, 3, 4)))
    for x in range(wide):
        for y in range(high):
            if x + 1 < wide and dice.random() < 0.9:
                width = dice.choice(widths)
                boxes.append(box(8 * x + 5, 8 * y + dice.randint(0, 6 - width), 4, width))
            if y + 1 < high and dice.random() < 0.6:
                width = dice.choice(widths)
                boxes.append(box(8 * x + dice.randint(0, 6 - width), 8 * y + 5, width, 4))
    is_block = dice.random() < 0.5
    if is_block and dice.random() < 0.7:
        boxes.append(box(8 * wide - 3, dice.randint(0, 3), 9, dice.choice(widths)))
    found = minkref.unite([_set_of(each) for each in boxes])
    if is_block:
        found = minkref.subtract(_set_of(box(-2, -2, 8 * wide + 2, 8 * high + 2)), [found])
    lean = dice.choice((Fraction(0), Fraction(1, 3), Fraction(-1, 7)))
    sheared = [
        [[[str(x + lean * y), str(y)] for x, y in ring] for ring in polygon]
        for polygon in read_shape(found.to_json())
    ]
    middles = [(8 * x + 3, 8 * y + Fraction(dice.randint(4, 8), 2)) for x in range(wide)
               for y in range(high)]  # fmt: skip
    return PolygonSet(sheared), [(x + lean * y, y) for x, y in middles]


def _set_of(ring: Ring) -> PolygonSet:
    return PolygonSet([[[(str(x), str(y)) for x, y in ring]]])


def _place_on(dice: random.Random, rings: list[list[Place]], inside: bool) -> Place:
    """Draw a place, preferably on one side of the boundary; half have room."""
    drawn = [_place(dice, rings) for _ in range(TRIES)]
    on_side = [place for place in drawn if is_inside(rings, place) == inside] or drawn
    if dice.random() < 0.5:
        return on_side[0]
    return max(on_side[:ROOMY], key=lambda place: path_distance(rings, [place]))


def _place(dice: random.Random, rings: list[list[Place]]) -> Place:
    """A lattice point of the set's box with a margin, a point between two vertices, or one beside a
    vertex."""
    corners = [p for ring in rings for p in ring]
    (ax, ay), (bx, by) = dice.choice(corners), dice.choice(corners)
    kind = dice.randrange(4)
    if kind == 0:
        return (ax + bx) / 2, (ay + by) / 2
    if kind == 1:
        third = Fraction(dice.randint(-6, 6), 3)
        return ax + third, ay + Fraction(dice.randint(-6, 6), 3)
    low_x, high_x = min(x for x, _ in corners), max(x for x, _ in corners)
    low_y, high_y = min(y for _, y in corners), max(y for _, y in corners)
    parts = 12
    return (
        low_x + (high_x - low_x) * Fraction(dice.randint(-2, parts + 2), parts),
        low_y + (high_y - low_y) * Fraction(dice.randint(-2, parts + 2), parts),
    )
