"""Facets and edges that are parallel at every scaling: along axes, the scaling changes nothing."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

from minkref.degeneracies.space.bodies import (
    any_scaling,
    box,
    changed,
    far_scalings,
    frustum,
    polygon,
    prism,
    roof,
    swapped,
)
from minkref.degeneracies.space.coincidences import (
    at_all,
    facets_along_edges,
    parallel_edges,
    parallel_facets,
)
from minkref.degeneracies.space.draft import Coincidence, SpaceDraft, SpaceFacts, SpaceFamily, SumAt
from minkref.fuzz.geometry.polyhedron import Polyhedron

DIRECTIONS = ((1, 0), (0, 1), (1, 1), (2, -1), (1, 3))


def _box(dice: Random) -> Polyhedron:
    return box(*(dice.randint(1, 9) for _ in range(3)))


def _upright(dice: Random, size: int) -> Polyhedron:
    """With a facet on top."""
    corners = max(3, size // 4)
    kind = dice.randrange(3)
    if kind == 0:
        return _box(dice)
    ring = polygon(dice, corners)
    return prism(ring, dice.randint(1, 9)) if kind == 1 else frustum(dice, ring)


def _draft(dice: Random, P: Polyhedron, Q: Polyhedron) -> SpaceDraft:
    draft = SpaceDraft(P, Q, any_scaling(dice), dice.randrange(3), far_scalings(dice))
    return changed(dice, swapped(dice, draft))


def _facets(dice: Random, size: int) -> SpaceDraft:
    return _draft(dice, _upright(dice, size), _upright(dice, size))


def _facet_and_edge(dice: Random, size: int) -> SpaceDraft:
    """A facet on top and a ridge; or a prism and a box, which has an edge along the prism's."""
    if dice.random() < 0.5:
        Q = roof(dice, polygon(dice, max(3, size // 3)), dice.choice(DIRECTIONS))
        return _draft(dice, _upright(dice, size), Q)
    return _draft(dice, prism(polygon(dice, max(4, size // 4)), dice.randint(1, 9)), _box(dice))


def _edges(dice: Random, size: int) -> SpaceDraft:
    """Two ridges along one axis."""
    P, Q = (roof(dice, polygon(dice, max(3, size // 3)), (1, 0)) for _ in range(2))
    return _draft(dice, P, Q)


def _everywhere(
    found_at: Callable[[SumAt], list[Coincidence]],
) -> Callable[[SpaceFacts], list[Coincidence]]:
    """A proof from coincidences at every scaling that belong to the sum at each scaling of the
    case."""

    def proof(facts: SpaceFacts) -> list[Coincidence]:
        shown = at_all(facts, found_at(facts.sum()))
        for at in facts.scalings:
            here = set(found_at(facts.sum(at)))
            shown = [each for each in shown if each in here]
        return shown

    return proof


def _edges_alone(facts: SpaceFacts) -> list[Coincidence]:
    """And not the edges of parallel facets."""
    lying = {facet.ring for facet, _ in facts.facet_pairs()}
    shown = _everywhere(parallel_edges)(facts)
    return [each for each in shown if not any(set(each.P) <= set(ring) for ring in lying)]


FAMILIES = (
    SpaceFamily(
        "facets-parallel-always",
        "facets of both bodies that are parallel at every scaling",
        _facets,
        _everywhere(parallel_facets),
    ),
    SpaceFamily(
        "facet-along-edge-always",
        "a facet of one body parallel to an edge of the other at every scaling",
        _facet_and_edge,
        _everywhere(facets_along_edges),
    ),
    SpaceFamily(
        "edges-parallel-always",
        "parallel edges of both bodies at every scaling: two arcs on one great circle",
        _edges,
        _edges_alone,
    ),
)
