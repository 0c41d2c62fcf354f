"""Seeded pairs of polyhedra of any shape with some 8 to 30 faces each, half of them degenerate:
exact fits, faces that are parallel or coplanar, operands that are equal or opposite. Every operand
is a closed 2-manifold that does not cross itself, with one component or two.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.cells import Cell, surface_of
from minkref.fuzz.space.generators import assembled, machined, tube
from minkref.fuzz.space.generators.any_solid import ORIGIN, any_of_one, any_solid, any_torus, walls
from minkref.fuzz.space.generators.convex import random_hull
from minkref.fuzz.space.generators.mapped import IDENTITY, Matrix, mapped, random_matrix, unimodular
from minkref.fuzz.space.generators.polycube import bodies_apart, frame, hollow_box, random_polycube

SCALES = tuple(Fraction(text) for text in ("1", "1", "1", "2", "1/2", "3/2", "2/3", "5/7"))


@dataclass(frozen=True)
class CellPair:
    """P and Q as these cells under the matrix."""

    P: frozenset[Cell]
    Q: frozenset[Cell]
    matrix: Matrix


@dataclass(frozen=True)
class GeneralPair:
    """sP + Q. `parts`: the components of P, if two."""

    name: str
    P: Polyhedron
    Q: Polyhedron
    scale: Fraction
    cells: CellPair | None = None
    parts: tuple[Polyhedron, ...] = ()


Drawn = tuple[Polyhedron, Polyhedron, Fraction]
Draw = Callable[[random.Random], Drawn]


def general_pair(seed: int, index: int) -> GeneralPair:
    """Pair `index`, of the families in turn; depends on nothing but the arguments."""
    families = list(FAMILIES) + list(OF_PARTS)
    return pair_of_family(families[index % len(families)], seed, index)


def pair_of_family(family: str, seed: int, index: int) -> GeneralPair:
    """Draws pair `index` of a family."""
    name = f"{family}:{seed}:{index}"
    dice = random.Random(f"minkref general {name}")
    if family in OF_PARTS:
        return OF_PARTS[family](dice, name)
    P, Q, scale = FAMILIES[family](dice)
    if dice.random() < 0.5:
        matrix = unimodular(dice, dice.randint(0, 2))
        P, Q = mapped(matrix, P), mapped(matrix, Q)
    return GeneralPair(name, _moved(dice, P), _moved(dice, Q), scale)


def _moved(dice: random.Random, solid: Polyhedron) -> Polyhedron:
    return solid.translated((_whole(dice, 3), _whole(dice, 3), _whole(dice, 3)))


def _whole(dice: random.Random, most: int) -> Fraction:
    return Fraction(dice.randint(-most, most))


def _mixed(dice: random.Random) -> Drawn:
    """Any two solids, one under a separate matrix: little is parallel."""
    P, Q = any_solid(dice), any_solid(dice)
    return mapped(random_matrix(dice, 2), P), Q, dice.choice(SCALES)


def _parallel(dice: random.Random) -> Drawn:
    """Any two solids, unmapped: many faces are parallel to axes."""
    return any_solid(dice), any_solid(dice), dice.choice(SCALES)


def _same(dice: random.Random) -> Drawn:
    """P + P, or P + -P."""
    P = any_solid(dice)
    return P, P.reflected(ORIGIN) if dice.random() < 0.5 else P, dice.choice(SCALES)


def _fitted(dice: random.Random, sizes: list[int]) -> tuple[Polyhedron, Fraction]:
    """A box, and the scale at which it has these sizes; sometimes a little smaller or larger along
    an axis."""
    scale = dice.choice(SCALES)
    if dice.random() < 0.25:
        sizes[dice.randrange(3)] += dice.choice((-1, 1))
    body = machined.plate(*(max(1, size) for size in sizes))
    return body.scaled(1 / scale), scale


def _slot(dice: random.Random) -> Drawn:
    """A plate as thick as the slot of a U is wide."""
    slot = dice.randint(1, 4)
    P, scale = _fitted(dice, [slot, dice.randint(1, 4), dice.randint(1, 4)])
    return P, machined.u_solid(dice, slot, 3), scale


def _ring_and_bar(dice: random.Random) -> Drawn:
    """A bar that fills a ring's hole, across one way or both."""
    width, depth = dice.randint(1, 4), dice.randint(1, 4)
    ring = machined.square_ring(width, depth, walls(dice), dice.randint(1, 3))
    other = dice.choice((depth, dice.randint(1, depth)))
    P, scale = _fitted(dice, [width, other, dice.randint(1, 6)])
    return P, ring, scale


def _cup_and_lid(dice: random.Random) -> Drawn:
    """A box that fills the pocket of a cup, or a plate that closes it: inside out, the sum has a
    cavity or a pocket."""
    width, depth, height = (dice.randint(1, 3) for _ in range(3))
    body = machined.cup(width, depth, height, walls(dice, 2), dice.randint(1, 2))
    high = dice.choice((height, 1, 2))
    P, scale = _fitted(dice, [width, depth, high])
    if dice.random() < 0.5:
        return P, body, scale
    lidded = machined.l_solid(dice, 3)
    return lidded, body, dice.choice(SCALES)


