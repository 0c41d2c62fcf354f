"""Shapes from all families, most of them spoilt: about as many valid as invalid."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from random import Random

from minkref.fuzz.geometry.plane import (
    Ring,
    Shape,
    doubled_area,
    extent,
    mapped,
    moved,
    read_shape,
    scaled,
)
from minkref.fuzz.plane.families.catalogue import FAMILIES

CHANGES = 11


def shapes(seed: int, first: int, count: int) -> Iterator[tuple[str, Shape]]:
    """Each with a name. Outer rings run counter-clockwise, holes clockwise."""
    for index in range(first, first + count):
        for name, family in FAMILIES.items():
            pair = family.pair(seed, index)
            dice = Random(f"spoilt {name} {seed} {index}")
            operands = [read_shape(text) for text in (pair.P, pair.Q)]
            for which, shape in enumerate(operands):
                yield f"{name}:{seed}:{index} {'PQ'[which]}", shape
                for times in (1, 2):
                    spoilt = [[list(ring) for ring in polygon] for polygon in shape]
                    for _ in range(times):
                        spoilt = spoil(dice, spoilt, operands[1 - which])
                    yield f"{name}:{seed}:{index} {'PQ'[which]} spoilt {times}", turned(spoilt)


def turned(shape: Shape) -> Shape:
    return [
        [
            ring if (doubled_area(ring) > 0) == (r == 0) else ring[::-1]
            for r, ring in enumerate(rings)
        ]
        for rings in shape
    ]


def spoil(dice: Random, shape: Shape, other: Shape) -> Shape:
    if not any(len(ring) > 2 for polygon in shape for ring in polygon):
        return shape
    polygon = dice.choice(shape)
    ring = dice.choice(polygon)
    k = dice.randrange(len(ring))
    points = [p for rings in shape for each in rings for p in each]
    kind = dice.randrange(CHANGES)
    if kind == 0:  # onto another vertex
        ring[k] = dice.choice(points)
    elif kind == 1:  # onto an edge
        ring[k] = on_edge(dice, dice.choice(polygon))
    elif kind == 2:  # onto a vertex or an edge of another ring, as one more vertex
        ring.insert(k, dice.choice((dice.choice(points), on_edge(dice, dice.choice(polygon)))))
    elif kind == 3:
        ring[k], ring[k - 1] = ring[k - 1], ring[k]
    elif kind == 4 and len(ring) > 3:
        del ring[k]
    elif kind == 5:  # holes of another polygon
        dice.choice(shape).append(polygon.pop() if len(polygon) > 1 else list(ring))
    elif kind == 6:  # a ring within a ring, perhaps with a vertex in common
        about = dice.choice((ring[k], on_edge(dice, ring), inner(ring)))
        small = shrunk(ring, about, Fraction(1, dice.choice((2, 3, 8, 100))))
        shape.append([small]) if dice.random() < 0.4 else polygon.append(small)
    elif kind == 7:  # the other operand beside, above or within, perhaps with a vertex in common
        part = dice.choice((Fraction(1), Fraction(1, 4), Fraction(1, 64)))
        small_other = scaled(other, part)
        corner = dice.choice(
            [p for rings in small_other for each in rings for p in each] or [(0, 0)]
        )
        to = dice.choice((ring[k], on_edge(dice, ring), inner(ring)))
        shape += moved(small_other, to[0] - corner[0], to[1] - corner[1])
    elif kind == 8:  # touches itself or another at an edge
        polygon.append([ring[k], on_edge(dice, ring), on_edge(dice, dice.choice(polygon))])
    elif kind == 9:  # mirrored: vertices on the same lines
        x, _, width, _ = extent(ring)
        shape += mapped([polygon], lambda p: (2 * (x + width) - p[0], p[1]))
    else:  # moved a little, and by a whole width
        _, _, width, height = extent(ring)
        step = dice.choice(((0, height), (width, 0), (Fraction(1, 7), 0), (width / 2, height / 2)))
        ring[:] = [(p[0] + step[0], p[1] + step[1]) for p in ring]
    return [rings for rings in shape if rings]


def on_edge(dice: Random, ring: Ring) -> tuple[Fraction | int, Fraction | int]:
    k = dice.randrange(len(ring))
    (x0, y0), (x1, y1) = ring[k - 1], ring[k]
    t = dice.choice((Fraction(1, 2), Fraction(1, 3), Fraction(3, 4)))
    return (x0 + (x1 - x0) * t, y0 + (y1 - y0) * t)


def inner(ring: Ring) -> tuple[Fraction | int, Fraction | int]:
    """The centroid of the first three vertices."""
    return (sum(p[0] for p in ring[:3]) / Fraction(3), sum(p[1] for p in ring[:3]) / Fraction(3))


def shrunk(ring: Ring, about: tuple[Fraction | int, Fraction | int], by: Fraction) -> Ring:
    return [(about[0] + (x - about[0]) * by, about[1] + (y - about[1]) * by) for x, y in ring]


def toothed(ring: Ring, sign: int) -> Ring:
    """A ring that touches the given ring at all vertices and edge midpoints, and lies outside it if
    the ring runs counter-clockwise and the sign is 1, or clockwise and the sign is -1."""
    found: Ring = []
    for k, (x0, y0) in enumerate(ring):
        x1, y1 = ring[(k + 1) % len(ring)]
        dx, dy = x1 - x0, y1 - y0
        for t, deep in ((0, 0), (Fraction(1, 4), 1), (Fraction(1, 2), 0), (Fraction(3, 4), 1)):
            off = Fraction(deep * sign, 50)
            found.append((x0 + dx * t + dy * off, y0 + dy * t - dx * off))
    return found
