"""The critical regions that the paper's update finds over rational numbers, against computer
algebra: Observation 1, the solve and the interval, each as printed and in its right form."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from typing import Any

import pytest
from minkref import _core
from minkref.fuzz.plane.families.random_pairs import random_pair
from minkref.oracle.symbolic.paper_formulas import Edge, parallel, region, s_edge, t_edge
from thoroughness import draws

PAIRS = (0, 36, 1, 5, 9)[: draws(2, 5)]  # of few edges; 36 has events by all formulas
FORMS = ("printed", "corrected")
WAYS = ("printed", "least-squares", "corrected")
Regions = dict[tuple[int, int], tuple[Fraction | None, Fraction | None]]


def edges_of(P: _core.PolygonSet, Q: _core.PolygonSet) -> tuple[list[Edge], list[set[Any]]]:
    """Edges of the reduced convolution, each with the vertex pairs at its ends."""
    first, second = ([ring for rings in each.rings() for ring in rings] for each in (P, Q))
    edges, ends = [], []
    for kind, _, ring, index, other, vertex in _core.reduced_convolution(P, Q):
        own = (first if kind == "S" else second)[ring]
        there = (second if kind == "S" else first)[other][vertex]
        following = (index + 1) % len(own)
        make = s_edge if kind == "S" else t_edge
        edges.append(make(own[index], own[following], there))
        named = [((ring, k), (other, vertex)) for k in (index, following)]
        ends.append({pair if kind == "S" else pair[::-1] for pair in named})
    return edges, ends


def regions_of(update: _core.PaperUpdate) -> Regions:
    """The regions according to the event array."""
    found: dict[tuple[int, int], list[Fraction | None]] = {}
    for scale, a, b, begins in update.events():
        found.setdefault((a, b), [None, None])[0 if begins else 1] = Fraction(scale)
    return {pair: (low, high) for pair, (low, high) in found.items()}


@pytest.mark.parametrize(("observation", "solve", "interval"), list(product(FORMS, WAYS, FORMS)))
def test_regions_of_pairs(observation: str, solve: str, interval: str) -> None:
    seen = 0
    for index in PAIRS:
        pair = random_pair(8, index)
        P, Q = (_core.PolygonSet.from_json(text) for text in (pair.P, pair.Q))
        edges, ends = edges_of(P, Q)
        readings = {"observation": observation, "solve": solve, "interval": interval}
        found = regions_of(_core.PaperUpdate(P, Q, "1", "rational", readings))
        for b, second in enumerate(edges):
            for a, first in enumerate(edges[:b]):
                if parallel(first, second) or ends[a] & ends[b]:
                    assert (a, b) not in found
                    continue
                bounds = region(first, second, observation, solve, interval)
                expected = bounds and tuple(
                    None if bound is None else Fraction(int(bound.p), int(bound.q))
                    for bound in bounds
                )
                if expected == (None, None):  # they always meet: no event
                    expected = None
                assert found.get((a, b)) == expected, (index, a, b)
                seen += expected is not None
    assert seen > 0
