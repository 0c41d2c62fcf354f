"""Sets to erode in whole numbers: each function draws one kind. Parts vanish, necks open and holes
reach the outside at some radius, or nearly so."""

from __future__ import annotations

from collections.abc import Callable

from minkref.fuzz.geometry.plane import Polygon, Ring, Shape, box
from minkref.fuzz.offsets.degenerate_offsets import KINDS as OF_OFFSETS
from minkref.fuzz.offsets.degenerate_offsets import LONG
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import placed


def rooms(dice: Dice) -> Shape:
    """Rooms in a row with doors between them, some of one width."""
    high, door = dice.randint(4, 8), dice.randint(1, 3)
    low: Ring = []
    top: Ring = []
    x = 0
    for k in range(dice.randint(2, 3)):
        if k:
            wide = door if dice.random() < 0.7 else dice.randint(1, high - 1)
            y, thick = dice.randint(0, high - wide), dice.randint(1, 3)
            low += [(x, y), (x + thick, y)]
            top += [(x, y + wide), (x + thick, y + wide)]
            x += thick
        room = dice.randint(3, 7)
        low += [(x, 0), (x + room, 0)]
        top += [(x, high), (x + room, high)]
        x += room
    ring = low + top[::-1]
    return [[[p for k, p in enumerate(ring) if p != ring[k - 1]]]]


def vanishing_parts(dice: Dice) -> Shape:
    """Parts with few inradii: squares, bars, triangles with sides 3, 4, 5, tips on a square."""
    unit, x = dice.randint(1, 3), 0
    shape: Shape = []
    for _ in range(dice.randint(1, 4)):
        way, wide = dice.randrange(4), 2 * unit
        if way == 0:
            part = box(x, 0, 2 * unit, 2 * unit + dice.choice((0, 0, 1, 2)))
        elif way == 1:
            part, wide = [(x, 0), (x + 4 * unit, 0), (x, 3 * unit)], 4 * unit
        elif way == 2:
            part, wide = [(x, 3), (x + 3, 0), (x + 6, 3), (x + 3, 6)], 6
        else:
            wide = dice.randint(1, 6)
            part = box(x, 0, wide, dice.randint(1, 6))
        shape.append([part])
        x += wide + dice.randint(1, 2)
    return shape


def holes_by_the_wall(dice: Dice) -> Shape:
    """Holes near the outer ring and each other, some walls equal."""
    wall, x = dice.randint(1, 3), dice.randint(1, 3)
    holes: list[Ring] = []
    high = dice.randint(5, 9)
    for _ in range(dice.randint(1, 3)):
        wide, tall = dice.randint(1, 3), dice.randint(1, high - wall - 1)
        y = wall if dice.random() < 0.6 else high - tall - dice.randint(1, max(1, high - tall - 1))
        hole = box(x, max(y, 1), wide, tall if max(y, 1) + tall < high else 1)
        holes.append([hole[0], hole[2], hole[3]] if dice.random() < 0.3 else hole)
        x += wide + (wall if dice.random() < 0.6 else dice.randint(1, 3))
    return [[box(0, 0, x, high), *holes]]


def thin_walls(dice: Dice) -> Shape:
    """A frame whose walls differ by one or two units over their length, perhaps with a cross."""
    thick, off = dice.randint(LONG // 64, LONG // 16), dice.choice((-2, -1, 0, 1, 2))
    inner = box(thick, thick, LONG - 2 * thick, LONG - 2 * thick)
    inner[2] = (inner[2][0], inner[2][1] + off)
    frame: Polygon = [box(0, 0, LONG, LONG), inner]
    if dice.random() < 0.5:
        half, top = LONG // 2 - thick, LONG - thick
        frame = [frame[0], box(thick, thick, half - thick, top - thick),
                 box(half + thick + off, thick, top - half - thick - off, top - thick)]  # fmt: skip
    return [frame]


def wedge(dice: Dice) -> Shape:
    """A room that narrows to a slit and widens again, by a unit over its length."""
    wide, slit = dice.randint(LONG // 16, LONG // 8), dice.randint(LONG // 64, LONG // 20)
    off = dice.choice((0, 1, 2))
    ring: Ring = [(0, 0), (LONG, slit // 2), (2 * LONG, 0), (2 * LONG, wide),
                  (LONG, slit // 2 + slit + off), (0, wide)]  # fmt: skip
    return [[ring]]


REUSED = (
    "a nearly straight vertex", "vertices on a circle", "vanishing holes", "nested islands",
    "touching rings", "on the lattice", "a huge set with a notch", "straight vertices",
    "a closing pocket", "spikes",
)  # fmt: skip
KINDS: dict[str, Callable[[Dice], Shape]] = {
    "rooms with doors": rooms,
    "parts that vanish": vanishing_parts,
    "holes by the wall": holes_by_the_wall,
    "thin walls": thin_walls,
    "a room with a waist": wedge,
    **{name: OF_OFFSETS[name] for name in REUSED},
}


def degenerate_inset(dice: Dice, kind: str) -> Shape:
    """Draws a set of this kind, turned by right angles, perhaps mirrored."""
    shape = KINDS[kind](dice)
    return placed(shape, dice.randrange(4), dice.random() < 0.5)
