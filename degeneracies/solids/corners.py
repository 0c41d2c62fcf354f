"""Places where facets of the convolution meet: four at a point, three at an edge, two coplanar at
one scale."""

from __future__ import annotations

from collections import defaultdict
from fractions import Fraction
from itertools import combinations, islice, product
from random import Random

from minkref.degeneracies.family import NothingDrawn
from minkref.degeneracies.solids.convolution import Convolution, ConvolutionFacet
from minkref.degeneracies.solids.crossings import crossings
from minkref.degeneracies.solids.draft import Probe, SolidDraft, SolidFacts, SolidFamily
from minkref.degeneracies.solids.mesh import Mesh
from minkref.degeneracies.solids.overlaps import has_point, share_area
from minkref.degeneracies.solids.placing import placed, under
from minkref.degeneracies.solids.proofs import faces_alone, sides_of
from minkref.degeneracies.solids.ties import Tie, determinant
from minkref.degeneracies.space.vectors import vector
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, cross, dot
from minkref.fuzz.space.generators import machined
from minkref.fuzz.space.generators.any_solid import ORIGIN
from minkref.fuzz.space.generators.convex import random_hull
from minkref.fuzz.space.generators.mapped import mapped, random_matrix, unimodular
from minkref.fuzz.space.generators.tube import lattice_torus
from minkref.fuzz.space.hull import convex_hull

LEAST, MOST = Fraction(1, 2), Fraction(2)  # scales
CELL = 3  # the side of a cube that holds one body of a crowd
ENOUGH = 100  # crossings followed per pair
LONGEST = 2**26  # numerators and denominators of a scale


def _general(dice: Random) -> Polyhedron:
    """Not convex, and nothing about it parallel to anything else."""
    kind = dice.randrange(3)
    if kind == 0:
        return mapped(random_matrix(dice, 2), machined.l_solid(dice, 3))
    if kind == 1:
        return lattice_torus(3, 3, dice.randint(2, 3))
    return mapped(random_matrix(dice, 2), machined.u_solid(dice, 1, 2))


def _moved(dice: Random, draft: SolidDraft) -> SolidDraft:
    first, second = (vector(*(dice.randint(-3, 3) for _ in range(3))) for _ in range(2))
    return under(draft, unimodular(dice, 0), first, second)


def _crowd(dice: Random) -> Polyhedron:
    """Four small bodies beside each other; their sums with a large body run through each other."""
    places = dice.sample(list(product((0, 1), repeat=3)), 4)
    first, *others = (
        random_hull(dice, 4, CELL - 1).translated(vector(*(CELL * c for c in place)))
        for place in places
    )
    for other in others:
        first = first.with_faces_of(other)
    return first


def _four_facets(dice: Random, size: int) -> SolidDraft:
    """Finds a scale at which four facets have a common inner point: a common point of three facets
    at scale 1 moves along a line, until it meets a fourth facet."""
    P, Q = _crowd(dice), random_hull(dice, dice.randint(4, 5), 4 * CELL)
    convolution = Convolution(Mesh(P), Mesh(Q))
    facets = list(convolution.facets)
    dice.shuffle(facets)
    for three in islice(crossings(convolution, facets), ENOUGH):
        for fourth in facets:
            four = [*three, fourth]
            s = None if fourth in three else _scale_of(four)
            if s is not None:
                x = _point_of(four[:3], s)
                if all(has_point(convolution, f, x, s, inside=True) for f in four):
                    return _moved(dice, SolidDraft(P, Q, s, (Probe(ORIGIN, x),)))
    raise NothingDrawn


def _scale_of(four: list[ConvolutionFacet]) -> Fraction | None:
    """The scale at which the planes of four facets have a common point, if any three planes always
    do."""
    for three in combinations(four, 3):
        a, b, c = (f.normal for f in three)
        if dot(a, cross(b, c)) == 0:
            return None
    growing, still = (determinant([(*f.normal, f.level[power]) for f in four]) for power in (0, 1))
    if growing == 0 or still == 0:
        return None
    s = -still / growing
    return s if LEAST < s < MOST and max(s.numerator, s.denominator) < LONGEST else None


def _point_of(three: list[ConvolutionFacet], s: Fraction) -> Point:
    """By Cramer's rule."""
    a, b, c = (f.normal for f in three)
    whole = dot(a, cross(b, c))
    parts = (cross(b, c), cross(c, a), cross(a, b))
    x, y, z = (
        sum((f.offset(s) * part[k] for f, part in zip(three, parts, strict=True)), Fraction(0))
        / whole
        for k in range(3)
    )
    return x, y, z


