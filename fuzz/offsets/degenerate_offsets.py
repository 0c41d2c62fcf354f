"""Sets to grow in whole numbers: each function draws one kind. Much happens at once at some radius,
or nearly so."""

from __future__ import annotations

from collections.abc import Callable

from minkref.fuzz.geometry.plane import Point, Polygon, Ring, Shape, box, moved, read_shape, scaled
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import convex, placed
from minkref.fuzz.plane.families.lattice_pairs import lattice_operand

LONG = 1 << 12  # of walls and spikes
ON_CIRCLES: dict[int, list[Point]] = {
    5: [(5, 0), (4, 3), (3, 4), (0, 5)],
    13: [(13, 0), (12, 5), (5, 12), (0, 13)],
    25: [(25, 0), (24, 7), (20, 15), (15, 20), (7, 24), (0, 25)],
}


def closing_pocket(dice: Dice) -> Shape:
    """A block with a pocket, wider inside than at the mouth."""
    mouth, wide, deep = dice.randint(1, 3), dice.randint(2, 6), dice.randint(2, 6)
    left = dice.randint(0, wide)
    floor, lip = dice.randint(1, 2), dice.randint(1, 3)
    x0, x1 = -left - 2, mouth + wide - left + 2
    top = floor + deep + lip
    pocket: Ring = [
        (mouth, top), (mouth, floor + deep), (mouth + wide - left, floor + deep),
        (mouth + wide - left, floor), (-left, floor), (-left, floor + deep), (0, floor + deep),
        (0, top),
    ]  # fmt: skip
    ring: Ring = [(x0, 0), (x1, 0), (x1, top), *pocket, (x0, top)]
    return [[[p for k, p in enumerate(ring) if p != ring[k - 1]]]]


def neck(dice: Dice) -> Shape:
    """A hole of two rooms with a neck between them."""
    a, b, c = (dice.randint(2, 6) for _ in range(3))
    wide, long = dice.randint(1, min(a, c)), dice.randint(1, 4)
    y = dice.randint(0, min(a, c) - wide)
    hole: Ring = [
        (0, 0), (b, 0), (b, y), (b + long, y), (b + long, 0), (2 * b + long, 0),
        (2 * b + long, c), (b + long, c), (b + long, y + wide), (b, y + wide), (b, a), (0, a),
    ]  # fmt: skip
    hole = [p for k, p in enumerate(hole) if p != hole[k - 1]]
    return [[box(-2, -2, 2 * b + long + 4, max(a, c) + 4), hole]]


def parallel_walls(dice: Dice) -> Shape:
    """Bars side by side, some gaps equal."""
    gap, x = dice.randint(1, 3), 0
    shape: Shape = []
    for _ in range(dice.randint(2, 4)):
        wide = dice.randint(1, 3)
        shape.append([box(x, dice.randint(-3, 0), wide, dice.randint(4, 9))])
        x += wide + (gap if dice.random() < 0.7 else dice.randint(1, 5))
    return shape


