"""Degenerate unions in whole numbers: each function draws one kind."""

from __future__ import annotations

import random
from collections.abc import Callable

from minkref.fuzz.geometry.plane import Point, Ring, Shape, box, moved, read_shape, scaled
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import convex, placed
from minkref.fuzz.plane.families.lattice_pairs import lattice_operand

Sets = list[Shape]
LONG = 1 << 16  # of slivers and edges that are nearly parallel
FAR = 1 << 20


def edge_in_common(dice: Dice) -> Sets:
    """Boxes abutting along an edge, wholly or partly; perhaps a triangle above."""
    w, h = dice.randint(1, 6), dice.randint(2, 6)
    low, high = (0, h) if dice.random() < 0.4 else sorted(dice.sample(range(-3, h + 4), 2))
    if high <= 0 or low >= h:
        low, high = 1, h + 3
    sets: Sets = [[[box(0, 0, w, h)]], [[box(w, low, dice.randint(1, 6), high - low)]]]
    if dice.random() < 0.4:
        sets.append([[[(0, h), (w, h), (dice.randint(0, 9), h + dice.randint(1, 5))]]])
    return sets


def equal_sets(dice: Dice) -> Sets:
    """One set two or three times, perhaps begun elsewhere and with vertices inside edges."""
    ring = scaled([[convex(dice, dice.randint(3, 6), 9)]], 2)[0][0]
    k = dice.randrange(len(ring))
    again = [*ring[k:], *ring[:k]]
    if dice.random() < 0.5:
        again = [point for pair in zip(again, _middles(again), strict=True) for point in pair]
    return [[[ring]], [[again]], *([[[ring]]] if dice.random() < 0.3 else [])]


