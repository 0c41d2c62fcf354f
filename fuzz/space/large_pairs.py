"""Seeded pairs of polyhedra of any shape with 100 to 500 triangles each, knots, gears, brackets,
tori, clutches, blocks with a cavity: some with many parallel faces, some without.

Every operand is a closed 2-manifold that does not cross itself. Q contains the origin inside.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.general_pairs import GeneralPair
from minkref.fuzz.space.generators.convex import random_hull
from minkref.fuzz.space.generators.machined import plate
from minkref.fuzz.space.generators.mapped import mapped, random_matrix
from minkref.fuzz.space.generators.placed import around_origin
from minkref.fuzz.space.generators.round import clutch, geodesic_sphere, triangulated_torus
from minkref.fuzz.space.generators.tube import knot_tube, wide_knot
from minkref.fuzz.space.generators.workshop import (
    bored_plate,
    hollow_block,
    rounded_bracket,
    spur_gear,
)

LEAST, MOST = 100, 500  # triangles of P and Q together
ONE = Fraction(1)
Drawn = tuple[Polyhedron, Polyhedron]


def large_pair(seed: int, index: int) -> GeneralPair:
    """Pair `index`, of the families in turn; depends on nothing but the arguments."""
    family = list(FAMILIES)[index % len(FAMILIES)]
    name = f"large-{family}:{seed}:{index}"
    dice = random.Random(f"minkref large {name}")
    while True:
        P, Q = FAMILIES[family](dice)
        if LEAST <= len(P.triangles) + len(Q.triangles) <= MOST:
            return GeneralPair(name, P, around_origin(Q), ONE)


def _knot_and_ball(dice: random.Random) -> Drawn:
    P = knot_tube(dice, 2, 3, dice.randint(16, 60), dice.choice((3, 4)), 1000)
    return P, geodesic_sphere(dice.choice((0, 0, 1)), dice.randint(150, 900))


def _wide_knot(dice: random.Random) -> Drawn:
    P = wide_knot(2, 3, dice.randint(24, 40), 4, 1000)
    return P, _small(dice, 300)


def _gears(dice: random.Random) -> Drawn:
    """Lids in parallel planes, no vertex moved."""
    P = spur_gear(dice.randint(8, 24), 3600, 1000, dice.choice((0, 6, 12)))
    return P, spur_gear(dice.randint(4, 9), dice.randint(400, 1600), dice.choice((400, 1000)))


def _bracket(dice: random.Random) -> Drawn:
    P = rounded_bracket(dice.randint(5, 14), dice.randint(0, 4), 120)
    if dice.random() < 0.5:
        return P, rounded_bracket(3, 0, dice.randint(12, 40))
    return P, _small(dice, dice.randint(10, 60))


def _plate(dice: random.Random) -> Drawn:
    P = bored_plate(dice.randint(1, 4), dice.randint(5, 16), 100)
    return P, dice.choice((plate(9, 9, 9), spur_gear(4, 30, 20), bored_plate(1, 6, 20)))


def _tori(dice: random.Random) -> Drawn:
    P = triangulated_torus(dice.randint(12, 24), dice.randint(3, 6), 3000, 1000)
    if dice.random() < 0.5:
        return P, triangulated_torus(dice.randint(5, 8), 3, dice.randint(500, 2500), 400)
    return P, _small(dice, 700)


def _clutch(dice: random.Random) -> Drawn:
    teeth = dice.randint(3, 8)
    P = clutch(dice, 4 * teeth, teeth, 1000, dice.choice((0, 3)))
    return P, _small(dice, dice.randint(100, 800))


def _hollow(dice: random.Random) -> Drawn:
    """A cavity that the sum keeps or loses."""
    return hollow_block(dice.choice((1, 1, 2)), 300), _small(dice, dice.randint(60, 400))


def _turned(dice: random.Random) -> Drawn:
    """A bracket and a gear under a matrix: little is parallel."""
    return rounded_bracket(6, 2, 120), mapped(random_matrix(dice, 3), spur_gear(5, 20, 12))


def _small(dice: random.Random, radius: int) -> Polyhedron:
    """A ball, a block, a gear or a hull of points of a grid."""
    kind = dice.randrange(4)
    if kind == 0:
        return geodesic_sphere(0, max(radius, 50))
    if kind == 1:
        return plate(radius, radius, radius)
    if kind == 2:
        return spur_gear(4, max(radius, 30), radius)
    return random_hull(dice, 10, max(radius, 50))


FAMILIES: dict[str, Callable[[random.Random], Drawn]] = {
    "knot": _knot_and_ball,
    "wide-knot": _wide_knot,
    "gears": _gears,
    "bracket": _bracket,
    "plate": _plate,
    "tori": _tori,
    "clutch": _clutch,
    "hollow": _hollow,
    "turned": _turned,
}
