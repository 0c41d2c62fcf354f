"""Single solids of any kind, with small integer coordinates."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.generators import assembled, machined
from minkref.fuzz.space.generators.convex import random_hull
from minkref.fuzz.space.generators.tube import lattice_torus

ORIGIN: Point = (Fraction(0), Fraction(0), Fraction(0))


def walls(dice: random.Random, most: int = 3) -> tuple[int, int, int, int]:
    return (
        dice.randint(1, most),
        dice.randint(1, most),
        dice.randint(1, most),
        dice.randint(1, most),
    )


def any_solid(dice: random.Random) -> Polyhedron:
    """A solid of any kind; small integers."""
    return dice.choice(SOLIDS)(dice)


def _square_ring(dice: random.Random) -> Polyhedron:
    return machined.square_ring(
        dice.randint(1, 4), dice.randint(1, 4), walls(dice), dice.randint(1, 3)
    )


def _cup(dice: random.Random) -> Polyhedron:
    width, depth, height = (dice.randint(1, 3) for _ in range(3))
    return machined.cup(width, depth, height, walls(dice, 2), dice.randint(1, 2))


def _spiked(dice: random.Random) -> Polyhedron:
    return assembled.spiked(dice, assembled.big_tetrahedron(dice, 2), 0.6)


def any_torus(dice: random.Random) -> Polyhedron:
    return lattice_torus(dice.randint(3, 6), dice.choice((3, 4)), dice.randint(2, 4))


def _two(dice: random.Random) -> Polyhedron:
    one, other = machined.l_solid(dice, 3), random_hull(dice, 4, 3)
    gap = Fraction(dice.randint(1, 3))
    return assembled.side_by_side(one, other, dice.randrange(3), gap, ORIGIN)


SOLIDS: tuple[Callable[[random.Random], Polyhedron], ...] = (
    lambda dice: machined.l_solid(dice, 5),
    lambda dice: machined.u_solid(dice, dice.randint(1, 4), 3),
    lambda dice: machined.dented_prism(dice, dice.randint(5, 9), 6),
    _square_ring,
    _cup,
    lambda dice: assembled.hollow_box(dice, 3)[0],
    lambda dice: machined.bracket(dice, dice.randint(1, 2), 4),
    lambda dice: machined.gear(dice, dice.randint(3, 5), 10, dice.randint(1, 6)),
    _spiked,
    any_torus,
    _two,
    lambda dice: random_hull(dice, dice.randint(4, 8), 4),
)


def any_of_one(dice: random.Random) -> Polyhedron:
    """A solid with one component, without cavities."""
    return dice.choice((SOLIDS[0], SOLIDS[1], SOLIDS[3], SOLIDS[9], SOLIDS[11]))(dice)