def nearly_parallel_walls(dice: Dice) -> Shape:
    """A slot, or two bars, whose sides differ by one or two units over their length."""
    wide, off = dice.randint(LONG // 32, LONG // 8), dice.choice((-2, -1, 1, 2))
    thick = LONG // 16
    low: Ring = [(0, -thick), (LONG, -thick), (LONG, 0), (0, 0)]
    high: Ring = [(0, wide), (LONG, wide + off), (LONG, wide + thick), (0, wide + thick)]
    if dice.random() < 0.5:
        return [[low], [high]]
    wall: Ring = [(-thick, -thick), *low[1:3], low[3], high[0], high[1], high[2]]
    return [[[*wall, (-thick, wide + thick)]]]


def nearly_straight(dice: Dice) -> Shape:
    """A convex set with one vertex a unit off the middle of an edge, inwards or outwards."""
    ring = scaled([[convex(dice, dice.randint(3, 6), 9)]], LONG)[0][0]
    k = dice.randrange(len(ring))
    (ax, ay), (bx, by) = ring[k - 1], ring[k]
    off = dice.choice(((1, 0), (0, 1), (-1, 0), (0, -1), (1, 1)))
    return [[[*ring[:k], ((ax + bx) // 2 + off[0], (ay + by) // 2 + off[1]), *ring[k:]]]]


def touching_arcs(dice: Dice) -> Shape:
    """Triangles whose tips face each other, all as far apart, in a row or around a place."""
    gap = 2 * dice.randint(1, 4)
    up, back = dice.randint(1, 4), dice.randint(1, 5)
    tip: Ring = [(0, 0), (-back, up), (-back, -up)]
    if dice.random() < 0.5:
        rest: Ring = [(gap, 0), (gap + back, -up), (gap + back, up)]
        return [[tip], [rest]]
    shape: Shape = moved([[tip]], -gap // 2, 0)
    return [polygon for turns in range(4) for polygon in placed(shape, turns, False)][
        : dice.randint(3, 4)
    ]


def on_a_circle(dice: Dice) -> Shape:
    """Vertices on one circle: a set's, a hole's, or small triangles' around the centre."""
    radius = dice.choice(tuple(ON_CIRCLES))
    ring: list[Point] = []
    for turns in range(4):
        own = [p for p in ON_CIRCLES[radius][:-1] if dice.random() < 0.7]
        for x, y in own:
            for _ in range(turns):
                x, y = -y, x
            ring.append((x, y))
    if len(ring) < 3:
        ring = [(radius, 0), (0, radius), (-radius, 0), (0, -radius)]
    way = dice.randrange(3)
    if way == 0:
        return [[ring]]
    if way == 1:
        return [[box(-radius - 1, -radius - 1, 2 * radius + 2, 2 * radius + 2), ring]]
    spikes: Shape = [[[(x, y), (2 * x, 2 * y + 1), (2 * x - 1, 2 * y)]] for x, y in ring]
    return [[each[0] if _left(each[0]) else each[0][::-1]] for each in spikes if _area(each[0])]


def _area(ring: Ring) -> int:
    return int(sum(ring[k - 1][0] * p[1] - ring[k - 1][1] * p[0] for k, p in enumerate(ring)))


def _left(ring: Ring) -> bool:
    return _area(ring) > 0


def vanishing_holes(dice: Dice) -> Shape:
    """A plate with holes, some of one inradius: squares, bars, triangles with sides 3, 4, 5."""
    unit = dice.randint(1, 3)
    holes: list[Ring] = []
    x = 1
    for _ in range(dice.randint(1, 3)):
        way = dice.randrange(4)
        width = 2 * unit
        if way == 0:
            hole = box(x, 1, 2 * unit, 2 * unit)
        elif way == 1:
            hole = box(x, 1, 2 * unit, 2 * unit + dice.randint(1, 3))
        elif way == 2:  # inradius `unit`
            hole, width = [(x, 1), (x + 4 * unit, 1), (x, 1 + 3 * unit)], 4 * unit
        else:
            width = dice.randint(1, 5)
            hole = box(x, 1, width, dice.randint(1, 5))
        holes.append(hole)
        x += width + dice.randint(1, 2)
    high = max(p[1] for hole in holes for p in hole) + 1
    return [[box(0, 0, x, high), *holes]]


def points_and_segments(dice: Dice) -> Shape:
    a = (dice.randint(-5, 5), dice.randint(-5, 5))
    b = (a[0] + dice.randint(0, 4), a[1] + dice.randint(-4, 4))
    return [[[a, b] if a != b else [a]]]


def nested_islands(dice: Dice) -> Shape:
    """Frames within frames, and perhaps an island in the innermost."""
    x = 0
    shape: Shape = []
    size = dice.randint(14, 20)
    while size > 2 and len(shape) < 4:
        thick, gap = dice.randint(1, 2), dice.randint(1, 2)
        inner = size - 2 * thick
        if inner <= 1 or (len(shape) > 1 and dice.random() < 0.3):
            shape.append([box(x, x, size, size)])
            break
        shape.append([box(x, x, size, size), box(x + thick, x + thick, inner, inner)])
        x, size = x + thick + gap, inner - 2 * gap
    return shape


def touching_rings(dice: Dice) -> Shape:
    """Cells of a grid that touch at corners, some halved."""
    side = dice.randint(2, 4)
    shape: Shape = []
    for x in range(side):
        for y in range(side):
            if (x + y) % 2 == 0 and dice.random() < 0.85:
                cell = box(2 * x, 2 * y, 2, 2)
                if dice.random() < 0.25:
                    cell.pop(dice.randrange(4))
                shape.append([cell])
    return shape or [[box(0, 0, 2, 2)]]


def on_the_lattice(dice: Dice) -> Shape:
    return read_shape(lattice_operand(dice, dice.random() < 0.4, 14))


def spikes(dice: Dice) -> Shape:
    """Long thin needles beside each other."""
    shape: Shape = []
    y = 0
    for _ in range(dice.randint(1, 3)):
        length, thick = dice.randint(LONG // 2, LONG), dice.randint(1, 2)
        shape.append([[(0, y), (length, y + dice.randint(0, thick)), (0, y + thick)]])
        y += thick + dice.randint(1, LONG // 8)
    return shape


def notched(dice: Dice) -> Shape:
    """A huge box with a notch or a step, one unit large."""
    x = dice.randint(1, LONG - 2)
    if dice.random() < 0.5:
        top: list[Point] = [(x + 1, LONG), (x + 1, LONG - 1), (x, LONG - 1), (x, LONG), (0, LONG)]
        return [[[(0, 0), (LONG, 0), (LONG, LONG), *top]]]
    return [[[(0, 0), (LONG, 0), (LONG, LONG), (x, LONG), (x, LONG + 1), (0, LONG + 1)]]]


def straight_vertices(dice: Dice) -> Shape:
    """Boxes and triangles with further vertices on their sides."""
    ring = scaled([[convex(dice, dice.randint(3, 5), 6)]], 4)[0][0]
    found: Ring = []
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        found.append(a)
        for k in sorted({dice.randint(1, 3) for _ in range(dice.randint(0, 2))}):
            found.append((a[0] + (b[0] - a[0]) * k // 4, a[1] + (b[1] - a[1]) * k // 4))
    return [[found]]


def rooms_in_a_row(dice: Dice) -> Shape:
    """A comb whose gaps have few widths, with a bar before its teeth."""
    gap, x, top = dice.randint(1, 3), 0, dice.randint(3, 5)
    teeth: Ring = []
    for k in range(dice.randint(3, 4)):
        if k:
            floor = dice.randint(1, top - 1)
            wide = gap if dice.random() < 0.7 else dice.randint(1, 4)
            teeth += [(x, floor), (x + wide, floor)]
            x += wide
        wide = dice.randint(1, 2)
        teeth += [(x, top), (x + wide, top)]
        x += wide
    comb: Polygon = [[(x, 0), *reversed(teeth), (0, 0)]]
    return [comb, [box(dice.randint(-1, 1), top + dice.randint(1, 4), x, 1)]]


KINDS: dict[str, Callable[[Dice], Shape]] = {
    "a closing pocket": closing_pocket,
    "a neck": neck,
    "parallel walls": parallel_walls,
    "nearly parallel walls": nearly_parallel_walls,
    "a nearly straight vertex": nearly_straight,
    "arcs that touch": touching_arcs,
    "vertices on a circle": on_a_circle,
    "vanishing holes": vanishing_holes,
    "a point or a segment": points_and_segments,
    "nested islands": nested_islands,
    "touching rings": touching_rings,
    "on the lattice": on_the_lattice,
    "spikes": spikes,
    "a huge set with a notch": notched,
    "straight vertices": straight_vertices,
    "rooms in a row": rooms_in_a_row,
}


def degenerate_set(dice: Dice, kind: str) -> Shape:
    """Draws a set of this kind, turned by right angles, perhaps mirrored."""
    shape = KINDS[kind](dice)
    return placed(shape, dice.randrange(4), dice.random() < 0.5)
