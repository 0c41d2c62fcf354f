"""The flags for cases in space: a case's facts at its first scaling decide each flag. flags.json
says what each means."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from minkref.degeneracies.plane.flags import CLOSE, at_limits, far_apart, far_out, is_no_double
from minkref.degeneracies.space.body import Body
from minkref.degeneracies.space.draft import SpaceFacts
from minkref.degeneracies.space.magnitudes import LEAST_BITS, LONG
from minkref.degeneracies.space.shapes import MANY
from minkref.degeneracies.space.vectors import crossed, direction, product, stretched
from minkref.fuzz.geometry.space import Whole


def flags_in_space(facts: SpaceFacts) -> list[str]:
    """All flags that hold, in alphabetical order. Exact."""
    return sorted(name for name, holds in FLAGS_IN_SPACE.items() if holds(facts))


def _of_a_body(holds: Callable[[Body], bool]) -> Callable[[SpaceFacts], bool]:
    return lambda facts: holds(facts.P) or holds(facts.Q)


def _all_parallel(facts: SpaceFacts) -> bool:
    here = facts.sum()
    return here.facets_on_facets == len(here.parents)


def _ties(facts: SpaceFacts) -> Iterator[bool]:
    """For each vanishing product between one body's normal and the other's edge, whether all its
    terms vanish, so that the product vanishes at every scaling."""
    for (p, q), sign in zip(facts.pairs_of_signs(), facts.signs(), strict=True):
        if sign == 0:
            first, second = facts.P.directions[p], facts.Q.directions[q]
            yield not any(a * b for a, b in zip(first, second, strict=True))


def _parallel_edges(facts: SpaceFacts) -> bool:
    of_P = {
        _either_way(direction(stretched(edge.direction, facts.scaling))) for edge in facts.P.edges
    }
    return any(_either_way(edge.direction) in of_P for edge in facts.Q.edges)


def _either_way(vector: Whole) -> Whole:
    """The same for a direction and its opposite."""
    return max(vector, (-vector[0], -vector[1], -vector[2]))


def _nearly_parallel(facts: SpaceFacts) -> bool:
    """Whether the squared tangent of an angle between facets is below 4^-LEAST_BITS, but not
    zero."""
    for n in facts.directions_of_P():
        for facet in facts.Q.facets:
            across, along = crossed(n, facet.normal), product(n, facet.normal)
            if along > 0 and 0 < product(across, across) * 4**LEAST_BITS < along**2:
                return True
    return False


def _origin_outside(facts: SpaceFacts) -> bool:
    P = facts.P
    return any(product(facet.normal, P.vertices[facet.ring[0]]) < 0 for facet in P.facets)


FLAGS_IN_SPACE: dict[str, Callable[[SpaceFacts], bool]] = {
    "all-facets-parallel": _all_parallel,
    "close-scales": lambda facts: facts.gap > CLOSE,
    "facet-along-edge": lambda facts: facts.sum().facets_on_edges > 0,
    "flat-vertices": _of_a_body(lambda body: len(body.given.vertices) > len(body.vertices)),
    "large-translation": _of_a_body(lambda body: far_out(body.vertices)),
    "limits": lambda facts: at_limits(facts.numbers),
    "magnitudes": lambda facts: far_apart((*facts.numbers, *facts.scaling)),
    "many-facets-at-a-vertex": _of_a_body(lambda body: body.degree >= MANY),
    "many-sided-facets": _of_a_body(lambda body: max(len(f.ring) for f in body.facets) >= MANY),
    "nearly-parallel-facets": _nearly_parallel,
    "opposite-facets": lambda facts: bool(facts.facet_pairs(sign=-1)),
    "origin-outside": _origin_outside,
    "overlapping-arcs": lambda facts: bool(facts.sum().parallel_edges),
    "parallel-edges": _parallel_edges,
    "parallel-facets": lambda facts: bool(facts.facet_pairs()),
    "scale-is-no-float": lambda facts: any(map(is_no_double, facts.scaling)),
    "split-facets": _of_a_body(lambda body: len(body.given.faces) > len(body.facets)),
    "thin-body": _of_a_body(
        lambda body: body.square_of_thickness * LONG**2 < body.square_of_diameter
    ),
    "tie-at-a-scaling": lambda facts: not all(_ties(facts)),
    "tie-at-every-scaling": lambda facts: any(_ties(facts)),
}