def _cavity(dice: random.Random) -> Drawn:
    """A cavity, and its filling (turned about, to fit), or a smaller body with the same form."""
    hollow, filling = assembled.hollow_box(dice, 3)
    factor = dice.choice((Fraction(1), Fraction(1, 2), Fraction(3, 4), Fraction(3, 2)))
    return filling.reflected(ORIGIN).scaled(1 / factor), hollow, factor * dice.choice((1, factor))


def _coplanar(dice: random.Random) -> Drawn:
    """Two gears, brackets or dented prisms with their lids in parallel planes."""

    def flat() -> Polyhedron:
        kind = dice.randrange(3)
        if kind == 0:
            return machined.gear(dice, dice.randint(3, 4), 10, dice.randint(1, 4))
        if kind == 1:
            return machined.bracket(dice, 1, 4)
        return machined.dented_prism(dice, dice.randint(5, 8), 5)

    return flat(), flat(), dice.choice(SCALES)


def _spikes(dice: random.Random) -> Drawn:
    """Two tetrahedra with spikes and dents; now and then over the same tetrahedron."""
    body = assembled.big_tetrahedron(dice, 2)
    other = body if dice.random() < 0.3 else assembled.big_tetrahedron(dice, 1)
    Q = assembled.spiked(dice, other, 0.5) if dice.random() < 0.6 else other
    return assembled.spiked(dice, body, 0.7), Q, dice.choice(SCALES)


def _ring_of_rings(dice: random.Random) -> Drawn:
    """A torus and a torus, or a small solid."""
    Q = any_torus(dice) if dice.random() < 0.4 else random_hull(dice, dice.randint(4, 6), 2)
    return any_torus(dice), Q, dice.choice(SCALES)


def _knot(dice: random.Random) -> Drawn:
    """A tube along a trefoil and a small convex body."""
    P = tube.knot_tube(dice, 2, 3, dice.randint(8, 10), 3, dice.choice((10, 30, 300)))
    body = random_hull(dice, 4, 2)
    return P, body.scaled(Fraction(dice.randint(1, 4))), dice.choice(SCALES)


def _thin(dice: random.Random) -> Drawn:
    """A point or a segment, along an edge, across a face or anywhere."""
    body = any_solid(dice)
    start = (_whole(dice, 3), _whole(dice, 3), _whole(dice, 3))
    way = (_whole(dice, 4), _whole(dice, 4), _whole(dice, 4))
    if dice.random() < 0.6:
        a, b = (body.vertices[k] for k in dice.sample(dice.choice(body.faces), 2))
        way = (b[0] - a[0], b[1] - a[1], b[2] - a[2])
    x, y, z = (p + d for p, d in zip(start, way, strict=True))
    ends = (start,) if way == ORIGIN or dice.random() < 0.2 else (start, (x, y, z))
    thin = Polyhedron(ends, ())
    pair = (thin, body) if dice.random() < 0.5 else (body, thin)
    return *pair, dice.choice(SCALES)


FAMILIES: dict[str, Draw] = {
    "mixed": _mixed,
    "parallel": _parallel,
    "same": _same,
    "slot": _slot,
    "ring": _ring_and_bar,
    "cup": _cup_and_lid,
    "cavity": _cavity,
    "coplanar": _coplanar,
    "spikes": _spikes,
    "tori": _ring_of_rings,
    "knot": _knot,
    "thin": _thin,
}


def _polycubes(dice: random.Random, name: str) -> GeneralPair:
    """Polycubes under one matrix."""
    kind = dice.randrange(4)
    if kind == 0:
        P = hollow_box(dice, 3)
    elif kind == 1:
        P = frame(dice, 4)
    elif kind == 2:
        P = bodies_apart(dice, 2, 3)
    else:
        P = random_polycube(dice, dice.randint(2, 7))
    Q = random_polycube(dice, dice.randint(1, 4))
    matrix = IDENTITY if dice.random() < 0.2 else random_matrix(dice, 3)
    first, second = (mapped(matrix, surface_of(body)) for body in (P, Q))
    return GeneralPair(name, first, second, dice.choice(SCALES[:7]), CellPair(P, Q, matrix))


def _apart(dice: random.Random, name: str) -> GeneralPair:
    """Two components at a distance, and a body that bridges this distance, sometimes only just."""
    axis, gap = dice.randrange(3), dice.randint(1, 3)
    one = any_of_one(dice)
    both = assembled.side_by_side(one, any_of_one(dice), axis, Fraction(gap), ORIGIN)
    scale = dice.choice(SCALES)
    sizes = [dice.randint(1, 3) for _ in range(3)]
    if dice.random() < 0.6:
        Q: Polyhedron = machined.plate(*sizes)
        factors = [Fraction(1)] * 3
        factors[axis] = scale * gap / sizes[axis]
        Q = Q.scaled((factors[0], factors[1], factors[2]))
    else:
        Q = any_solid(dice)
    count = len(one.faces)
    second = Polyhedron(both.vertices, both.faces[count:]).without_unused_vertices()
    return GeneralPair(name, both, Q, scale, parts=(one, second))


OF_PARTS: dict[str, Callable[[random.Random, str], GeneralPair]] = {
    "polycubes": _polycubes,
    "apart": _apart,
}