def _in_one_point(facts: SolidFacts) -> list[Tie]:
    """Groups of four facets around the probe, as an inner point of each, with no three through one
    line."""
    s, convolution = facts.scale, facts.convolution
    x = facts.probes[0].at(s)
    here = [
        f
        for f in convolution.facets
        if f.is_level_with(x, s) and has_point(convolution, f, x, s, inside=True)
    ]
    return [
        Tie("one-point", tuple(f.feature for f in four))
        for four in combinations(here, 4)
        if _scale_of(list(four)) == s
    ]


def _saddles(dice: Random, size: int) -> SolidDraft:
    return _moved(dice, SolidDraft(_general(dice), _general(dice), Fraction(1)))


def _three_at_a_side(facts: SolidFacts) -> list[Tie]:
    at = defaultdict(list)
    for facet in facts.convolution.strict.values():
        for side in sides_of(facet):
            at[side].append(facet.feature)
    return [
        Tie("three-facets", (side, *found)) for side, found in sorted(at.items()) if len(found) > 2
    ]


def _crossed(dice: Random, size: int) -> SolidDraft:
    """Each operand has a long triangle on top of one body and the top of another: the triangles, at
    right angles, come to lie in one plane, and then cross."""
    first, second = (_long_triangle(dice, turned) for turned in (False, True))
    tops = [(dice.randint(30, 40), dice.randint(-5, 5), dice.randint(-3, 3)) for _ in range(2)]
    p, v = tops
    height = dice.choice([z for z in range(-3, 4) if z != p[2]])
    P = _with_a_top(dice, [(x, y, height) for x, y in first], p)
    shift = (v[0] - p[0], v[1] - p[1])
    corners = [(x + shift[0], y + shift[1], height + v[2] - p[2]) for x, y in second]
    return placed(dice, SolidDraft(P, _with_a_top(dice, corners, v)))


def _long_triangle(dice: Random, turned: bool) -> list[tuple[int, int]]:
    """Around the origin, counter-clockwise."""
    long, wide = dice.randint(6, 12), dice.randint(1, 2)
    corners = [(-long, dice.randint(-1, 1)), (long, -wide), (long, wide)]
    return [(-y, x) for x, y in corners] if turned else corners


def _with_a_top(
    dice: Random, triangle: list[tuple[int, int, int]], top: tuple[int, int, int]
) -> Polyhedron:
    """A body under a level triangle, and another one under a point."""
    low = min(z for _, _, z in triangle) - dice.randint(1, 4)
    x, y, z = top
    base = [(x - 2, y - 1, z - 2), (x + 2, y - 2, z - 2), (x, y + 2, z - 3)]
    bodies = [
        convex_hull(vector(*corner) for corner in corners)
        for corners in ([*triangle, (0, 0, low)], [*base, top])
    ]
    return bodies[0].with_faces_of(bodies[1])


def _crossed_without_corners(facts: SolidFacts) -> list[Tie]:
    """Pairs of facets in one plane at the scale alone, with a common area, although neither has a
    corner of the other."""
    s, convolution = facts.scale, facts.convolution
    at = defaultdict(list)
    for facet in faces_alone(facts):
        at[facet.normal, facet.offset(s)].append(facet)

    def apart(one: ConvolutionFacet, other: ConvolutionFacet) -> bool:
        corners = convolution.corners(one, s)
        return not any(has_point(convolution, other, x, s) for x in corners)

    return [
        Tie("coplanar", (one.feature, other.feature))
        for group in at.values()
        for one, other in combinations(group, 2)
        if one.level != other.level
        and share_area(convolution, one, other, s)
        and apart(one, other)
        and apart(other, one)
    ]


FAMILIES = (
    SolidFamily(
        "solids-crossed-facets",
        "parallel facets that come to lie in one plane, and cross there without a corner",
        _crossed,
        _crossed_without_corners,
    ),
    SolidFamily(
        "solids-four-facets",
        "four facets through one point at one scale, inside of each",
        _four_facets,
        _in_one_point,
    ),
    SolidFamily(
        "solids-saddles",
        "edges of the convolution with three facets, at saddles",
        _saddles,
        _three_at_a_side,
    ),
)
