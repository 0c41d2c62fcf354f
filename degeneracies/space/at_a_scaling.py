"""Facets and edges, parallel at one scaling but not beside it."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from minkref.degeneracies.family import NothingDrawn
from minkref.degeneracies.space.bodies import any_scaling, below, changed, hull, scattered, swapped
from minkref.degeneracies.space.coincidences import (
    facets_along_edges,
    only_here,
    parallel_edges,
    parallel_facets,
)
from minkref.degeneracies.space.draft import Coincidence, SpaceDraft, SpaceFacts, SpaceFamily
from minkref.degeneracies.space.vectors import crossed, shrunk, stretched, vector
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point

REACH = 12


def direction_pair(dice: Random) -> tuple[Point, Point, Point]:
    """Two grid vectors, and their cross product, with no zero coordinate."""
    while True:
        u, v = (vector(*(dice.randint(-5, 5) for _ in range(3))) for _ in range(2))
        normal = crossed(u, v)
        if all(normal):
            return u, v, normal


def on_top(dice: Random, top: list[Point], normal: Point, size: int) -> Polyhedron:
    """A body whose farthest face along the normal is the hull of these points, from the plane
    through the origin."""
    return hull([*top, *below(dice, normal, max(2, size // 2 - len(top)), REACH)])


def facet_pair(dice: Random, size: int) -> SpaceDraft:
    """A facet of SP and a facet of Q with the same normal."""
    u, v, normal = direction_pair(dice)
    s = any_scaling(dice)
    P = on_top(dice, in_plane(dice, u, v), normal, size)
    Q = on_top(dice, [stretched(p, s) for p in in_plane(dice, u, v)], shrunk(normal, s), size)
    return SpaceDraft(P, Q, s, dice.randrange(3))


def in_plane(dice: Random, u: Point, v: Point) -> list[Point]:
    """Three to five points spanned by two vectors, not all on a line."""
    while True:
        spots = {(dice.randint(-2, 2), dice.randint(-2, 2)) for _ in range(dice.randint(3, 5))}
        (a, b), *others = sorted(spots)
        sides = [(c - a, d - b) for c, d in others]
        if any(e * h != f * g for e, f in sides for g, h in sides):
            return [vector(*(a * x + b * y for x, y in zip(u, v, strict=True))) for a, b in spots]


def facet_and_edge(dice: Random, size: int) -> SpaceDraft:
    """A facet of SP and an edge of Q, or the other way round."""
    u, v, normal = direction_pair(dice)
    s = any_scaling(dice)
    a, b = dice.choice(((1, 0), (0, 1), (1, 1), (1, -2), (3, 1)))
    along = stretched([a * x + b * y for x, y in zip(u, v, strict=True)], s)
    edge = [vector(0, 0, 0), vector(*along)]
    P = on_top(dice, in_plane(dice, u, v), normal, size)
    Q = on_top(dice, edge, shrunk(normal, s), size)
    return swapped(dice, SpaceDraft(P, Q, s, dice.randrange(3)))


def _edge_pair(dice: Random, size: int) -> SpaceDraft:
    """An edge of SP and an edge of Q, both farthest in the same direction."""
    u, _, normal = direction_pair(dice)
    if not all(u):
        raise NothingDrawn
    s = any_scaling(dice)
    t = dice.randint(1, 3)
    P = on_top(dice, [vector(0, 0, 0), u], normal, size)
    along = stretched([t * x for x in u], s)
    Q = on_top(dice, [vector(0, 0, 0), along], shrunk(normal, s), size)
    return SpaceDraft(P, Q, s, dice.randrange(3))


def _off_the_arc(dice: Random, size: int) -> SpaceDraft:
    """Any two bodies, at a scaling at which some normal is at right angles to some edge."""
    P, Q = scattered(dice, size // 2), scattered(dice, size // 2)
    s = any_scaling(dice)
    axis = dice.randrange(3)
    try:
        roots = sorted(SpaceFacts.of(SpaceDraft(P, Q, s, axis)).roots)
    except ValueError as error:
        raise NothingDrawn from error
    usual = [root for root in roots if Fraction(1, 20) < root < 20]
    if not usual:
        raise NothingDrawn
    root = dice.choice(usual)
    x, y, z = (root if k == axis else f for k, f in enumerate(s))
    return SpaceDraft(P, Q, (x, y, z), axis)


def _facets(dice: Random, size: int) -> SpaceDraft:
    return changed(dice, facet_pair(dice, size))


def _facet_along_edge(dice: Random, size: int) -> SpaceDraft:
    return changed(dice, facet_and_edge(dice, size))


def _edges(dice: Random, size: int) -> SpaceDraft:
    return changed(dice, swapped(dice, _edge_pair(dice, size)))


def _circle(dice: Random, size: int) -> SpaceDraft:
    return changed(dice, _off_the_arc(dice, size))


def facets_meet(facts: SpaceFacts) -> list[Coincidence]:
    """At the scaling, and beside it no two facets do."""
    if any(facts.sum(at).facets_on_facets for at in facts.near):
        return []
    return only_here(facts, parallel_facets(facts.sum()))


def edge_meets_facet(facts: SpaceFacts) -> list[Coincidence]:
    """The arc of an edge runs through the normal of a facet, and no two facets are parallel."""
    if facts.sum().facets_on_facets or any(facts.sum(at).facets_on_edges for at in facts.near):
        return []
    return only_here(facts, facets_along_edges(facts.sum()))


def edges_meet(facts: SpaceFacts) -> list[Coincidence]:
    """Two arcs share a piece, and beside the scaling none do; no two facets are parallel."""
    if facts.sum().facets_on_facets or any(facts.sum(at).parallel_edges for at in facts.near):
        return []
    return only_here(facts, parallel_edges(facts.sum()))


def _nothing_meets(facts: SpaceFacts) -> list[Coincidence]:
    """A great circle runs through a normal, its arc does not: a predicate is zero, and the sum has
    the same faces as just below and just above."""
    here = facts.sum().structure
    if any(facts.sum(at).structure != here for at in facts.near):
        return []
    shown = []
    for (p, q), sign in zip(facts.pairs_of_signs(), facts.signs(), strict=True):
        if sign == 0:
            what = "edge-and-facet" if len(p) == 2 else "facet-and-edge"
            shown.append(Coincidence(what, p, q))
    return only_here(facts, shown)


FAMILIES = (
    SpaceFamily(
        "facets-parallel-at-a-scaling",
        "a facet of SP parallel to one of Q at one scaling",
        _facets,
        facets_meet,
    ),
    SpaceFamily(
        "facet-along-edge-at-a-scaling",
        "an edge of one body parallel to a facet of the other at one scaling: arcs meet in an end",
        _facet_along_edge,
        edge_meets_facet,
    ),
    SpaceFamily(
        "edges-parallel-at-a-scaling",
        "parallel edges of both bodies at one scaling: two arcs on one great circle",
        _edges,
        edges_meet,
    ),
    SpaceFamily(
        "great-circle-through-normal",
        "a great circle through a normal at one scaling, and no arc: nothing happens",
        _circle,
        _nothing_meets,
    ),
)
