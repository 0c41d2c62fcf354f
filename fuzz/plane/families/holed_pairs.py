"""Operands with holes: nested polygons, holes in both, many holes with few that survive, holes and
notches that the other operand fits exactly."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref.fuzz.geometry.plane import Polygon, Ring, Shape, box, extent
from minkref.fuzz.plane.families.drawing import around, convex, family
from minkref.fuzz.plane.families.outlines import comb

TINY = Fraction(1, 2**20)


@family("nested")
def nested_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """Polygons inside holes of polygons, perhaps beside others; Q about as wide as the gaps."""
    corners = dice.choice((3, 4, 4, 5, 6, 8)) if size > 20 else 4
    rings = max(3, (size - 4) // corners)
    beside = dice.random() < 0.4 and rings > 4
    gap = dice.randint(2, 4)
    P = _onion(dice, corners, rings - (3 if beside else 0), gap)
    if beside:
        shift = extent(P[0][0])[2] + dice.randint(1, 6)
        second = _onion(dice, corners, 3, gap)
        P += [[[(x + shift, y) for x, y in ring] for ring in polygon] for polygon in second]
    width = gap + Fraction(dice.randint(-3, 3), 2)
    height = gap + dice.randint(-1, 2)
    Q: Polygon = [box(0, 0, width if width > 1 else 1, height)]
    if size > 16 and dice.random() < 0.3:
        Q.append(box(*(Fraction(1, 4),) * 2, Fraction(1, 2), Fraction(1, 4)))
    if size > 16 and dice.random() < 0.2:  # a second part, too large for the same hole
        far = extent(P[0][0])[2]
        return P, [Q, [box(far + dice.randint(0, 2), 0, 1, 1)]]
    return P, [Q]


def _onion(dice: random.Random, corners: int, rings: int, gap: int) -> Shape:
    """Rings within rings; every other pair forms a polygon with its hole."""
    radii = [5]
    for _ in range(rings - 1):
        radii.append(radii[-1] + dice.randint(gap, gap + 3) * (3 if corners == 3 else 2))
    made = [around(corners, radius) for radius in reversed(radii)]
    return [made[k : k + 2] for k in range(0, rings, 2)]


@family("holes")
def holes_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """Plates with holes in both operands, one operand often as large as a hole of the other."""
    room = max(1, (size - 8) // 4)
    first = dice.randint(1, max(1, room - 1))
    P = plate(dice, first, dice.randint(2, 9))
    Q = plate(dice, max(1, min(4, room - first)), dice.randint(2, 9))
    share = dice.choice((1, Fraction(1, 2), Fraction(1, 3), Fraction(1, 6), Fraction(1, 10)))
    return [P], [[[(x * share, y * share) for x, y in ring] for ring in Q]]


def plate(dice: random.Random, holes: int, side: int) -> Polygon:
    """A box, perhaps with a corner cut off, with holes in lattice cells."""
    across = 1
    while across * across < holes:
        across += 1
    down = -(-holes // across)
    pitch = side + 1
    width, height = across * pitch + 1, down * pitch + 1
    outer: Ring = box(0, 0, width, height)
    if dice.random() < 0.3:
        outer[2:3] = [(width, height - Fraction(1, 2)), (width - Fraction(1, 2), height)]
    rings = [outer]
    for k in range(holes):
        hole = convex(dice, dice.randint(3, 4), side)
        x, y = 1 + k % across * pitch, 1 + k // across * pitch
        rings.append([(a + x, b + y) for a, b in hole])
    return rings


@family("small-holes")
def small_holes_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """A plate whose holes equal the other operand turned by half, at sizes about its own: most
    holes are too small to survive, perhaps by nothing, and some just survive."""
    corners = 3 if size < 16 else dice.randint(3, 5)
    Q = convex(dice, corners, dice.choice((3, 5, 8)))
    holes = max(2, (size - 4) // len(Q) - 1)
    across = 1
    while across * across < holes:
        across += 1
    _, _, width, height = extent(Q)
    pitch_x, pitch_y = 2 * width + 1, 2 * height + 1
    rings: Polygon = [box(-1, -1, across * pitch_x + 2, -(-holes // across) * pitch_y + 2)]
    sizes = (1 + TINY, Fraction(65, 64), Fraction(3, 2), 1 - TINY, Fraction(63, 64), 1, 1)
    for k in range(holes):
        factor = dice.choice(sizes[:3] if dice.random() < 0.4 else (*sizes[3:], Fraction(1, 3)))
        if k == 0:
            factor = dice.choice(sizes[:3])
        x, y = k % across * pitch_x, k // across * pitch_y
        rings.append([((width - a) * factor + x, (height - b) * factor + y) for a, b in Q])
    return [rings], [[Q]]


@family("fit")
def fit_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """Q fits exactly into a hole, notch or slot of P, or misses the size by one part in 2^20."""
    off = dice.choice((0, 0, TINY, -TINY))
    kind = dice.random()
    if kind < 0.55:
        Q = _piece(dice, max(3, min(12, size // 2 - 2)))
        x, y, width, height = extent(Q)
        hole: Ring = [((x - a) * (1 + off), (y - b) * (1 + off)) for a, b in Q]
        if dice.random() < 0.2:  # the bounding box alone
            hole = box(
                -width * (1 + off), -height * (1 + off), width * (1 + off), height * (1 + off)
            )
        outer = box(-width - 2, -height - 2, width + 4, height + 4)
        return [[outer, hole]], [[Q]]
    w, h = dice.randint(1, 4), dice.randint(1, 4)
    notches = max(1, size // 4 - 2)
    P: Ring = [(0, 0)]
    x = 0
    for _ in range(notches):
        deep = min(h, dice.randint(1, 4))
        P += [(x + 1, 0), (x + 1, deep), (x + 1 + w + off, deep), (x + 1 + w + off, 0)]
        x += w + 2
    P += [(x + 1, 0), (x + 1, h + 2), (0, h + 2)]
    if kind < 0.75:
        return [[P]], [[box(0, 0, w, h)]]
    return [[P]], [[[(0, 0), (w, 0), (w, h), (Fraction(w, 2), h + dice.randint(0, 2))]]]


def _piece(dice: random.Random, corners: int) -> Ring:
    """A convex ring, an L, a cross or a comb."""
    a, b, c = (dice.randint(1, 3) for _ in range(3))
    if corners >= 12 and dice.random() < 0.4:
        return [
            (a, 0), (a + b, 0), (a + b, a), (a + b + c, a), (a + b + c, a + b), (a + b, a + b),
            (a + b, a + b + c), (a, a + b + c), (a, a + b), (0, a + b), (0, a), (a, a),
        ]  # fmt: skip
    if corners >= 8 and dice.random() < 0.3:
        count = corners // 4
        return comb(dice, [Fraction(1)] * count, [Fraction(b)] * (count - 1))
    if corners >= 6 and dice.random() < 0.4:
        return [(0, 0), (a + b, 0), (a + b, c), (a, c), (a, b + c), (0, b + c)]
    return convex(dice, corners, 9)
