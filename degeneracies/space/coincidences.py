"""Coincidences that a family looks for in a sum: faces of P and of Q whose sums form its faces."""

from __future__ import annotations

from collections.abc import Iterable

from minkref.degeneracies.space.draft import Coincidence, SpaceFacts, SumAt
from minkref.fuzz.geometry.space import Whole


def parallel_facets(at: SumAt) -> list[Coincidence]:
    """Returns the sum's facets made from two facets."""
    return [
        Coincidence("parallel-facets", p, q) for p, q in at.parents if len(p) > 2 and len(q) > 2
    ]


def facets_along_edges(at: SumAt) -> list[Coincidence]:
    """Facets of the sum made from a facet and an edge of the other body: the edge's arc runs
    through the facet's normal."""
    return [
        Coincidence("facet-and-edge" if len(q) == 2 else "edge-and-facet", p, q)
        for p, q in at.parents
        if {min(len(p), 3), min(len(q), 3)} == {2, 3}
    ]


def parallel_edges(at: SumAt) -> list[Coincidence]:
    return [Coincidence("parallel-edges", p, q) for p, q in at.parallel_edges]


def at_all(facts: SpaceFacts, shown: Iterable[Coincidence]) -> list[Coincidence]:
    """The coincidences that hold at every scaling: each of the product's three terms vanishes, or
    the two parallel features lie along an axis."""
    return [each for each in shown if _always(facts, each)]


def only_here(facts: SpaceFacts, shown: Iterable[Coincidence]) -> list[Coincidence]:
    """The coincidences that hold at no other factor along the axis: the predicate, which has one
    root there, does not vanish beside it."""
    return [
        each
        for each in shown
        if facts.value(each, facts.scaling) == 0
        and all(facts.value(each, near) != 0 for near in facts.near)
    ]


def on_one_axis(vector: Whole) -> bool:
    return sum(c != 0 for c in vector) == 1


def _always(facts: SpaceFacts, shown: Coincidence) -> bool:
    first, second = facts.P.directions[shown.P], facts.Q.directions[shown.Q]
    if shown.what in ("facet-and-edge", "edge-and-facet"):
        return all(a * b == 0 for a, b in zip(first, second, strict=True))
    return on_one_axis(first) and facts.value(shown, facts.scaling) == 0