def _middles(ring: Ring) -> Ring:
    ends = zip(ring, ring[1:] + ring[:1], strict=True)
    return [((a[0] + b[0]) // 2, (a[1] + b[1]) // 2) for a, b in ends]


def touching_vertices(dice: Dice) -> Sets:
    """Sets with only a vertex in common: the last vertex equals the first of the next set."""
    sets: Sets = [[[convex(dice, dice.randint(3, 6), 8)]]]
    for _ in range(dice.randint(1, 3)):
        last, ring = max(sets[-1][0][0]), convex(dice, dice.randint(3, 6), 8)
        first = min(ring)
        sets.append(moved([[ring]], last[0] - first[0], last[1] - first[1]))
    return sets


def vertex_on_edge(dice: Dice) -> Sets:
    """Triangles with the tip inside an edge of a box, from without or within."""
    w, h = dice.randint(4, 9), dice.randint(4, 9)
    sets: Sets = [[[box(0, 0, w, h)]]]
    for _ in range(dice.randint(1, 3)):
        x, up = dice.randint(1, w - 1), dice.choice((1, 2, -1, -2))
        sets.append(
            [[[(x, h), (x + dice.randint(1, 3), h + up), (x - dice.randint(1, 3), h + up)]]]
        )
    return sets


def in_a_hole(dice: Dice) -> Sets:
    """A frame, and a set in its hole: as large as the hole, touching its side, or free."""
    a, b = dice.randint(2, 6), dice.randint(2, 6)
    frame: Shape = [[box(-2, -2, a + 4, b + 4), box(0, 0, a, b)]]
    x, y = dice.randint(0, a - 1), dice.randint(0, b - 1)
    choices: list[Ring] = [
        box(0, 0, a, b),
        box(x, y, dice.randint(1, a - x), dice.randint(1, b - y)),
        [(0, 0), (a, 0), (0, b)],
        [(0, y), (a, 0), (x, b)],
    ]
    rest: Sets = [[[[(0, b), (a, 0), (a, b)]]]] if dice.random() < 0.3 else []
    return [frame, [[dice.choice(choices)]], *rest]


def partly_covered(dice: Dice) -> Sets:
    """A frame, and boxes over parts of its hole: across it, over a corner, or along a side."""
    a, b = dice.randint(3, 8), dice.randint(3, 8)
    frame: Shape = [[box(-2, -2, a + 4, b + 4), box(0, 0, a, b)]]
    sets: Sets = [frame]
    for _ in range(dice.randint(1, 2)):
        x, y = dice.randint(0, a - 1), dice.randint(0, b - 1)
        across = box(x, dice.choice((-1, -2, -3, 0)), dice.randint(1, 3), b + dice.randint(1, 4))
        corner = box(x, y, a - x + dice.randint(0, 3), b - y + dice.randint(0, 3))
        slanted: Ring = [(-1, y), (x, -1), (a + 1, b), (a, b + 1)]
        ring = dice.choice((across, corner, slanted))
        sets.append([[ring]])
    return sets


def slivers(dice: Dice) -> Sets:
    """Triangles and needles far longer than they are thick, that cross at small angles."""
    sets: Sets = []
    for _ in range(dice.randint(2, 4)):
        length, y = dice.randint(LONG // 2, LONG), dice.randint(-3, 3)
        tip = (length, y + dice.randint(-3, 3))
        sets.append(
            [[[(dice.randint(0, 3), y), tip, (dice.randint(0, 3), y + dice.randint(1, 2))]]]
        )
    return sets


def nearly_parallel(dice: Dice) -> Sets:
    """Quadrilaterals with long sides, whose directions differ by one unit at the end."""
    length = dice.randint(LONG // 2, LONG)
    up, thick = dice.randint(1, 2 * LONG), dice.randint(1, 9)
    sets: Sets = []
    for _ in range(dice.randint(2, 3)):
        x, y = dice.randint(0, 2), dice.randint(-1, 1)
        end = (x + length + dice.randint(-1, 1), y + up + dice.randint(-1, 1))
        down = dice.choice((thick, -thick))
        sets.append([[[(x, y), end, (end[0], end[1] + down), (x, y + down)]]])
    return sets


def nearly_equal(dice: Dice) -> Sets:
    """A large set, and the same moved by a unit, or with one vertex moved by a unit."""
    ring = scaled([[convex(dice, dice.randint(3, 6), 9)]], FAR // 16)[0][0]
    dx, dy = dice.choice(((1, 0), (0, 1), (1, 1), (-1, 1)))
    k = dice.randrange(len(ring))
    one = [*ring[:k], (ring[k][0] + dx, ring[k][1] + dy), *ring[k + 1 :]]
    whole = [(x + dx, y + dy) for x, y in ring]
    return [[[ring]], [[dice.choice((one, whole))]]]


def mixed_magnitudes(dice: Dice) -> Sets:
    """A unit box at a corner or a side of a huge set, and perhaps one far away."""
    box_or_triangle: list[Ring] = [
        box(0, 0, FAR, FAR),
        [(0, 0), (FAR, 0), (FAR, FAR - 1)],
        [(0, 0), (FAR, 1), (0, FAR)],
    ]
    huge = dice.choice(box_or_triangle)
    x, y = dice.choice(huge) if dice.random() < 0.5 else (dice.randint(0, FAR), 0)
    sets: Sets = [[[huge]], [[box(x - dice.randint(0, 1), y - dice.randint(0, 1), 1, 1)]]]
    if dice.random() < 0.5:
        sets.append([[box(-dice.randint(1, FAR), dice.randint(-FAR, FAR), 1, 1)]])
    return sets


def one_lattice(dice: Dice) -> Sets:
    """Several sets on few points of the lattice, with holes and parts."""
    return [
        read_shape(lattice_operand(dice, dice.random() < 0.4, 10))
        for _ in range(dice.randint(2, 4))
    ]


def ring_of_touches(dice: Dice) -> Sets:
    """Four boxes or rhombs that touch at corners and enclose a component, and perhaps fill it."""
    n = dice.randint(1, 5)
    if dice.random() < 0.5:
        rhomb: Ring = [(0, -n), (n, 0), (0, n), (-n, 0)]
        places: list[Point] = [(0, 0), (2 * n, 0), (n, n), (n, -n)]
        sets = [moved([[rhomb]], *place) for place in places]
        return sets[: dice.randint(3, 4)]
    sets = [[[box(x * n, y * n, n, n)]] for x, y in ((0, 1), (1, 0), (2, 1), (1, 2))]
    half: Ring = [(n, n), (2 * n, n), (n, 2 * n)]
    filled = dice.choice(([], [], [box(n, n, n, n)], [half]))
    return [*sets, *([[each]] for each in filled)]


def many_seams(dice: Dice) -> Sets:
    """Triangles and cells of a grid, dealt out to sets: seams everywhere, and few edges left."""
    side = dice.randint(2, 3)
    sets: Sets = []
    for x in range(side):
        for y in range(side):
            cell = box(x, y, 1, 1)
            k = dice.randrange(2)
            corners = [cell[k], cell[k + 1], cell[(k + 2) % 4]], [cell[k], cell[k + 2], cell[k - 1]]
            if dice.random() < 0.2:
                continue
            sets += [[[cell]]] if dice.random() < 0.5 else [[[ring]] for ring in corners]
    return sets if len(sets) > 1 else [[[box(0, 0, 1, 1)]], [[box(1, 0, 1, 1)]]]


def many_at_a_vertex(dice: Dice) -> Sets:
    """Triangles with one tip in common, some with sides in common, perhaps all the way round."""
    ring = convex(dice, dice.randint(5, 8), 12)
    x, y = dice.choice([(6, 6), (5, 7), (6, 5)])
    fan = [[[[(x, y), a, b]]] for a, b in zip(ring, ring[1:] + ring[:1], strict=True)]
    kept = [shape for shape in fan if dice.random() < 0.8]
    return kept if len(kept) > 1 else fan


KINDS: dict[str, Callable[[Dice], Sets]] = {
    "an edge in common": edge_in_common,
    "equal sets": equal_sets,
    "touching vertices": touching_vertices,
    "a vertex on an edge": vertex_on_edge,
    "in a hole": in_a_hole,
    "a hole partly covered": partly_covered,
    "slivers": slivers,
    "nearly parallel edges": nearly_parallel,
    "nearly equal": nearly_equal,
    "huge and tiny": mixed_magnitudes,
    "one lattice": one_lattice,
    "a ring of touches": ring_of_touches,
    "many seams": many_seams,
    "many at a vertex": many_at_a_vertex,
}


def degenerate_sets(dice: Dice, kind: str) -> Sets:
    """Draws sets of this kind, turned by right angles, mirrored, and in any order."""
    sets = KINDS[kind](dice)
    turns, mirrored = dice.randrange(4), dice.random() < 0.5
    sets = [placed(shape, turns, mirrored) for shape in sets]
    random.Random.shuffle(dice, sets)
    return sets
