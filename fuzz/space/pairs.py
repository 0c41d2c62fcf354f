"""Seeded pairs in space, by family; small pairs first."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Scale
from minkref.fuzz.space.cells import Cell, surface_of
from minkref.fuzz.space.generators.convex import box, cube, random_hull, sphere
from minkref.fuzz.space.generators.over_polygon import random_prism
from minkref.fuzz.space.generators.polycube import (
    bodies_apart,
    frame,
    hollow_box,
    l_prism,
    random_polycube,
)
from minkref.fuzz.space.generators.star import star
from minkref.fuzz.space.generators.torus import torus
from minkref.fuzz.space.pair import SpacePair, Truth
from minkref.fuzz.space.prism import Prism

GROWTH = 10  # pairs after which operands grow by a step
STEPS = 6
SCALES = ("1", "1", "1", "2", "1/2", "3/2", "2/3")


def space_pair(family: str, seed: int, index: int) -> SpacePair:
    """Draws pair `index` of a family, from the arguments alone. KeyError for a family missing from
    FAMILIES."""
    dice = random.Random(f"minkref space {family} {seed} {index}")
    step = min(STEPS, index // GROWTH)
    scale = Fraction(dice.choice(SCALES)) if index >= GROWTH else Fraction(1)
    return FAMILIES[family](dice, step, scale)


def pair_of_cells(family: str, P: frozenset[Cell], Q: frozenset[Cell], scale: Scale) -> SpacePair:
    return SpacePair(surface_of(P), surface_of(Q), scale, family, Truth.CELLS, P_cells=P, Q_cells=Q)


def pair_of_prisms(family: str, P: Prism, Q: Prism, scale: Scale) -> SpacePair:
    return SpacePair(
        P.polyhedron(), Q.polyhedron(), scale, family, Truth.PRISM, P_prism=P, Q_prism=Q
    )


def _moved(dice: random.Random, cells: frozenset[Cell], most: int) -> frozenset[Cell]:
    i, j, k = (dice.randint(-most, most) for _ in range(3))
    return frozenset((x + i, y + j, z + k) for x, y, z in cells)


def _polycube(dice: random.Random, step: int, scale: Scale) -> SpacePair:
    P = random_polycube(dice, dice.randint(1, 3 + 2 * step))
    Q = random_polycube(dice, dice.randint(1, 2 + step))
    return pair_of_cells("polycube", _moved(dice, P, 2), _moved(dice, Q, 2), scale)


def _hollow(dice: random.Random, step: int, scale: Fraction) -> SpacePair:
    P = hollow_box(dice, 3 + step // 2)
    Q = _moved(dice, random_polycube(dice, dice.randint(1, 1 + step // 2)), 1)
    if dice.random() < 0.7:  # a one-cell cavity survives in the sum
        scale *= 2
    return pair_of_cells("hollow", P, Q, scale)


def _apart(dice: random.Random, step: int, scale: Fraction) -> SpacePair:
    P = bodies_apart(dice, 2 + dice.randint(0, step) // 3, 1 + step)
    Q = _moved(dice, random_polycube(dice, dice.randint(1, 2 + step // 2)), 1)
    P, Q = (Q, P) if dice.random() < 0.5 else (P, Q)
    return pair_of_cells("apart", P, Q, scale)


def _frame(dice: random.Random, step: int, scale: Scale) -> SpacePair:
    Q = random_polycube(dice, dice.randint(1, 1 + step // 2))
    return pair_of_cells("frame", frame(dice, 4 + step), _moved(dice, Q, 1), scale)


def _l_prism(dice: random.Random, step: int, scale: Scale) -> SpacePair:
    arm = dice.randint(2, 3 + step // 2)
    corner = (dice.randint(0, 10), dice.randint(0, 10), dice.randint(0, 10))
    P = l_prism(arm, dice.randint(1, arm - 1), dice.randint(1, 3), corner)
    other = dice.randint(2, 3)
    Q = dice.choice((frozenset({(0, 0, 0)}), l_prism(other, 1, dice.randint(1, 2))))
    return pair_of_cells("l-prism", P, Q, scale)


def _prism(dice: random.Random, step: int, scale: Scale) -> SpacePair:
    P = random_prism(dice, 4 + step, step // 2)
    return pair_of_prisms("prism", P, random_prism(dice, 3 + step // 2, 0), scale)


def _convex(dice: random.Random, step: int, scale: Scale) -> SpacePair:
    P = random_hull(dice, dice.randint(4, 5 + 2 * step), 3 + step)
    Q = random_hull(dice, dice.randint(4, 5 + 2 * step), 3 + step)
    return SpacePair(P, Q, scale, "convex", Truth.HULL)


def _sphere(dice: random.Random, step: int, scale: Scale) -> SpacePair:
    P = sphere(dice, dice.randint(3, 4 + 3 * step), Fraction(dice.randint(1, 4)))
    Q = sphere(dice, dice.randint(3, 4 + step), Fraction(1, dice.randint(1, 3)))
    return SpacePair(P, Q, scale, "sphere", Truth.HULL)


def _round(dice: random.Random, step: int, scale: Scale) -> SpacePair:
    P = sphere(dice, dice.randint(16, 24 + 8 * step), Fraction(dice.randint(1, 4)))
    Q = sphere(dice, dice.randint(10, 14 + 4 * step), Fraction(1, dice.randint(1, 3)))
    return SpacePair(P, Q, scale, "round", Truth.HULL)


def _thin(dice: random.Random, step: int, scale: Scale) -> SpacePair:
    """A point or a segment, often parallel to an edge or a facet of the other operand."""
    body = random_hull(dice, dice.randint(4, 5 + 2 * step), 3 + step)
    start = _lattice_point(dice, -3 - step, 3 + step)
    if dice.random() < 0.3:
        flat = Polyhedron((start,), ())
    else:
        ring = [body.vertices[k] for k in dice.choice(body.faces)]
        a, b = dice.sample(ring, 2)
        way = tuple(q - p for p, q in zip(a, b, strict=True))
        if dice.random() < 0.5:
            way = _lattice_point(dice, 1, 3 + step)
        x, y, z = (p + d for p, d in zip(start, way, strict=True))
        flat = Polyhedron((start, (x, y, z)), ())
    P, Q = (flat, body) if dice.random() < 0.5 else (body, flat)
    return SpacePair(P, Q, scale, "thin", Truth.HULL)


def _lattice_point(dice: random.Random, low: int, high: int) -> Point:
    x, y, z = (Fraction(dice.randint(low, high)) for _ in range(3))
    return (x, y, z)


def _offset(dice: random.Random, step: int, scale: Scale) -> SpacePair:
    far = 10 ** (1 + step)
    low = (Fraction(far + dice.randint(0, 9)), Fraction(far), Fraction(-far, dice.randint(1, 3)))
    P = cube(low, Fraction(dice.randint(1, 4), dice.randint(1, 3)))
    sides = [Fraction(dice.randint(1, 5)) for _ in range(3)]
    other = (Fraction(far, 7), Fraction(-far), Fraction(far + 1))
    Q = box(other, (other[0] + sides[0], other[1] + sides[1], other[2] + sides[2]))
    factors = [Fraction(dice.randint(1, 4), dice.randint(1, 4)) for _ in range(3)]
    if dice.random() < 0.5:
        scale = (factors[0], factors[1], factors[2])
    return SpacePair(P, Q, scale, "offset", Truth.HULL)


def _torus(dice: random.Random, step: int, scale: Scale) -> SpacePair:
    thickness = Fraction(dice.randint(1, 3), 3)
    P = torus(
        dice.randint(3, 4 + step // 2), dice.randint(3, 4 + step // 3), Fraction(3), thickness
    )
    side = Fraction(dice.randint(1, 12), 4)
    half = -side / 2
    return SpacePair(P, cube((half, half, half), side), scale, "torus")


def _star(dice: random.Random, step: int, scale: Scale) -> SpacePair:
    P = star(dice, 4 + step, 3)
    Q = star(dice, 3 + step // 2, 1) if dice.random() < 0.6 else random_hull(dice, 5, 2)
    return SpacePair(P, Q, scale, "star")


FAMILIES: dict[str, Callable[[random.Random, int, Fraction], SpacePair]] = {
    "polycube": _polycube,
    "hollow": _hollow,
    "apart": _apart,
    "frame": _frame,
    "l-prism": _l_prism,
    "prism": _prism,
    "convex": _convex,
    "sphere": _sphere,
    "round": _round,
    "thin": _thin,
    "offset": _offset,
    "torus": _torus,
    "star": _star,
}
