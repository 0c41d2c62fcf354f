"""Sets for the judge of places (oracle/places), with rational edge lengths. In half the kinds, many
events share a radius."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.plane import Number, Point, Ring, Shape, box, mapped, scaled
from minkref.fuzz.plane.families.drawing import shape_text

TRIPLES = ((3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25))
PATIENCE = 100
Dice = random.Random


def overlap(a: Ring, b: Ring, apart: Number) -> bool:
    """Whether boxes are nearer than so much, along both axes."""
    return all(
        min(p[k] for p in a) < max(p[k] for p in b) + apart
        and min(p[k] for p in b) < max(p[k] for p in a) + apart
        for k in (0, 1)
    )


def _boxes(dice: Dice, count: int, size: int, parts: int) -> list[Ring]:
    found: list[Ring] = []
    for _ in range(PATIENCE):
        x, y = (Fraction(dice.randint(0, size * parts), parts) for _ in range(2))
        wide, high = (Fraction(dice.randint(1, 3 * parts), parts) for _ in range(2))
        new = box(x, y, wide, high)
        if not any(overlap(new, other, Fraction(1, 2 * parts)) for other in found):
            found.append(new)
        if len(found) == count:
            break
    return found


def boxes(dice: Dice) -> Shape:
    """On a lattice."""
    return [[ring] for ring in _boxes(dice, dice.randint(3, 6), dice.randint(7, 12), 1)]


def scattered(dice: Dice) -> Shape:
    """Boxes off the lattice."""
    return [[ring] for ring in _boxes(dice, dice.randint(3, 6), 9, dice.choice((97, 101, 1009)))]


def mirrored(dice: Dice) -> Shape:
    """Boxes and their images in one or both axes."""
    own = _boxes(dice, dice.randint(2, 3), 6, 1)
    far = dice.randint(1, 3)
    shape: Shape = [[[(x + far, y + far) for x, y in ring]] for ring in own]
    shape += mapped(shape, lambda p: (-p[0], p[1]))
    if dice.random() < 0.5:
        shape += mapped(shape, lambda p: (p[0], -p[1]))
    return [[_turned_left(ring) for ring in polygon] for polygon in shape]


def comb(dice: Dice) -> Shape:
    """Teeth of several lengths with edges on few lines; perhaps a bar before them."""
    x, top = 0, dice.randint(3, 4)
    teeth: Ring = []
    count = dice.randint(3, 4)
    gap = dice.randint(1, 3)
    for k in range(count):
        wide = dice.randint(1, 2)
        teeth += [(x, top), (x + wide, top)]
        x += wide
        if k < count - 1:
            floor = dice.randint(1, top - 1)
            wide = gap if dice.random() < 0.7 else dice.randint(1, 4)
            teeth += [(x, floor), (x + wide, floor)]
            x += wide
    # Teeth run to the right: the set lies below.
    ring = _turned_left([(0, 0), (x, 0), *reversed(teeth)])
    shape: Shape = [[ring]]
    if dice.random() < 0.6:
        shape.append([box(dice.randint(-1, 1), top + dice.randint(1, 4), x, 1)])
    return shape


def rooms(dice: Dice) -> Shape:
    """A hole with rooms in a row, or around a block, with doors of few widths."""
    door = Fraction(dice.randint(1, 2))
    x = 0
    low: Ring = []
    high: Ring = []
    for _ in range(dice.randint(2, 4)):
        wide, up, down = dice.randint(3, 6), dice.randint(2, 5), dice.randint(2, 5)
        low += [(x, -down), (x + wide, -down)]
        high += [(x, up), (x + wide, up)]
        x += wide
        own = door if dice.random() < 0.7 else Fraction(dice.randint(1, 3))
        low += [(x, -own / 2), (x + 1, -own / 2)]
        high += [(x, own / 2), (x + 1, own / 2)]
        x += 1
    hole: Ring = [*low[:-2], *reversed(high[:-2])]
    if dice.random() < 0.5:
        hole = [(y, z) for z, y in hole]
    return [[_frame(hole), _turned_left(hole)[::-1]]]


def blocks(dice: Dice) -> Shape:
    """Blocks in rows and columns, with streets of equal width."""
    street, x = dice.randint(1, 3), 0
    found: list[Ring] = []
    rows = [dice.randint(1, 4) for _ in range(2)]
    for _ in range(dice.randint(3, 4)):
        wide, y = dice.randint(1, 4), 0
        for high in rows:
            found.append(box(x, y, wide, high))
            y += high + street
        x += wide + street
    return [[ring] for ring in found]


def cells(dice: Dice) -> Shape:
    """Whole grid cells, which may touch at points; perhaps with straight vertices."""
    size = dice.randint(3, 5)
    outside = frame = _core_set([box(-1, -1, size + 2, size + 2)])
    for x in range(size):
        for y in range(size):
            if dice.random() < 0.45:
                outside = _core.minus(outside, _core_set([box(x, y, 1, 1)]))
    found = _core.minus(frame, outside)
    return [[[(Fraction(x), Fraction(y)) for x, y in ring] for ring in polygon]
            for polygon in found.rings()]  # fmt: skip


def triangles(dice: Dice) -> Shape:
    """Right triangles with sides of Pythagorean triples, off the lattice or on it."""
    parts = dice.choice((1, 1, 89))
    found: list[Ring] = []
    for _ in range(PATIENCE):
        a, b, _ = dice.choice(TRIPLES[:2])
        factor = Fraction(dice.randint(parts, 2 * parts), parts) / 2
        i, j = dice.choice(((1, 1), (-1, 1), (1, -1), (-1, -1)))
        x, y = (Fraction(dice.randint(0, 14 * parts), parts) for _ in range(2))
        new: Ring = [(x, y), (x + i * a * factor, y), (x, y + j * b * factor)]
        if not any(overlap(new, other, Fraction(1, 4)) for other in found):
            found.append(_turned_left(new))
        if len(found) == 4:
            break
    return [[ring] for ring in found]


def straightened(dice: Dice) -> Shape:
    """Boxes with further vertices on their sides."""
    shape = boxes(dice)
    return [[_with_straight(dice, ring)] for (ring,) in shape]


def _with_straight(dice: Dice, ring: Ring) -> Ring:
    found: Ring = []
    for (ax, ay), (bx, by) in zip(ring, [*ring[1:], ring[0]], strict=True):
        found.append((ax, ay))
        for k in sorted({dice.randint(1, 5) for _ in range(dice.randint(0, 2))}):
            t = Fraction(k, 6)
            found.append((ax + t * (bx - ax), ay + t * (by - ay)))
    k = dice.randrange(len(found))
    return [*found[k:], *found[:k]]


def turned(dice: Dice) -> Shape:
    """Boxes, scattered parts or rooms, turned by an angle with rational sine and cosine."""
    a, b, c = dice.choice(TRIPLES)
    x, y = Fraction(a, c), Fraction(b, c)
    return mapped(dice.choice((boxes, scattered, rooms))(dice),
                  lambda p: (x * p[0] - y * p[1], y * p[0] + x * p[1]))  # fmt: skip


def _frame(hole: Ring) -> Ring:
    xs, ys = [p[0] for p in hole], [p[1] for p in hole]
    return box(min(xs) - 1, min(ys) - 1, max(xs) - min(xs) + 2, max(ys) - min(ys) + 2)


def _turned_left(ring: Ring) -> Ring:
    pairs = zip(ring, [*ring[1:], ring[0]], strict=True)
    return ring if sum(p[0] * q[1] - p[1] * q[0] for p, q in pairs) > 0 else ring[::-1]


def _core_set(rings: list[Ring]) -> _core.PolygonSet:
    return _core.PolygonSet.from_json(shape_text([rings]))


KINDS: dict[str, Callable[[Dice], Shape]] = {
    each.__name__: each
    for each in (
        boxes,
        mirrored,
        comb,
        rooms,
        blocks,
        cells,
        straightened,
        scattered,
        triangles,
        turned,
    )
}


def drawn_set(seed: int, number: int) -> tuple[str, Shape]:
    """Draws a valid set of the kind for this number. Equal numbers give equal sets."""
    kind = list(KINDS)[number % len(KINDS)]
    dice = Dice(f"minkref places {seed}:{number}")
    while True:
        shape = KINDS[kind](dice)
        if not shape:
            continue
        try:
            set_of(shape).validate("P")
        except _core.BadInput:
            continue
        return f"{kind} {seed}:{number}", shape


def set_of(shape: Shape) -> _core.PolygonSet:
    return _core.PolygonSet.from_json(shape_text(shape))


def changed(dice: Dice, shape: Shape) -> tuple[str, Shape, Callable[[Point], Point]]:
    """Writes the same set differently, or maps it; also returns the map of points."""
    way = dice.choice(("order", "mirrored", "turned", "larger"))
    changes: dict[str, Callable[[Point], Point]] = {
        "order": lambda p: p,
        "mirrored": lambda p: (-p[0], p[1]),
        "turned": lambda p: (-p[1], p[0]),
        "larger": lambda p: (3 * p[0] + 5, 3 * p[1] - 7),
    }
    change = changes[way]
    found = scaled(shape, 1) if way == "order" else mapped(shape, change)
    if way == "mirrored":
        found = [[ring[::-1] for ring in polygon] for polygon in found]
    dice.shuffle(found)
    found = [[_started(dice, ring) for ring in polygon] for polygon in found]
    return way, [[outer, *dice.sample(holes, len(holes))] for outer, *holes in found], change


def _started(dice: Dice, ring: Ring) -> Ring:
    k = dice.randrange(len(ring))
    return [*ring[k:], *ring[:k]]
