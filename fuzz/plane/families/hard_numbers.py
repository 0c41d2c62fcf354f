"""Operands whose numbers or proportions are hard: slivers, far from the origin, of very different
magnitudes, with denominators; and operands without area."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref.fuzz.geometry.plane import Polygon, Ring, Shape, box, mapped, moved
from minkref.fuzz.plane.families.drawing import convex, family
from minkref.fuzz.plane.families.integer_rings import scattered, untangled
from minkref.fuzz.plane.families.touching_pairs import touching_shape

LARGE_PRIMES = (10**9 + 7, 998_244_353, 2**61 - 1)


def polygon(dice: random.Random, vertices: int, holed: bool = True) -> Polygon:
    """A random simple ring on whole numbers, or a box with a hole of this kind."""
    vertices = max(3, min(vertices, 28))
    side = max(5, vertices)
    if holed and vertices > 7 and dice.random() < 0.4:
        hole = None
        while hole is None:
            hole = untangled(scattered(dice, min(vertices - 4, 12), side, side))
        return [box(-1, -1, side + 2, side + 2), list(hole)]
    ring = None
    while ring is None:
        ring = untangled(scattered(dice, vertices, side, side))
    return [list(ring)]


@family("thin")
def thin_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """Needles, long zigzags and flat boxes, against each other or against something stout."""
    P = _sliver(dice, size // 2)
    kind = dice.random()
    if kind < 0.2:
        return _nearly_parallel(dice)
    if kind < 0.5:
        return [[P]], [[_sliver(dice, size // 2)]]
    if kind < 0.8:
        return [[P]], [polygon(dice, size // 2)]
    return [[P]], [[convex(dice, size // 2, 9)]]


def _sliver(dice: random.Random, vertices: int) -> Ring:
    width = Fraction(1, dice.choice((10, 1000, 10**6, 10**9)))
    length = dice.choice((1, 7, 40))
    kind = dice.random()
    if kind < 0.3:
        x, y = dice.randint(-9, 9), dice.randint(1, 9)
        return [(0, 0), (length * x, length * y), (length * x, length * y + width)]
    if kind < 0.45:
        return box(0, 0, length, width)
    if kind < 0.6:
        return [(0, 0), (length, width), (2 * length, 0), (length, -width / 3)]
    bends = max(2, min(vertices // 2, 14))
    line = [(length * k, dice.randint(-3, 3)) for k in range(bends)]
    return [*line, *((x, y + width) for x, y in reversed(line))]


def _nearly_parallel(dice: random.Random) -> tuple[Shape, Shape]:
    """Two triangles with long edges whose directions differ by less than a double tells."""
    x, y = (dice.randint(2**40, 2**60) for _ in "xy")
    shapes: list[Shape] = []
    for _ in range(2):
        nx, ny = x + dice.randint(-2, 2), y + dice.randint(-2, 2)
        far, up = Fraction(dice.randint(1, 3)), dice.randint(1, 5)
        shapes.append([[[(0, 0), (far * nx, far * ny), (far * nx / 2, far * ny / 2 + up * 2**40)]]])
    return shapes[0], shapes[1]


@family("offset")
def offset_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """Ordinary operands far from the origin, one or both; perhaps a part far from the rest."""
    shapes: list[Shape] = [[polygon(dice, size // 2)], [polygon(dice, size // 3, False)]]
    far = 10 ** dice.randint(4, 15)
    for k in range(2):
        if k == 0 or dice.random() < 0.5:
            dx, dy = (
                Fraction(dice.choice((-1, 1)) * dice.randint(far, 2 * far), dice.choice((1, 3, 7)))
                for _ in "xy"
            )
            shapes[k] = moved(shapes[k], dx, dy)
    if dice.random() < 0.3:
        shapes[0] += moved([polygon(dice, 4, False)], far, far)
    return shapes[0], shapes[1]


@family("magnitude")
def magnitude_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """Each operand, perhaps each coordinate, times a power of two between 2^-30 and 2^30, or over a
    large prime."""
    shapes: list[Shape] = [[polygon(dice, size // 2)], [polygon(dice, size // 3)]]
    same = dice.random() < 0.6
    fx, fy = _factor(dice), _factor(dice)
    for k in range(2):
        if not same:
            fx = fy = _factor(dice)
        shapes[k] = mapped(shapes[k], lambda p, fx=fx, fy=fy: (p[0] * fx, p[1] * fy))  # type: ignore[misc]
    if dice.random() < 0.3:
        tiny = Fraction(1, dice.choice(LARGE_PRIMES))
        shapes[0] = [[_nudged(dice, ring, tiny) for ring in each] for each in shapes[0]]
    return shapes[0], shapes[1]


def _factor(dice: random.Random) -> Fraction:
    if dice.random() < 0.2:
        return Fraction(dice.randint(1, 10**9), dice.choice(LARGE_PRIMES))
    return Fraction(2) ** dice.randint(-30, 30)


def _nudged(dice: random.Random, ring: Ring, tiny: Fraction) -> Ring:
    """Every vertex moved a little: next to straight, next to parallel."""
    return [(x + tiny * dice.randint(-9, 9), y + tiny * dice.randint(-9, 9)) for x, y in ring]


@family("rational")
def rational_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """Vertices with denominators of one digit, different in the two operands."""
    shapes: list[Shape] = []
    for share in (2, 3):
        one, other = (dice.choice((2, 3, 4, 5, 6, 7, 9)) for _ in range(2))
        dx, dy = Fraction(dice.randint(-9, 9), other), Fraction(dice.randint(-9, 9), one)
        drawn = polygon(dice, size // share)
        shapes.append(
            [[[(Fraction(x, one) + dx, Fraction(y, other) + dy) for x, y in r] for r in drawn]]
        )
    return shapes[0], shapes[1]


@family("degenerate")
def degenerate_pair(dice: random.Random, size: int) -> tuple[Shape, Shape]:
    """A point, a segment or nothing beside an ordinary operand."""
    P: Shape = [polygon(dice, size - 2)]
    if dice.random() < 0.3:
        P = touching_shape(dice, max(8, size - 2))
    kind = dice.random()
    a, b, c, d = (Fraction(dice.randint(-12, 12), dice.choice((1, 1, 2, 3))) for _ in range(4))
    if kind < 0.15:
        return P, []
    if kind < 0.45:
        return P, [[[(a, b)]]]
    if kind < 0.6:  # along an edge
        p, q = P[0][0][:2]
        return P, [[[(a, b), (a + q[0] - p[0], b + q[1] - p[1])]]]
    if (a, b) == (c, d):
        c += 1
    return P, [[[(a, b), (c, d)]]]
