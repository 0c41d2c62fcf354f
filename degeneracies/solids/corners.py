"""Where facets of the convolution meet: four in a point, three at an edge."""

from __future__ import annotations

from collections import defaultdict
from fractions import Fraction
from itertools import combinations, islice, product
from random import Random

from minkref.degeneracies.draft import NothingDrawn
from minkref.degeneracies.solids.convolution import Convolution, ConvolutionFacet
from minkref.degeneracies.solids.crossings import crossings
from minkref.degeneracies.solids.draft import Probe, SolidDraft, SolidFacts, SolidFamily
from minkref.degeneracies.solids.mesh import Mesh
from minkref.degeneracies.solids.overlaps import has_point
from minkref.degeneracies.solids.placing import under
from minkref.degeneracies.solids.proofs import sides_of
from minkref.degeneracies.solids.ties import Tie, determinant
from minkref.degeneracies.space.vectors import vector
from minkref.fuzz.geometry.space import Point, cross, dot
from minkref.fuzz.space.generators import machined
from minkref.fuzz.space.generators.any_solid import ORIGIN
from minkref.fuzz.space.generators.convex import random_hull
from minkref.fuzz.space.generators.mapped import mapped, random_matrix, unimodular
from minkref.fuzz.space.generators.tube import lattice_torus
from minkref.fuzz.space.polyhedron import Polyhedron

LEAST, MOST = Fraction(1, 2), Fraction(2)  # scales
CELL = 3  # a body of a crowd is in a cube of this side
ENOUGH = 100  # crossings of a pair that are followed
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
    """Four small bodies beside each other, whose sums with a large one run through each
    other."""
    places = dice.sample(list(product((0, 1), repeat=3)), 4)
    first, *others = (
        random_hull(dice, 4, CELL - 1).translated(vector(*(CELL * c for c in place)))
        for place in places
    )
    for other in others:
        first = first.with_faces_of(other)
    return first


def _four_facets(dice: Random, size: int) -> SolidDraft:
    """A scale at which some four facets have a point in common inside of each: a point that three
    of them have at scale 1 moves along a line, until it meets a fourth."""
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
    """At which the planes of four facets have a point in common; any three always have one."""
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
    """Fours of the facets that have the probe inside of them, and no three through one line."""
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


FAMILIES = (
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
