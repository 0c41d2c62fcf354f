"""Tools of the generators in space: exact convex bodies, and changes that keep degeneracies:
axes in another order or turned round, factors along the axes, translations."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import permutations, product
from random import Random

from minkref.degeneracies.family import NothingDrawn
from minkref.degeneracies.space.draft import SpaceDraft
from minkref.degeneracies.space.vectors import inverse, moved, stretched, vector
from minkref.degeneracies.space.vectors import product as dotted
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.plane.families.drawing import convex
from minkref.fuzz.space.hull import convex_hull

FACTORS = tuple(Fraction(n, d) for n, d in ((1, 1), (1, 1), (2, 1), (1, 3), (7, 5), (3, 4), (5, 1)))
FAR_SCALINGS = tuple(
    Fraction(n, d) for n, d in ((1, 1000), (1, 7), (1, 2), (3, 1), (22, 7), (900, 1))
)
Map = Callable[[Point], Point]


def hull(points: Iterable[Sequence[Fraction | int]]) -> Polyhedron:
    try:
        return convex_hull(vector(*point) for point in points)
    except ValueError as error:
        raise NothingDrawn from error


def box(*sides: Fraction | int) -> Polyhedron:
    return hull(product(*((0, side) for side in sides)))


def polygon(dice: Random, corners: int) -> list[tuple[int, int]]:
    """Convex, on a grid, of up to so many corners."""
    return [(int(x), int(y)) for x, y in convex(dice, corners, 4 + 3 * corners)]


def prism(ring: Sequence[tuple[int, int]], height: Fraction | int) -> Polyhedron:
    return hull((x, y, z) for x, y in ring for z in (0, height))


def pyramid(dice: Random, ring: Sequence[tuple[int, int]]) -> Polyhedron:
    """The apex is above a point inside the base."""
    count = len(ring)
    x, y = (Fraction(sum(p[k] for p in ring), count) for k in (0, 1))
    return hull([*((*p, 0) for p in ring), (x, y, dice.randint(2, 20))])


def frustum(dice: Random, ring: Sequence[tuple[int, int]]) -> Polyhedron:
    """The body between a polygon and a smaller similar polygon above."""
    t, height = Fraction(1, dice.randint(2, 4)), dice.randint(2, 12)
    dx, dy = dice.randint(0, 4), dice.randint(0, 4)
    return hull([*((*p, 0) for p in ring), *((t * x + dx, t * y + dy, height) for x, y in ring)])


def roof(dice: Random, ring: Sequence[tuple[int, int]], along: tuple[int, int]) -> Polyhedron:
    """Over a polygon, with a level ridge."""
    x, y = (dice.randint(-3, 9) for _ in range(2))
    height, length = dice.randint(3, 12), dice.randint(1, 3)
    ridge = ((x, y, height), (x + length * along[0], y + length * along[1], height))
    return hull([*((*p, 0) for p in ring), *ridge])


def scattered(dice: Random, count: int, reach: int = 12) -> Polyhedron:
    """The hull of grid points."""
    return hull(lattice_point(dice, reach) for _ in range(max(4, count)))


def lattice_point(dice: Random, reach: int) -> tuple[int, int, int]:
    x, y, z = (dice.randint(-reach, reach) for _ in range(3))
    return x, y, z


def below(dice: Random, normal: Sequence[Fraction | int], count: int, reach: int) -> list[Point]:
    """Points of a grid strictly below the plane through the origin with this normal."""
    found: list[Point] = []
    while len(found) < count:
        point = vector(*lattice_point(dice, reach))
        height = dotted(normal, point)
        if height:
            x, y, z = point
            found.append(point if height < 0 else (-x, -y, -z))
    return found


def mapped(body: Polyhedron, change: Map) -> Polyhedron:
    """Applies an affine map, which may turn the body inside out."""
    result = Polyhedron(tuple(change(v) for v in body.vertices), body.faces)
    return result if result.volume > 0 else result.turned_inside_out()


def placed(body: Polyhedron, by: Iterable[Fraction | int]) -> Polyhedron:
    return Polyhedron(tuple(moved(body.vertices, by)), body.faces)


def larger(body: Polyhedron, factors: Point) -> Polyhedron:
    return mapped(body, lambda v: stretched(v, factors))


def reflected(body: Polyhedron) -> Polyhedron:
    return body.reflected(vector(0, 0, 0))


def factors(dice: Random) -> Point:
    """Not all the same, mostly."""
    x, y, z = (dice.choice(FACTORS) for _ in range(3))
    return x, y, z


def any_scaling(dice: Random) -> Point:
    """A scaling by moderate factors, all different."""
    while True:
        x, y, z = (Fraction(dice.randint(1, 9), dice.randint(1, 5)) for _ in range(3))
        if x != y != z != x:
            return x, y, z


def far_scalings(dice: Random) -> tuple[Point, ...]:
    """Scalings without much in common."""
    found = []
    for _ in range(3):
        x, y, z = dice.sample(FAR_SCALINGS, 3)
        found.append((x, y, z))
    return tuple(found)


def turned(dice: Random) -> tuple[Map, tuple[int, int, int]]:
    """Returns a map that permutes axes and turns some round; and the original axis for each new
    axis."""
    a, b, c = dice.choice(list(permutations(range(3))))
    signs = [dice.choice((1, -1)) for _ in range(3)]

    def change(v: Point) -> Point:
        return signs[0] * v[a], signs[1] * v[b], signs[2] * v[c]

    return change, (a, b, c)


def changed(dice: Random, draft: SpaceDraft, far: int = 12, stretch: bool = True) -> SpaceDraft:
    """Changes coordinates, keeping the signs of all predicates. Both bodies are turned in one way
    and moved apart; `stretch`: along each axis both change their size, and P and the scalings
    change size inversely."""
    turn, (a, b, c) = turned(dice)
    both = factors(dice) if stretch else (Fraction(1),) * 3
    first = factors(dice) if stretch else (dice.choice(FACTORS),) * 3

    def scaling(s: Point) -> Point:
        return stretched((s[a], s[b], s[c]), first)

    P, Q = (larger(mapped(body, turn), both) for body in (draft.P, draft.Q))
    P = larger(P, inverse(first))
    P, Q = (placed(body, lattice_point(dice, far)) for body in (P, Q))
    return replace(
        draft,
        P=P,
        Q=Q,
        scaling=scaling(draft.scaling),
        axis=(a, b, c).index(draft.axis),
        others=tuple(scaling(s) for s in draft.others),
    )


def swapped(dice: Random, draft: SpaceDraft) -> SpaceDraft:
    """P and Q perhaps in each other's place: with Q scaled by S^-1 the sum is S^-1 (S P + Q)."""
    if dice.random() < 0.5:
        return draft
    others = tuple(inverse(s) for s in draft.others)
    return replace(draft, P=draft.Q, Q=draft.P, scaling=inverse(draft.scaling), others=others)


def orbit(points: Iterable[Point], mirrored: bool) -> set[Point]:
    """Images under the rotations of the tetrahedron: cyclic permutations of axes, with two turned
    round; `mirrored`: under all symmetries of the cube."""
    found = set()
    for point in points:
        for order in permutations(range(3)) if mirrored else ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
            for signs in product((1, -1), repeat=3):
                if mirrored or signs.count(-1) % 2 == 0:
                    x, y, z = (s * point[k] for s, k in zip(signs, order, strict=True))
                    found.add((x, y, z))
    return found
